// SPDX-License-Identifier: MIT
// The two heuristics of the thesis, section 4.4, that rid the graph of what would mislead the later steps
// (ERRATA 7): H1 takes ends from head and body, H2 joins vertices that are close. A graph in, a graph out.
#include <map>

#include "image/nearest_pixel.hpp"
#include "skeletonization/graph_edit.hpp"
#include "skeletonization/voronoi_skeleton.hpp"

namespace pantin {
namespace {

// The graph without the vertices marked, which bear no edge; the others keep their order.
SkeletonGraph without(const SkeletonGraph& graph, const std::vector<bool>& removed) {
    SkeletonGraph result;
    result.width = graph.width;
    result.height = graph.height;
    std::vector<int> renamed(graph.vertices.size(), -1);
    for (std::size_t i = 0; i < graph.vertices.size(); ++i)
        if (!removed[i]) {
            renamed[i] = static_cast<int>(result.vertices.size());
            result.vertices.push_back(graph.vertices[i]);
        }
    for (const SkeletonEdge& edge : graph.edges)
        if (!removed[edge.u] && !removed[edge.v])
            result.edges.push_back({renamed[edge.u], renamed[edge.v], edge.length, edge.pixels});
    sort_edges(result);
    mark_ends(result);
    return result;
}

Point2i pixel_of(const SkeletonVertex& v) { return pixel_at_or_after(position_of(v)); }

// The closest pair of vertices of one type nearer than the distance (ties: the smaller indices), or {−1, −1}.
std::pair<int, int> closest_pair(const std::vector<SkeletonVertex>& vertices, double merge_distance) {
    std::pair<int, int> best = {-1, -1};
    double nearest = merge_distance * merge_distance;
    for (int i = 0; i < static_cast<int>(vertices.size()); ++i)
        for (int j = i + 1; j < static_cast<int>(vertices.size()); ++j) {
            if (vertices[i].label != vertices[j].label) continue;
            const double dx = vertices[i].x - vertices[j].x, dy = vertices[i].y - vertices[j].y;
            const double squared = dx * dx + dy * dy;
            if (squared < nearest) {
                nearest = squared;
                best = {i, j};
            }
        }
    return best;
}

// The pixels of an edge, led on in straight lines to where its vertices lie now.
std::vector<Point2i> reach(std::vector<Point2i> pixels, Point2i from, Point2i to) {
    if (pixels.empty()) return straight_line(from, to); // a graph without chains
    if (!(pixels.front() == from)) {
        std::vector<Point2i> lead = straight_line(from, pixels.front());
        lead.pop_back();
        pixels.insert(pixels.begin(), lead.begin(), lead.end());
    }
    if (!(pixels.back() == to)) {
        const std::vector<Point2i> lead = straight_line(pixels.back(), to);
        pixels.insert(pixels.end(), lead.begin() + 1, lead.end());
    }
    return pixels;
}

// Eq. 4.2 for equal weights; the middle, too, where both are 0 (vertices without an edge).
Point2d weighted_middle(const SkeletonVertex& a, int weight_a, const SkeletonVertex& b, int weight_b) {
    if (weight_a == weight_b) return {(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double sum = weight_a + weight_b;
    return {(weight_a * a.x + weight_b * b.x) / sum, (weight_a * a.y + weight_b * b.y) / sum};
}

// Moves vertex i to the place and hands it the edges of j. No loops; of double edges the shorter stays (the
// first of equals).
SkeletonGraph merge(SkeletonGraph graph, int i, int j, Point2d place) {
    graph.vertices[i].x = place.x;
    graph.vertices[i].y = place.y;
    std::map<std::pair<int, int>, SkeletonEdge> edges;
    for (SkeletonEdge& edge : graph.edges) {
        const int u = edge.u == j ? i : edge.u, v = edge.v == j ? i : edge.v;
        if (u == v) continue;
        if (u == i || v == i)
            edge.pixels =
                reach(std::move(edge.pixels), pixel_of(graph.vertices[u]), pixel_of(graph.vertices[v]));
        SkeletonEdge moved = make_edge(u, v, std::move(edge.pixels));
        const auto [found, fresh] = edges.insert({{moved.u, moved.v}, moved});
        if (!fresh && moved.length < found->second.length) found->second = std::move(moved);
    }
    graph.edges.clear();
    for (auto& [ends, edge] : edges) graph.edges.push_back(std::move(edge));
    std::vector<bool> removed(graph.vertices.size(), false);
    removed[j] = true;
    return without(graph, removed);
}

} // namespace

SkeletonGraph apply_h1(const SkeletonGraph& graph) {
    SkeletonGraph result = graph;
    for (;;) {
        const std::vector<int> degree = vertex_degrees(result);
        std::vector<bool> removed(result.vertices.size(), false);
        bool changed = false;
        for (const SkeletonEdge& edge : result.edges) {
            const Label label = result.vertices[edge.u].label; // C_2 and C_3
            if (label != result.vertices[edge.v].label || (label != Label::head && label != Label::body))
                continue;
            if (degree[edge.u] != 1 && degree[edge.v] != 1) continue; // C_1
            // Of two ends that have only each other the first stays: a part never vanishes.
            removed[degree[edge.v] == 1 ? edge.v : edge.u] = changed = true;
        }
        if (!changed) return result;
        result = without(result, removed);
    }
}

SkeletonGraph apply_h2(const SkeletonGraph& graph, double merge_distance, MergeWeighting weighting) {
    SkeletonGraph result = graph;
    std::vector<int> merged(graph.vertices.size(), 1); // vertices that have become this one
    for (;;) {
        const auto [i, j] = closest_pair(result.vertices, merge_distance);
        if (i < 0) return result;
        std::vector<int> weights(merged.size(), 1);
        if (weighting == MergeWeighting::edges) weights = vertex_degrees(result);
        if (weighting == MergeWeighting::vertices) weights = merged;
        const Point2d place = weighted_middle(result.vertices[i], weights[i], result.vertices[j], weights[j]);
        result = merge(std::move(result), i, j, place);
        merged[i] += merged[j];
        merged.erase(merged.begin() + j);
    }
}

} // namespace pantin
