// SPDX-License-Identifier: MIT
// Step 6: the clips as films.
#include <algorithm>
#include <iterator>

#include "core/file.hpp"
#include "pipeline/clips.hpp"
#include "pipeline/film.hpp"
#include "pipeline/stages.hpp"

namespace pantin {

namespace {

// The animations to show, by name. CharacterRejected when there is none.
std::vector<BoneAnimation> chosen(const std::vector<BoneAnimation>& all, const std::string& reference,
                                  const std::string& wanted) {
    if (all.empty()) throw CharacterRejected("render", "the " + reference + " has no clips");
    if (wanted == "all") return all;
    std::string names;
    for (const BoneAnimation& animation : all) {
        if (animation.name == wanted) return {animation};
        names += (names.empty() ? "" : ", ") + animation.name;
    }
    throw CharacterRejected("render", "the " + reference + " has no clip '" + wanted + "' (" + names + ")");
}

// The view holds every clip, so that all films of a character show it at the same size; a recorded motion,
// which may go a long way, has a view of its own.
View view_for(const Rig& rig, const BoneAnimation& animation, const std::vector<BoneAnimation>& all,
              const std::string& motion) {
    if (animation.name == motion) return view_of(rig, {animation});
    std::vector<BoneAnimation> clips;
    std::copy_if(all.begin(), all.end(), std::back_inserter(clips),
                 [&](const BoneAnimation& a) { return a.name != motion; });
    return view_of(rig, clips);
}

} // namespace

void run_render(Character& character, Workshop& workshop) {
    const Settings& settings = workshop.settings();
    const Rig& rig = rig_of(character, workshop);
    const ReferenceSkeleton& reference = reference_of(character, workshop);
    const std::vector<BoneAnimation> all = animations_of(rig, reference, workshop);
    const RgbaImage texture = texture_of(character, workshop);
    const std::string motion = workshop.motion() ? workshop.motion()->motion.name : "";
    for (const BoneAnimation& animation : chosen(all, reference.name, settings.render.clip)) {
        const bool first = animation.name == all.front().name;
        const std::string name = first ? "animation" : "animation-" + animation.name;
        write_motions(rig, animation, character.folder, name, settings.render, first);
        if (!wants_pictures(settings.render)) continue;
        write_film(shoot(rig, animation, texture, view_for(rig, animation, all, motion), settings),
                   character.folder, name, character.folder / "frames" / animation.name, settings.render,
                   first);
    }
}

} // namespace pantin
