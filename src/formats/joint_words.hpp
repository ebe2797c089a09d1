// SPDX-License-Identifier: MIT
// What the name of a joint says.
#pragma once

#include <string>

#include "pantin/label.hpp"

namespace pantin {

// The part that a joint's name says: "arm3_elbow" limb, "tail_tip" tail, "left_wing_hand" wing; `background`
// when it says none. No error. Own.
Label label_of_joint_name(const std::string& name);
// Whether a limb, wing or tail begins at the joint, on the border of the trunk: a shoulder, the hip of a side
// or of a number, "tail_base". No error. Own.
bool begins_limb(const std::string& name);
// Whether it is a fin and nothing else: no "tail_fin". No error. Own.
bool is_fin(const std::string& name);
// Whether it is a neck. No error. Own.
bool is_neck(const std::string& name);

} // namespace pantin
