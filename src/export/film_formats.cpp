// SPDX-License-Identifier: MIT
// The table of film formats, and the writers that are no more than an encoder and a file.
#include "export/film_formats.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

#include "core/file.hpp"
#include "core/thread_pool.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/motion.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

using Frames = std::vector<RgbaImage>;
using Encoder = std::vector<unsigned char>(const Frames& frames, double fps, int threads);

template <Encoder encode>
void write_encoded(const fs::path& file, const Frames& frames, double fps, std::optional<int>, int threads) {
    write_file(file, encode(frames, fps, threads));
}
void write_webp(const fs::path& file, const Frames& frames, double fps, std::optional<int> quality,
                int threads) {
    write_file(file, encode_webp(frames, fps, quality, threads));
}

void write_film_as_mp4(const fs::path& file, const Frames& frames, double fps, std::optional<int>, int) {
    write_mp4(file, frames, fps);
}

// folder/0001.png, 0002.png, …
void write_frames(const fs::path& folder, const Frames& frames, double, std::optional<int>, int threads) {
    create_folder(folder);
    const auto file = [&](std::size_t number) {
        char name[32];
        std::snprintf(name, sizeof name, "%04zu.png", number);
        return folder / name;
    };
    parallel_for(threads, static_cast<int>(frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        save_png(file(i + 1), frames[i]);
    });
    // Frames of a longer clip that was written here before would be shown after these.
    std::error_code ignored;
    for (std::size_t i = frames.size() + 1; fs::remove(file(i), ignored); ++i) {
    }
}

constexpr auto never = FilmFormat::Default::never, first_clip = FilmFormat::Default::first_clip,
               every_clip = FilmFormat::Default::every_clip;

constexpr std::array formats = {
    FilmFormat{"webp", ".webp", every_clip, write_webp, nullptr, webp_available,
               "this pantin was built without WebP (make WEBP=1)"},
    FilmFormat{"gif", ".gif", first_clip, write_encoded<encode_gif>, nullptr, gif_available,
               "this pantin was built without GIF (make GIF=1)"},
    FilmFormat{"apng", ".apng", FilmFormat::Default::fallback, write_encoded<encode_apng>},
    FilmFormat{"mp4", ".mp4", never, write_film_as_mp4, nullptr, mp4_available,
               "there is no ffmpeg on this machine (Debian: apt-get install ffmpeg)"},
    FilmFormat{"png", "", never, write_frames},
    FilmFormat{"bvh", ".bvh", never, nullptr, to_bvh},
};

} // namespace

std::span<const FilmFormat> film_formats() { return formats; }

const FilmFormat* film_format(std::string_view name) {
    const auto found =
        std::find_if(formats.begin(), formats.end(), [&](const FilmFormat& f) { return f.name == name; });
    return found == formats.end() ? nullptr : &*found;
}

bool is_available(const FilmFormat& format) { return !format.available || format.available(); }

std::string film_format_names(std::string_view last) {
    std::string text;
    for (const FilmFormat& format : formats) {
        if (!text.empty()) text += &format == &formats.back() ? last : ", ";
        text += format.name;
    }
    return text;
}

} // namespace pantin
