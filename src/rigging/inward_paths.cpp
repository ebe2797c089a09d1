// SPDX-License-Identifier: MIT
// In come the skeleton graph, the labels and the distance transform; out go a root in the middle of the body
// and the shortest path to it from every end. Our own; limbs and bones run along these paths (thesis 4.6 has
// one straight bone per end-effector).
#include "rigging/inward_paths.hpp"

#include <algorithm>
#include <cmath>

#include "image/nearest_pixel.hpp"
#include "pantin/geometry.hpp"
#include "rigging/shortest_paths.hpp"
#include "skeletonization/graph_edit.hpp"

namespace pantin {
namespace {

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
        const bool is_body = at_nearest(labels, candidate.point) == static_cast<std::uint8_t>(Label::body);
        const float d = at_nearest(depth, candidate.point);
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

// Where paths start that lead to the root: its vertex, or the two ends of its edge with the ways to them.
std::vector<PathStart> starts_at(const Root& root, const SkeletonGraph& graph,
                                 const std::vector<std::vector<Point2d>>& edges) {
    if (root.vertex >= 0) return {{root.vertex, 0}};
    const auto& points = edges[root.edge];
    const std::vector<Point2d> head(points.begin(), points.begin() + root.index + 1);
    const std::vector<Point2d> rest(points.begin() + root.index, points.end());
    const SkeletonEdge& edge = graph.edges[root.edge];
    return {{edge.u, polyline_length(head)}, {edge.v, polyline_length(rest)}};
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
                     const Root& root, const ShortestPaths& tree) {
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
    if (root.edge >= 0) { // inside its own edge
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

InwardPaths inward_paths(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth) {
    std::vector<std::vector<Point2d>> edges;
    std::vector<double> lengths;
    for (const SkeletonEdge& edge : graph.edges) {
        edges.push_back(edge_points(graph, edge));
        lengths.push_back(polyline_length(edges.back()));
    }
    InwardPaths result;
    if (graph.vertices.empty()) return result;
    const Root root = choose_root(graph, edges, labels, depth);
    const ShortestPaths tree = shortest_paths(graph, lengths, starts_at(root, graph, edges));
    const std::vector<int> degree = vertex_degrees(graph);
    result.root = root.point;
    for (std::size_t v = 0; v < graph.vertices.size(); ++v)
        if (degree[v] <= 1 && std::isfinite(tree.length[v]))
            result.paths.push_back(path_from(static_cast<int>(v), graph, edges, root, tree));
    return result;
}

} // namespace pantin
