// SPDX-License-Identifier: MIT
#include "pipeline/film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/file.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/network.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

void write_frames(const fs::path& folder, const std::vector<RgbaImage>& frames) {
    create_folder(folder);
    char name[32];
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::snprintf(name, sizeof name, "%04zu.png", i + 1);
        save_png(folder / name, frames[i]);
    }
    // Frames of a longer clip that was written here before would be shown after these.
    std::error_code ignored;
    for (std::size_t i = frames.size() + 1;; ++i) {
        std::snprintf(name, sizeof name, "%04zu.png", i);
        if (!fs::remove(folder / name, ignored)) break;
    }
}

} // namespace

bool wants(const RenderRequest& request, const std::string& format, bool first) {
    if (!request.formats.empty())
        return std::find(request.formats.begin(), request.formats.end(), format) != request.formats.end();
    if (format == "webp" || format == "apng") return webp_available() == (format == "webp");
    return format == "gif" && first && gif_available();
}

bool wants_pictures(const RenderRequest& request) {
    return request.formats.empty() || std::any_of(request.formats.begin(), request.formats.end(),
                                                  [](const std::string& format) { return format != "bvh"; });
}

Film blank_film(double duration, double fps) {
    Film film;
    film.frames.resize(static_cast<std::size_t>(std::max(1.0, std::rint(duration * fps))));
    film.fps = static_cast<double>(film.frames.size()) / duration;
    return film;
}

Film shoot(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture, const View& view,
           const Settings& settings) {
    Film film = blank_film(animation.duration, settings.render.fps);
    const FrameRenderer renderer(rig, texture, view, settings.render.picture);
    const network::Runtime runtime(settings.threads);
    runtime.parallel_for(static_cast<int>(film.frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        const double time =
            animation.duration * static_cast<double>(i) / static_cast<double>(film.frames.size());
        film.frames[i] = renderer(skin(rig, animation, time));
    });
    return film;
}

void write_film(const Film& film, const fs::path& folder, const std::string& stem,
                const fs::path& frames_folder, const RenderRequest& request, bool first) {
    const auto file = [&](const char* ending) { return folder / (stem + ending); };
    if (wants(request, "webp", first)) write_file(file(".webp"), encode_webp(film.frames, film.fps));
    if (wants(request, "gif", first)) write_file(file(".gif"), encode_gif(film.frames, film.fps));
    if (wants(request, "apng", first)) write_file(file(".apng"), encode_apng(film.frames, film.fps));
    if (wants(request, "mp4", first)) write_mp4(file(".mp4"), film.frames, film.fps);
    if (wants(request, "png", first)) write_frames(frames_folder, film.frames);
}

} // namespace pantin
