// SPDX-License-Identifier: MIT
// Where the ends of a figure lie, comparable between the drawing and the reference.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/identification.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

// An axis-aligned box in which positions are given as shares of its sides; none when it is empty.
struct Frame {
    Point2d low, high; // pixels
    bool empty() const { return high.x <= low.x || high.y <= low.y; }
    // (0, 0) at the low corner, (1, 1) at the high one; beside the box clamped to 0.75 of its sides.
    Point2d place(Point2d p) const;
};

// The box of the body in the drawing; empty when the body is less than 4 % of the silhouette.
Frame trunk_of(const LabelMap& labels);
// The box of the body's nodes, with their radii, in the reference as it is drawn.
Frame trunk_of(const SkeletonGraph& drawn, const ReferenceSkeleton& reference);

// The ends of one figure in the bounding box of all its vertices, and in that of its trunk.
struct EndPlaces {
    std::vector<Point2d> ends;
    std::vector<Point2d> beside_trunk; // the same in the trunk's box; empty without trunk
    Point2d middle;                    // of the body, in the box of the vertices
    std::vector<double> bearings; // clockwise from straight up around the middle of the body, in [0, 2π)
};
// ends: vertices of the graph.
EndPlaces places_of(const SkeletonGraph& graph, const std::vector<int>& ends, const Frame& trunk);

} // namespace pantin
