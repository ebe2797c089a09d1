// SPDX-License-Identifier: MIT
// Influence of the bones on the mesh's vertices as in the thesis (4.6, Algorithm 4.4).
#pragma once

#include <vector>

#include "pantin/rigging.hpp"

namespace pantin {

struct FloodInput {
    Point2d end;               // the end-effector
    Label label = Label::limb; // its label
};
struct FloodResult {
    int seed = -1;            // the mesh vertex nearest to the end-effector
    std::vector<int> reached; // mesh vertices that get the weight, ascending, the seed included
};
// Algorithm 4.4 with ERRATA 20, for the set EF of `ends`. labels: every pixel has one (nearest_labels). A
// vertex is compared with end-effectors of the label at the seed.
std::vector<FloodResult> flood_weights(const Mesh& mesh, const LabelMap& labels,
                                       const std::vector<FloodInput>& ends);

// σ: the bones' lengths, each divided by the diagonal of its figure's bounding box of vertices, smaller over
// larger. The reference's nodes lie on the pixels of its figure as in the end-effector mapping
// (reference_shape.hpp).
double bone_ratio(const SkeletonGraph& graph, int end, const ReferenceSkeleton& reference, int reference_end);

// bones as from make_thesis_bones: bone i + 1 belongs to mapping.pairs[i]. What an end without a partner
// keeps from the others (WeightEnds::all) belongs to the body.
std::vector<VertexWeights> thesis_weights(const Mesh& mesh, const LabelMap& labels,
                                          const SkeletonGraph& graph, const ReferenceSkeleton& reference,
                                          const Mapping& mapping, WeightEnds which = WeightEnds::mapped);

} // namespace pantin
