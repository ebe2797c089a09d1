// SPDX-License-Identifier: MIT
// A character's animations and the settings in, the clips to show with view and file names out (thesis 6.1).
#include "pipeline/clip_films.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "core/suggestion.hpp"
#include "formats/file_names.hpp"
#include "pantin/error.hpp"

namespace pantin {

namespace {

// Of all clips but the recorded motion.
View shared_view(const Character& c, const std::string& motion) {
    std::vector<BoneAnimation> clips;
    std::copy_if(c.animations.begin(), c.animations.end(), std::back_inserter(clips),
                 [&](const BoneAnimation& a) { return a.name != motion; });
    return view_of(c.rig, clips);
}

} // namespace

std::vector<ClipFilm> clip_films(const Character& c, Context& context) {
    if (c.animations.empty()) throw CharacterRejected("render", "the " + c.reference.name + " has no clips");
    const std::string& wanted = context.settings().render.clip;
    const std::string motion = context.motion() ? context.motion()->motion.name : "";
    std::optional<View> shared;
    std::vector<ClipFilm> films;
    std::string names;
    std::vector<std::string> known;
    for (const BoneAnimation& animation : c.animations) {
        names += (names.empty() ? "" : ", ") + animation.name;
        known.push_back(animation.name);
        if (wanted != "all" && animation.name != wanted) continue;
        const bool first = &animation == &c.animations.front();
        const BoneAnimation filmed = as_filmed(animation);
        if (animation.name != motion && !shared) shared = shared_view(c, motion);
        films.push_back(
            {animation, filmed, animation.name == motion ? view_of(c.rig, {filmed}) : *shared,
             first ? file_names::animation : std::string(file_names::animation) + "-" + animation.name,
             first});
        if (wanted != "all") break;
    }
    if (films.empty())
        throw CharacterRejected("render", "the " + c.reference.name + " has no clip '" + wanted + "' (" +
                                              names + ")" + did_you_mean(wanted, known));
    return films;
}

} // namespace pantin
