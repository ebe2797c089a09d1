// SPDX-License-Identifier: MIT
// Trees of joints with a root each.
#pragma once

#include "pantin/model.hpp"

namespace pantin {

// Parents come before their children. The root of a tree is the widest joint of its first part, the first one
// on a tie.
ModelSkeleton rooted(const JointTree& tree);

} // namespace pantin
