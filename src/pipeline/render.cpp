// Step 6: the clips as frames, and the frames as files. Frames do not depend on each other, so threads share
// them out.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/file.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/network.hpp"
#include "pipeline/stages.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// A clip as frames of one loop, and their rate: a whole number of frames that fills the clip's duration.
struct Film {
    std::vector<RgbaImage> frames;
    double fps = 25;
};

Film shoot(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture, const View& view,
           const Settings& settings) {
    const double wanted = std::rint(animation.duration * settings.render.fps);
    Film film;
    film.frames.resize(static_cast<std::size_t>(std::max(1.0, wanted)));
    film.fps = static_cast<double>(film.frames.size()) / animation.duration;
    const network::Runtime runtime(settings.threads);
    runtime.parallel_for(static_cast<int>(film.frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        const double time =
            animation.duration * static_cast<double>(i) / static_cast<double>(film.frames.size());
        film.frames[i] =
            render_frame(rig, skin(rig, animation, time), texture, view, settings.render.picture);
    });
    return film;
}

bool wants(const RenderRequest& request, const std::string& format, bool first_clip) {
    if (!request.formats.empty())
        return std::find(request.formats.begin(), request.formats.end(), format) != request.formats.end();
    if (format == "webp") return webp_available();
    return format == "gif" && first_clip && gif_available();
}

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

std::vector<ReferenceClip> chosen_clips(const ReferenceSkeleton& reference, const std::string& wanted) {
    if (reference.clips.empty()) throw CharacterRejected("render", "the " + reference.name + " has no clips");
    if (wanted == "all") return reference.clips;
    std::string names;
    for (const ReferenceClip& clip : reference.clips) {
        if (clip.name == wanted) return {clip};
        names += (names.empty() ? "" : ", ") + clip.name;
    }
    throw CharacterRejected("render",
                            "the " + reference.name + " has no clip '" + wanted + "' (" + names + ")");
}

} // namespace

void run_render(Character& character, Workshop& workshop) {
    const Settings& settings = workshop.settings();
    const Rig& rig = rig_of(character, workshop);
    const ReferenceSkeleton& reference = workshop.reference(identification_of(character, workshop).reference);
    const std::vector<ReferenceClip> chosen = chosen_clips(reference, settings.render.clip);
    // The view holds every clip, so that all films of a character show it at the same size.
    std::vector<BoneAnimation> animations;
    for (const ReferenceClip& clip : reference.clips)
        animations.push_back(retarget(rig, reference, clip, settings.options.animation.samples));
    const View view = view_of(rig, animations);
    const RgbaImage texture = make_texture(drawing_of(character), labels_of(character));

    for (const BoneAnimation& animation : animations) {
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](auto& clip) { return clip.name == animation.name; }))
            continue;
        const bool first = animation.name == reference.clips.front().name;
        const std::string name = first ? "animation" : "animation-" + animation.name;
        const Film film = shoot(rig, animation, texture, view, settings);
        if (wants(settings.render, "webp", first))
            write_file(character.folder / (name + ".webp"), encode_webp(film.frames, film.fps));
        if (wants(settings.render, "gif", first))
            write_file(character.folder / (name + ".gif"), encode_gif(film.frames, film.fps));
        if (wants(settings.render, "png", first))
            write_frames(character.folder / "frames" / animation.name, film.frames);
    }
}

} // namespace pantin
