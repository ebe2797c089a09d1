// SPDX-License-Identifier: MIT
#include "rigging/inward_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pantin/geometry.hpp"

namespace pantin {
namespace {

Point2d position_of(const SkeletonVertex& v) { return {v.x, v.y}; }

// All points of an edge from u to v, ends included; an edge without pixels is a straight line.
std::vector<Point2d> edge_points(const SkeletonGraph& graph, const SkeletonEdge& edge) {
    const Point2d from = position_of(graph.vertices[edge.u]), to = position_of(graph.vertices[edge.v]);
    if (edge.pixels.empty())
        return resample({from, to}, std::max(2, static_cast<int>(std::ceil(distance(from, to))) + 1));
    std::vector<Point2d> points;
    points.push_back(from);
    for (const Point2i& pixel : edge.pixels)
        if (to_double(pixel) != points.back()) points.push_back(to_double(pixel));
    if (points.back() != to) points.push_back(to);
    return points;
}

template <class T> T sample(const Grid<T>& grid, Point2d p) {
    const int x = std::clamp(static_cast<int>(std::rint(p.x)), 0, grid.width() - 1);
    const int y = std::clamp(static_cast<int>(std::rint(p.y)), 0, grid.height() - 1);
    return grid(x, y);
}

struct Root {
    Point2d point;
    int vertex = -1;          // or
    int edge = -1, index = 0; // a point inside an edge
};

Root choose_root(const SkeletonGraph& graph, const std::vector<std::vector<Point2d>>& edges,
                 const LabelMap& labels, const Grid<float>& depth) {
    Root best;
    bool best_is_body = false;
    float best_depth = -1;
    const auto offer = [&](const Root& candidate) {
        const bool is_body = sample(labels, candidate.point) == static_cast<std::uint8_t>(Label::body);
        const float d = sample(depth, candidate.point);
        if (is_body < best_is_body || (is_body == best_is_body && d <= best_depth)) return;
        best = candidate, best_is_body = is_body, best_depth = d;
    };
    for (std::size_t v = 0; v < graph.vertices.size(); ++v)
        offer({position_of(graph.vertices[v]), static_cast<int>(v), -1, 0});
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (std::size_t i = 1; i + 1 < edges[e].size(); ++i)
            offer({edges[e][i], -1, static_cast<int>(e), static_cast<int>(i)});
    return best;
}

// Shortest-path tree from the root (Dijkstra over at most a few dozen vertices).
struct Tree {
    std::vector<double> cost;
    std::vector<int>
        edge; // towards the root: −1 at the root vertex, −2 unreached, −3 along the root's own edge
};

Tree shortest_paths(const SkeletonGraph& graph, const std::vector<std::vector<Point2d>>& edges,
                    const Root& root) {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::size_t n = graph.vertices.size();
    Tree tree{std::vector<double>(n, infinity), std::vector<int>(n, -2)};
    if (root.vertex >= 0) {
        tree.cost[root.vertex] = 0;
        tree.edge[root.vertex] = -1;
    } else {
        const SkeletonEdge& edge = graph.edges[root.edge];
        const auto& points = edges[root.edge];
        const std::vector<Point2d> head(points.begin(), points.begin() + root.index + 1);
        const std::vector<Point2d> rest(points.begin() + root.index, points.end());
        for (const auto& [vertex, cost] :
             {std::pair{edge.u, polyline_length(head)}, {edge.v, polyline_length(rest)}})
            if (cost < tree.cost[vertex]) tree.cost[vertex] = cost, tree.edge[vertex] = -3;
    }
    std::vector<char> done(n, 0);
    for (std::size_t round = 0; round < n; ++round) {
        int u = -1;
        for (std::size_t v = 0; v < n; ++v)
            if (!done[v] && tree.cost[v] < infinity && (u < 0 || tree.cost[v] < tree.cost[u]))
                u = static_cast<int>(v);
        if (u < 0) break;
        done[u] = true;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const SkeletonEdge& edge = graph.edges[e];
            if (edge.u != u && edge.v != u) continue;
            const int other = edge.u == u ? edge.v : edge.u;
            const double cost = tree.cost[u] + polyline_length(edges[e]);
            if (cost < tree.cost[other]) tree.cost[other] = cost, tree.edge[other] = static_cast<int>(e);
        }
    }
    return tree;
}

void append(InwardPath& path, Point2d point, int vertex) {
    if (!path.points.empty() && path.points.back() == point) {
        path.vertex.back() = std::max(path.vertex.back(), vertex);
        return;
    }
    path.points.push_back(point);
    path.vertex.push_back(vertex);
}

InwardPath path_from(int end, const SkeletonGraph& graph, const std::vector<std::vector<Point2d>>& edges,
                     const Root& root, const Tree& tree) {
    InwardPath path;
    path.end = end;
    append(path, position_of(graph.vertices[end]), end);
    int v = end;
    while (tree.edge[v] >= 0) {
        const SkeletonEdge& edge = graph.edges[tree.edge[v]];
        std::vector<Point2d> points = edges[tree.edge[v]];
        if (edge.u != v) std::reverse(points.begin(), points.end());
        v = edge.u == v ? edge.v : edge.u;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) append(path, points[i], -1);
        append(path, position_of(graph.vertices[v]), v);
    }
    if (tree.edge[v] == -3) {
        const auto& points = edges[root.edge];
        const int n = static_cast<int>(points.size());
        if (graph.edges[root.edge].u == v)
            for (int i = 1; i <= root.index; ++i) append(path, points[i], -1);
        else
            for (int i = n - 2; i >= root.index; --i) append(path, points[i], -1);
    }
    return path;
}

} // namespace

SkeletonPaths skeleton_paths(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth) {
    std::vector<std::vector<Point2d>> edges;
    std::vector<int> degree(graph.vertices.size(), 0);
    for (const SkeletonEdge& edge : graph.edges) {
        edges.push_back(edge_points(graph, edge));
        ++degree[edge.u];
        ++degree[edge.v];
    }
    SkeletonPaths result;
    if (graph.vertices.empty()) return result;
    const Root root = choose_root(graph, edges, labels, depth);
    const Tree tree = shortest_paths(graph, edges, root);
    result.root = root.point;
    for (std::size_t v = 0; v < graph.vertices.size(); ++v)
        if (degree[v] <= 1 && tree.edge[v] != -2)
            result.paths.push_back(path_from(static_cast<int>(v), graph, edges, root, tree));
    return result;
}

} // namespace pantin
