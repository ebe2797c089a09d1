// SPDX-License-Identifier: MIT
// The canonical form of a skeleton graph (our own: thesis 4.4 fixes no order): edges along pixels in, edges
// with u < v, their lengths and the degrees of vertices out.
#include "skeletonization/graph_edit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace pantin {

SkeletonEdge make_edge(int u, int v, std::vector<Point2i> pixels) {
    if (u > v) {
        std::swap(u, v);
        std::reverse(pixels.begin(), pixels.end());
    }
    SkeletonEdge edge{u, v, 0, std::move(pixels)};
    long straight = 0, diagonal = 0;
    for (std::size_t i = 1; i < edge.pixels.size(); ++i) {
        const int steps = std::abs(edge.pixels[i].x - edge.pixels[i - 1].x) +
                          std::abs(edge.pixels[i].y - edge.pixels[i - 1].y);
        straight += steps == 1;
        diagonal += steps == 2;
    }
    edge.length = static_cast<double>(straight) + static_cast<double>(diagonal) * std::sqrt(2.0);
    return edge;
}

void sort_edges(SkeletonGraph& graph) {
    std::stable_sort(
        graph.edges.begin(), graph.edges.end(),
        [](const SkeletonEdge& a, const SkeletonEdge& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
}

std::vector<int> vertex_degrees(const SkeletonGraph& graph) {
    std::vector<int> degree(graph.vertices.size(), 0);
    for (const SkeletonEdge& edge : graph.edges) {
        ++degree[edge.u];
        ++degree[edge.v];
    }
    return degree;
}

void mark_ends(SkeletonGraph& graph) {
    const std::vector<int> degree = vertex_degrees(graph);
    for (std::size_t i = 0; i < degree.size(); ++i) graph.vertices[i].end = degree[i] == 1;
}

} // namespace pantin
