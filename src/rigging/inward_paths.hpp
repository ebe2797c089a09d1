// SPDX-License-Identifier: MIT
// The skeleton graph as pixel paths from each end-effector to a root point.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

struct InwardPath {
    int end = -1;                // the vertex where it starts
    std::vector<Point2d> points; // from the end to the root, both included
    std::vector<int> vertex;     // per point: the skeleton vertex there, or −1
};

struct InwardPaths {
    Point2d root;
    std::vector<InwardPath> paths; // one per vertex of degree 1 (or 0), ascending by vertex
};

// Root: the point of the skeleton with the largest depth among those with label body, among all when none has
// it; the first in vertex, then edge order on ties. Paths are shortest ones along the points
// of the edges (shortest_paths). A graph without vertices has no path.
InwardPaths inward_paths(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth);

} // namespace pantin
