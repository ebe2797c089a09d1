// Step 6: the clips as frames, and the frames as files. Frames do not depend on each other, so threads share
// them out.
#include <algorithm>

#include "pantin/network.hpp"
#include "pipeline/film.hpp"
#include "pipeline/stages.hpp"

namespace pantin {

namespace {

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
        write_film(shoot(rig, animation, texture, view, settings), character.folder, name,
                   character.folder / "frames" / animation.name, settings.render, first);
    }
}

} // namespace pantin
