// SPDX-License-Identifier: MIT
// The label-aware form of the end-effector mapping (ERRATA 19): costs, and the order of the pairs.
#pragma once

#include <vector>

#include "pantin/rigging.hpp"
#include "rigging/end_places.hpp"

namespace pantin {

// The ends of one figure, clockwise.
struct LabelledEnds {
    std::vector<int> vertices;
    std::vector<Label> labels;
    EndPlaces places;
};

// The similarity costs, [drawn][reference], with the evidence of labels, places and identification;
// MappingOptions gives the sum. prominence: per end of the drawing; an end of prominence 0 and a pair that
// may not be cost `unmatched_cost`.
std::vector<std::vector<double>> label_aware_costs(const std::vector<std::vector<double>>& similarity,
                                                   const LabelledEnds& drawn, const LabelledEnds& reference,
                                                   const std::vector<double>& prominence,
                                                   const Candidate& match, const MappingOptions& options);

// Puts the pairs of one label into the same cyclic order on both sides, at the rotation with the smallest
// squared distances, or into the same order from left to right where all of them stand below the body: the
// legs of a figure then keep their order from front to hind. partner: per end of the drawing the reference's,
// −1: none.
void uncross(Label label, const LabelledEnds& drawn, const LabelledEnds& reference,
             std::vector<int>& partner);

} // namespace pantin
