// SPDX-License-Identifier: MIT
// Influence of the bones on the mesh's vertices (thesis 4.6).
#pragma once

#include <vector>

#include "pantin/rigging.hpp"
#include "rigging/bones.hpp"
#include "rigging/ownership.hpp"

namespace pantin {

// Smooth weights: every vertex starts with the bones of its owner's limb, blended around the joints, and the
// weights then diffuse along the mesh's edges, so that no influence crosses a cut or a gap.
std::vector<VertexWeights> smooth_weights(const Mesh& mesh, const std::vector<Owner>& owners,
                                          const Limbs& limbs, const Skeleton& skeleton, double cell);

// Weights of any number of bones to at most four, rounded to multiples of 2^-16 by largest remainder (ties:
// the lower bone), so that they sum to exactly 1, in double and in single precision.
VertexWeights quantised(const std::vector<double>& per_bone);

} // namespace pantin
