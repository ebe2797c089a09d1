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

// --- Algorithm 4.4 -----------------------------------------------------------------------------------------

struct FloodInput {
    Point2d end;               // the end-effector
    Label label = Label::limb; // its label
};
struct FloodResult {
    int seed = -1;            // the mesh vertex nearest to the end-effector
    std::vector<int> reached; // mesh vertices that get the weight, ascending, the seed included
};
// Algorithm 4.4 with ERRATA 20. labels: every pixel has one (nearest_labels). A vertex is compared with
// end-effectors of the label at the seed.
std::vector<FloodResult> flood_weights(const Mesh& mesh, const LabelMap& labels,
                                       const std::vector<FloodInput>& ends);

// σ: the bones' lengths, each divided by the diagonal of its figure's bounding box of vertices, smaller over
// larger. The reference's nodes lie on the pixels of its 321×321 figure with a margin of 40, as in the
// end-effector mapping.
double bone_ratio(const SkeletonGraph& graph, int end, const ReferenceSkeleton& reference, int reference_end);

// bones as from make_thesis_bones: bone i + 1 belongs to mapping.pairs[i].
std::vector<VertexWeights> thesis_weights(const Mesh& mesh, const LabelMap& labels,
                                          const SkeletonGraph& graph, const ReferenceSkeleton& reference,
                                          const Mapping& mapping);

} // namespace pantin
