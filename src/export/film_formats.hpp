// SPDX-License-Identifier: MIT
// What `render` can write of a clip: one table for the command line, the writer and the clearing of former
// runs. A new format is a file of its own and a row.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

struct FilmFormat {
    // `fallback`: every clip, where no other format of every clip is available.
    enum class Default { never, first_clip, every_clip, fallback };

    std::string_view name;            // of `--format`
    std::string_view ending;          // of the file, with its dot; empty: a folder of frames
    Default written = Default::never; // without `--format`, where available
    // One of the two. `film`: one loop of frames at `fps` frames a second into the file or folder; `quality`,
    // where the format has one: 0 to 100, none: lossless. The bytes do not depend on `threads`.
    // Error(output): cannot be written.
    void (*film)(const std::filesystem::path& path, const std::vector<RgbaImage>& frames, double fps,
                 std::optional<int> quality, int threads) = nullptr;
    // `motion`: the text of a file that has no pictures.
    std::string (*motion)(const Rig& rig, const BoneAnimation& animation) = nullptr;
    bool (*available)() = nullptr; // nullptr: in every build
    std::string_view missing = {}; // one line for when it is not available
};

// All formats, in the order in which messages list them. No error.
std::span<const FilmFormat> film_formats();

// The format of that name, or nullptr. No error.
const FilmFormat* film_format(std::string_view name);

// Whether this build on this machine can write the format. No error.
bool is_available(const FilmFormat& format);

// The names with commas, the last after `last`: "webp, gif … or bvh". No error.
std::string film_format_names(std::string_view last = ", ");

} // namespace pantin
