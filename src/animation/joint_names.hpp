// SPDX-License-Identifier: MIT
// Names of joints as programs write them, taken apart: "mixamorig:LeftUpLeg", "LUArm", "Bip01 L Thigh".
#pragma once

#include <string>
#include <vector>

namespace pantin {

enum class BodySide { none, left, right };

struct SimpleName {
    BodySide side = BodySide::none;
    std::string word;    // "uparm": what is left without side, prefix, numbers; qualifiers first
    bool helper = false; // a twist, a tip, a finger, a control: not one of the main joints
};

// One a joint, in their order; "" gives an empty one. A prefix or suffix that most of the names share is left
// out, whatever it is. Own.
std::vector<SimpleName> simplified(const std::vector<std::string>& names);

} // namespace pantin
