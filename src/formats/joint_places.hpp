// SPDX-License-Identifier: MIT
// Where the joints of a figure lie.
#pragma once

#include <vector>

#include "formats/figure_joints.hpp"
#include "pantin/image.hpp"

namespace pantin {

// How many joints lie farther from the silhouette, in pixels of one size, than 5 % of the diagonal of its
// box; a joint beside a thin arm is none. All when the mask is empty. No error. Own.
int joints_outside(const Mask& mask, const std::vector<FigureJoint>& joints);

} // namespace pantin
