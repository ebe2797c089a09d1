// SPDX-License-Identifier: MIT
// The mesh as a graph, and how many pieces and holes a mesh or a mask has.
#pragma once

#include <utility>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

struct Topology {
    int pieces = 0, holes = 0;
    bool operator==(const Topology&) const = default;
};
Topology topology_of(const Mask& mask); // pieces 8-connected, holes 4-connected
// Pieces connected through shared vertices; holes = pieces − (V − E + F).
Topology topology_of(const Mesh& mesh);

// The distinct edges (u < v), ascending.
std::vector<std::pair<int, int>> edges_of(const Mesh& mesh);
// Neighbours of every vertex along edges, ascending.
std::vector<std::vector<int>> neighbours_of(const Mesh& mesh);

} // namespace pantin
