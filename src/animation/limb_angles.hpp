// SPDX-License-Identifier: MIT
// Directions of a recorded figure's limbs to angles in the picture, seen from the front or from the side.
#pragma once

#include <vector>

#include "animation/recording.hpp"

namespace pantin {

using Directions = std::vector<Vec3>; // one a pose, in the figure's own directions

// From joint `a` to joint `b`.
Directions directions_of(const std::vector<RecordedPose>& poses, int a, int b);
// From which side a limb is to be seen: where it moves most (after Smith et al. 2023, section 3.4; by the
// variance of its tip), unless that view hides most of it.
bool seen_from_the_side(const Directions& limb);
// Angles in the picture, counter-clockwise from the right, radians, one a pose. Where a limb points at the
// viewer its last angle stays. Empty: it has no visible direction at all.
std::vector<double> angles_in_picture(const Directions& limb, const std::vector<RecordedPose>& poses,
                                      bool from_the_side);
// The angle nearest to `near` that differs from `angle` by whole circles.
double nearest_turn(double angle, double near);

} // namespace pantin
