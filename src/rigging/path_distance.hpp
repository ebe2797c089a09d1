// SPDX-License-Identifier: MIT
// Skeleton paths (thesis 4.6): the pixels between two end-effectors and the radii along them.
#pragma once

#include <vector>

#include "pantin/rigging.hpp"
#include "rigging/figure.hpp"

namespace pantin {

// Pixels of the shortest path along the graph's edges (shortest_paths, searched from `to`), both vertices
// included; empty when there is none.
std::vector<Point2d> shortest_path(const SkeletonGraph& graph, int from, int to);
// M points of equal arc length, both ends included; radius = distance at the nearest pixel / mean (ERRATA 14,
// 15).
PathSamples sample_path(const Figure& figure, const std::vector<Point2d>& path, int samples,
                        bool length_in_pixels);

} // namespace pantin
