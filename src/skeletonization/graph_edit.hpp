// SPDX-License-Identifier: MIT
// Small operations that keep a skeleton graph in its canonical form: u < v, pixels from u to v, edges sorted
// by (u, v), ends marked by degree.
#pragma once

#include <vector>

#include "pantin/skeletonization.hpp"

namespace pantin {

// The edge along 8-connected pixels that run from u to v; turned round when u > v. Its length is the sum of
// steps.
SkeletonEdge make_edge(int u, int v, std::vector<Point2i> pixels);
void sort_edges(SkeletonGraph& graph);
std::vector<int> vertex_degrees(const SkeletonGraph& graph);
void mark_ends(SkeletonGraph& graph);

} // namespace pantin
