// SPDX-License-Identifier: MIT
// All that a character can play: the clips of its reference, and the recorded motion when the user gives one.
#pragma once

#include <vector>

#include "pipeline/workshop.hpp"

namespace pantin {

// The clips in the reference's order, then the motion if the reference can follow it; a motion with the name
// of a clip replaces that clip.
std::vector<BoneAnimation> animations_of(const Rig& rig, const ReferenceSkeleton& reference,
                                         Workshop& workshop);

} // namespace pantin
