// SPDX-License-Identifier: MIT
// Bones with part labels between the joints of a figure.
#pragma once

#include <vector>

#include "formats/figure_joints.hpp"
#include "pantin/label.hpp"

namespace pantin {

struct LabelledBone {
    Label label = Label::body;
    Point2d from, to; // as the joints' places
};

// Whether all joints of a human figure are there (animated_drawings_joints), whatever they hang on; others
// may be there, too. No error. Own.
bool has_humanoid_joints(const std::vector<FigureJoint>& joints);

// The bones of a figure, the trunk's first; labels are of labels_of_joints(). Empty when there is no trunk or
// nothing else. No error. Own.
std::vector<LabelledBone> bones_of(const std::vector<FigureJoint>& joints, const std::vector<Label>& labels);

} // namespace pantin
