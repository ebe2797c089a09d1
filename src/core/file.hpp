// SPDX-License-Identifier: MIT
// Whole files in and out. A file that is written exists whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pantin {

// The bytes of a regular file of at most `limit` bytes. Error(input) names the file and the fact.
std::vector<unsigned char> read_file(const std::filesystem::path& file,
                                     std::size_t limit = std::size_t{1} << 30);
std::string read_text(const std::filesystem::path& file, std::size_t limit = std::size_t{1} << 28);

// Writes to a temporary name in the same folder and renames. Error(output) names the file; nothing is left
// behind.
void write_file(const std::filesystem::path& file, std::span<const unsigned char> bytes);
void write_file(const std::filesystem::path& file, std::string_view text);

// Creates the folder and its parents; one that exists is fine. Error(output) otherwise.
void create_folder(const std::filesystem::path& folder);

} // namespace pantin
