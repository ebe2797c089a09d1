// SPDX-License-Identifier: MIT
#include "rigging/mesh_topology.hpp"

#include <algorithm>
#include <numeric>

#include "pantin/image.hpp"

namespace pantin {
namespace {

int find_root(std::vector<int>& parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}
void join(std::vector<int>& parent, int i, int j) {
    const int a = find_root(parent, i), b = find_root(parent, j);
    parent[a] = b;
}

} // namespace

Topology topology_of(const Mask& mask) {
    Topology topology;
    topology.pieces = static_cast<int>(connected_components(mask).list.size());
    const Mask filled = fill_holes(mask);
    Mask holes(mask.width(), mask.height());
    for (std::size_t i = 0; i < mask.size(); ++i) holes.data()[i] = filled.data()[i] && !mask.data()[i];
    // Holes are 4-connected: join each pixel with its left and upper neighbour, count the roots.
    std::vector<int> parent(mask.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (!holes(x, y)) continue;
            const int i = y * mask.width() + x;
            if (holes.value_or(x - 1, y, 0)) join(parent, i, i - 1);
            if (holes.value_or(x, y - 1, 0)) join(parent, i, i - mask.width());
        }
    for (std::size_t i = 0; i < mask.size(); ++i)
        topology.holes += holes.data()[i] && parent[i] == static_cast<int>(i);
    return topology;
}

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
    std::vector<int> parent(vertices);
    std::iota(parent.begin(), parent.end(), 0);
    for (const auto& [u, v] : edges) join(parent, u, v);
    Topology topology;
    for (int i = 0; i < vertices; ++i) topology.pieces += parent[i] == i;
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
