// SPDX-License-Identifier: MIT
// Shortest paths along the edges of a skeleton graph: the only search of that kind, for the paths between
// two ends (thesis 4.6), from the ends to the root, and for the length of a part.
#pragma once

#include <vector>

#include "pantin/skeletonization.hpp"

namespace pantin {

struct PathStart {
    int vertex = 0;
    double length = 0; // of the way that lies behind one there, pixels
};

struct ShortestPaths {
    std::vector<double> length; // per vertex, from the start that is nearest; infinite where no path leads
    std::vector<int> edge;      // per vertex: by which it is reached; −1 at a start and where no path leads
    std::vector<int> order;     // the vertices that are reached, ascending by length, then by index
};

// Dijkstra 1959. lengths: per edge of the graph, ≥ 0. Of equally long paths to a vertex the one counts that
// is found first: the vertices are settled by length, then by index, and their edges are followed in the
// graph's order.
ShortestPaths shortest_paths(const SkeletonGraph& graph, const std::vector<double>& lengths,
                             const std::vector<PathStart>& starts);
// By the edges' own lengths.
ShortestPaths shortest_paths(const SkeletonGraph& graph, int from);

} // namespace pantin
