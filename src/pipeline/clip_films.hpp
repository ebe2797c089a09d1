// SPDX-License-Identifier: MIT
// Step 6: which clips of a character are shown, from where, and under which names.
#pragma once

#include <string>
#include <vector>

#include "pipeline/character.hpp"

namespace pantin {

struct ClipFilm {
    BoneAnimation animation;
    BoneAnimation filmed; // as the camera shows it
    View view;            // of the latter
    std::string stem;     // of its files: "animation", or "animation-CLIP" for all but the first
    bool first = false;   // of all that the character can play
};

// The clips that the settings ask for. The view holds every clip of the reference, so that all films of a
// character show it at the same size; a recorded motion, which may go a long way, has a view of its own.
// CharacterRejected when there is none of that name.
std::vector<ClipFilm> clip_films(const Character& character, Context& context);

} // namespace pantin
