// SPDX-License-Identifier: MIT
// The mesh as a graph, and how many pieces and holes it has.
#pragma once

#include <utility>
#include <vector>

#include "pantin/rigging.hpp"
#include "skeletonization/topology.hpp"

namespace pantin {

// Pieces connected through shared vertices; holes = pieces − (V − E + F).
Topology topology_of(const Mesh& mesh);

// The distinct edges (u < v), ascending.
std::vector<std::pair<int, int>> edges_of(const Mesh& mesh);
// Neighbours of every vertex along edges, ascending.
std::vector<std::vector<int>> neighbours_of(const Mesh& mesh);

} // namespace pantin
