// SPDX-License-Identifier: MIT
// What the joints of a figure say about its parts.
#pragma once

#include <vector>

#include "formats/figure_joints.hpp"
#include "pantin/image.hpp"
#include "pantin/label.hpp"

namespace pantin {

// The part that each joint belongs to, by the words of its name and by what it hangs on and what hangs on it:
// what hangs on a limb is limb, a chain without known names that hangs on the trunk is a limb, and the trunk
// is what lies between them. A shoulder or a side's hip is of the limb that begins there. No error. Own.
std::vector<Label> labels_of_joints(const std::vector<FigureJoint>& joints);

// Part labels of a silhouette by the nearest bone between the joints, pixels of one size; where two are as
// near the trunk has it. Empty when the joints do not say what is trunk and what is not. The 16 joints of a
// human figure have their own bones, as AnimatedDrawings means them. No error. Own.
LabelMap labels_from_joints(const Mask& mask, const std::vector<FigureJoint>& joints);

} // namespace pantin
