// SPDX-License-Identifier: MIT
// How much of a part each end of the drawing is.
#pragma once

#include <vector>

#include "pantin/skeletonization.hpp"

namespace pantin {

// Per end: length of its part as a share of the longest part of that label, in (0, 1]. 0 for the forked tip
// of a part (a finger, a feather), shortest first, as long as the drawing has more ends of the label than the
// reference: legs that grow together are not fingers. ends: vertices of the graph.
std::vector<double> prominence_of(const SkeletonGraph& graph, const std::vector<int>& ends,
                                  const std::vector<Label>& reference_labels);

} // namespace pantin
