// SPDX-License-Identifier: MIT
// Skeleton paths (thesis 4.6): the pixels between two end-effectors and the radii along them.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

// What the path distance looks at: a skeleton inside a shape.
struct Figure {
    SkeletonGraph graph;
    Grid<int> squared_distance; // of every pixel to the outside of the shape
    double mean_distance = 0;   // mean of the distance over the shape's pixels, > 0
};
Figure make_figure(SkeletonGraph graph, const Mask& shape);
// The reference drawn at 321×321 with a margin of 40: discs of radius r along every edge, growing or
// shrinking from one node to the other; its skeleton is the edges, one pixel wide.
inline constexpr double reference_span = 240; // pixels for coordinates 0 to 1
Figure draw_reference(const ReferenceSkeleton& reference, bool mirrored);

// Pixels of the shortest path along the graph's edges (Dijkstra; ties: lowest vertex); empty when there is
// none.
std::vector<Point2d> shortest_path(const SkeletonGraph& graph, int from, int to);
// M points of equal arc length, both ends included; radius = distance at the nearest pixel / mean (ERRATA 14,
// 15).
PathSamples sample_path(const Figure& figure, const std::vector<Point2d>& path, int samples,
                        bool length_in_pixels);

} // namespace pantin
