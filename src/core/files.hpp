// Whole files in and out. What is written exists whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace pantin {

inline constexpr std::size_t max_input_bytes = std::size_t{1} << 30;

// The bytes of a regular file of at most max_input_bytes. Throws Error(input) naming the file and what is
// wrong.
std::vector<unsigned char> read_file(const std::filesystem::path& file);

// Writes to `<file>.tmp` in the same folder and renames. Throws Error(output) naming the file; nothing is
// left behind then.
void write_file(const std::filesystem::path& file, std::span<const unsigned char> bytes);

} // namespace pantin
