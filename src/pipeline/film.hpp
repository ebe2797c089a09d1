// SPDX-License-Identifier: MIT
// Frames as film files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "export/film_formats.hpp"
#include "pantin/settings.hpp"

namespace pantin {

// One loop of frames and their rate.
struct Film {
    std::vector<RgbaImage> frames;
    double fps = 25;
};

// Whether a format is asked for; without any it is what the table writes of every clip, or of the `first`.
bool wants(const RenderRequest& request, const FilmFormat& format, bool first);
bool wants_pictures(const RenderRequest& request); // not motions alone

// An empty film for a loop of `duration` seconds: a whole number of frames that fills it, at about the wanted
// rate.
Film blank_film(double duration, double fps);

// The clip as frames, at the size and rate of `settings.render`. Frames do not depend on each other, so
// threads share them out.
Film render_film(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture, const View& view,
                 const Settings& settings);

// Writes folder/<stem>.webp and so on in the formats that the settings want; PNG frames go to
// `frames_folder`. Threads share out the frames of each.
void write_film(const Film& film, const std::filesystem::path& folder, const std::string& stem,
                const std::filesystem::path& frames_folder, const Settings& settings, bool first);

// Writes folder/<stem>.bvh and so on in the wanted formats that have no pictures.
void write_motions(const Rig& rig, const BoneAnimation& animation, const std::filesystem::path& folder,
                   const std::string& stem, const RenderRequest& request, bool first);

} // namespace pantin
