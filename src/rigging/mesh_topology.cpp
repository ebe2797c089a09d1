// SPDX-License-Identifier: MIT
// In comes a mesh of polygons; out go its edges, the neighbours of its vertices, and by Euler's formula its
// pieces and holes.
#include "rigging/mesh_topology.hpp"

#include <algorithm>

#include "core/disjoint_sets.hpp"

namespace pantin {
std::vector<std::pair<int, int>> edges_of(const Mesh& mesh) {
    std::vector<std::pair<int, int>> edges;
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int u = face[i], v = face[(i + 1) % face.size()];
            edges.emplace_back(std::min(u, v), std::max(u, v));
        }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

Topology topology_of(const Mesh& mesh) {
    const auto edges = edges_of(mesh);
    const int vertices = static_cast<int>(mesh.vertices.size());
    DisjointSets pieces(mesh.vertices.size());
    for (const auto& [u, v] : edges) pieces.unite(u, v);
    Topology topology;
    for (int i = 0; i < vertices; ++i) topology.pieces += pieces.find(i) == i;
    const int faces = static_cast<int>(mesh.faces.size());
    topology.holes = topology.pieces - (vertices - static_cast<int>(edges.size()) + faces);
    return topology;
}

std::vector<std::vector<int>> neighbours_of(const Mesh& mesh) {
    std::vector<std::vector<int>> neighbours(mesh.vertices.size());
    for (const auto& [u, v] : edges_of(mesh)) {
        neighbours[u].push_back(v);
        neighbours[v].push_back(u);
    }
    for (auto& list : neighbours) std::sort(list.begin(), list.end());
    return neighbours;
}

} // namespace pantin
