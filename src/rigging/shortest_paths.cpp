// SPDX-License-Identifier: MIT
// E. W. Dijkstra: A note on two problems in connexion with graphs, 1959, over the at most some dozens of
// vertices of a skeleton graph: no queue is needed. In come the graph and where to start, out go the lengths
// of the shortest paths and the edges that they take.
#include "rigging/shortest_paths.hpp"

#include <limits>

namespace pantin {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The nearest vertex that is not settled, the first among equals; −1 when none is reached.
int nearest_unsettled(const std::vector<double>& length, const std::vector<char>& settled) {
    int nearest = -1;
    for (int v = 0; v < std::ssize(length); ++v)
        if (!settled[v] && length[v] < infinity && (nearest < 0 || length[v] < length[nearest])) nearest = v;
    return nearest;
}

} // namespace

ShortestPaths shortest_paths(const SkeletonGraph& graph, const std::vector<double>& lengths,
                             const std::vector<PathStart>& starts) {
    const std::size_t n = graph.vertices.size();
    ShortestPaths paths{std::vector<double>(n, infinity), std::vector<int>(n, -1), {}};
    for (const auto& [vertex, length] : starts) paths.length[vertex] = std::min(paths.length[vertex], length);
    std::vector<char> settled(n, 0);
    for (int u = nearest_unsettled(paths.length, settled); u >= 0;
         u = nearest_unsettled(paths.length, settled)) {
        settled[u] = 1;
        paths.order.push_back(u);
        for (int e = 0; e < std::ssize(graph.edges); ++e) {
            const SkeletonEdge& edge = graph.edges[e];
            if (edge.u != u && edge.v != u) continue;
            const int v = edge.u == u ? edge.v : edge.u;
            const double length = paths.length[u] + lengths[e];
            if (length < paths.length[v]) paths.length[v] = length, paths.edge[v] = e;
        }
    }
    return paths;
}

ShortestPaths shortest_paths(const SkeletonGraph& graph, int from) {
    std::vector<double> lengths;
    for (const SkeletonEdge& edge : graph.edges) lengths.push_back(edge.length);
    return shortest_paths(graph, lengths, {{from, 0}});
}

} // namespace pantin
