// SPDX-License-Identifier: MIT
// A rig and a clip to frames, and frames to files of the wanted formats (thesis 6.1).
#include "pipeline/film.hpp"

#include <algorithm>
#include <cmath>

#include "core/file.hpp"
#include "core/thread_pool.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

bool every_clip_available() {
    return std::ranges::any_of(film_formats(), [](const FilmFormat& f) {
        return f.written == FilmFormat::Default::every_clip && is_available(f);
    });
}

} // namespace

bool wants(const RenderRequest& request, const FilmFormat& format, bool first) {
    if (!request.formats.empty())
        return std::find(request.formats.begin(), request.formats.end(), format.name) !=
               request.formats.end();
    if (!is_available(format)) return false;
    switch (format.written) {
    case FilmFormat::Default::never:
        return false;
    case FilmFormat::Default::first_clip:
        return first;
    case FilmFormat::Default::every_clip:
        return true;
    case FilmFormat::Default::fallback:
        return !every_clip_available();
    }
    return false;
}

bool wants_pictures(const RenderRequest& request) {
    const std::span<const FilmFormat> formats = film_formats();
    return request.formats.empty() || std::any_of(formats.begin(), formats.end(), [&](const FilmFormat& f) {
               return f.film && wants(request, f, true);
           });
}

Film blank_film(double duration, double fps) {
    Film film;
    film.frames.resize(static_cast<std::size_t>(std::max(1.0, std::rint(duration * fps))));
    film.fps = static_cast<double>(film.frames.size()) / duration;
    return film;
}

Film render_film(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture, const View& view,
                 const Settings& settings) {
    Film film = blank_film(animation.duration, settings.render.fps);
    const FrameRenderer renderer(rig, texture, view, settings.render.picture);
    const auto count = static_cast<int>(film.frames.size());
    const int of_a_frame = count < settings.threads ? settings.threads / count : 1; // threads
    parallel_for(settings.threads, count, [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        const double time =
            animation.duration * static_cast<double>(i) / static_cast<double>(film.frames.size());
        film.frames[i] = renderer(skin(rig, animation, time), of_a_frame);
    });
    return film;
}

void write_film(const Film& film, const fs::path& folder, const std::string& stem,
                const fs::path& frames_folder, const Settings& settings, bool first) {
    const RenderRequest& request = settings.render;
    for (const FilmFormat& format : film_formats())
        if (format.film && wants(request, format, first))
            format.film(format.ending.empty() ? frames_folder : folder / (stem + std::string(format.ending)),
                        film.frames, film.fps, request.quality, settings.threads);
}

void write_motions(const Rig& rig, const BoneAnimation& animation, const fs::path& folder,
                   const std::string& stem, const RenderRequest& request, bool first) {
    for (const FilmFormat& format : film_formats())
        if (format.motion && wants(request, format, first))
            write_file(folder / (stem + std::string(format.ending)), format.motion(rig, animation));
}

} // namespace pantin
