// SPDX-License-Identifier: MIT
// What drives the limbs that the end-effector mapping left out.
#pragma once

#include <vector>

#include "rigging/limbs.hpp"

namespace pantin {

// Limbs that are not matched: a reference end of their label that is still free (the nearest in normalised
// position, the first among equals), else they follow the nearest matched limb of their label. A limb without
// either keeps what it had.
void assign_reference_ends(std::vector<Limb>& limbs, const SkeletonGraph& graph,
                           const ReferenceSkeleton& reference);

} // namespace pantin
