// SPDX-License-Identifier: MIT
// Labelled geometric graphs: conversion, normalisation and the cost of a matching (thesis 4.5, Eq. 4.7).
#include <algorithm>
#include <optional>
#include <set>

#include "identification/labelled_graph.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

using Edges = std::vector<std::pair<int, int>>;

// Smallest coordinate to 0, largest to 1; all equal to ½.
void normalise_axis(std::vector<Point2d>& points, double Point2d::*axis) {
    if (points.empty()) return;
    double low = points[0].*axis, high = low;
    for (const Point2d& p : points) {
        low = std::min(low, p.*axis);
        high = std::max(high, p.*axis);
    }
    for (Point2d& p : points) p.*axis = high > low ? (p.*axis - low) / (high - low) : 0.5;
}

void require_one_to_one(const LabelledGraph& a, const LabelledGraph& b, const Edges& pairs) {
    std::set<int> left, right;
    for (const auto& [u, v] : pairs) {
        const bool in_range = u >= 0 && v >= 0 && u < std::ssize(a.positions) && v < std::ssize(b.positions);
        if (!in_range || !left.insert(u).second || !right.insert(v).second)
            throw Error(ErrorKind::internal,
                        "a matching must be one-to-one between vertices of the two graphs");
    }
}

// What a matching makes of each vertex and each edge of `a`: its partner in `b`; −1, nothing.
struct Images {
    std::vector<int> vertices;
    std::vector<std::optional<std::pair<int, int>>> edges;
};
Images images_of(const LabelledGraph& a, const LabelledGraph& b, const Edges& pairs) {
    require_one_to_one(a, b, pairs);
    Images images{std::vector<int>(a.positions.size(), -1), {}};
    for (const auto& [u, v] : pairs) images.vertices[u] = v;
    std::set<std::pair<int, int>> edges_b;
    for (const auto& [u, v] : b.edges) edges_b.emplace(std::min(u, v), std::max(u, v));
    for (const auto& e : a.edges) {
        const int u = images.vertices[e.first], v = images.vertices[e.second];
        const bool matched = u >= 0 && v >= 0 && edges_b.count({std::min(u, v), std::max(u, v)}) > 0;
        images.edges.push_back(matched ? std::optional(std::pair{u, v}) : std::nullopt);
    }
    return images;
}

} // namespace

double edge_length(const LabelledGraph& graph, std::pair<int, int> edge) {
    return distance(graph.positions[edge.first], graph.positions[edge.second]);
}

double vertex_cost(const LabelledGraph& a, int u, const LabelledGraph& b, int v, const GgdOptions& options) {
    const double label_distance = std::abs(options.label_values[static_cast<int>(a.labels[u])] -
                                           options.label_values[static_cast<int>(b.labels[v])]);
    return options.k_v * distance(a.positions[u], b.positions[v]) + options.k_l * label_distance;
}

double empty_matching_cost(const LabelledGraph& a, const LabelledGraph& b, const GgdOptions& options) {
    double sum_a = 0, sum_b = 0;
    for (const auto& e : a.edges) sum_a += edge_length(a, e);
    for (const auto& e : b.edges) sum_b += edge_length(b, e);
    return options.k_e * (sum_a + sum_b);
}

LabelledGraph to_labelled_graph(const SkeletonGraph& graph) {
    LabelledGraph out;
    for (const SkeletonVertex& v : graph.vertices) {
        out.positions.push_back({v.x, v.y});
        out.labels.push_back(v.label);
    }
    for (const SkeletonEdge& e : graph.edges) out.edges.emplace_back(e.u, e.v);
    return out;
}

LabelledGraph to_labelled_graph(const ReferenceSkeleton& reference) {
    LabelledGraph out;
    for (const ReferenceNode& node : reference.nodes) {
        out.positions.push_back({node.x, node.y});
        out.labels.push_back(node.label);
    }
    out.edges = reference.edges;
    return out;
}

LabelledGraph normalised(const LabelledGraph& graph) {
    LabelledGraph out = graph;
    normalise_axis(out.positions, &Point2d::x);
    normalise_axis(out.positions, &Point2d::y);
    return out;
}

LabelledGraph mirrored(const LabelledGraph& graph) {
    LabelledGraph out = graph;
    for (Point2d& p : out.positions) p.x = 1 - p.x;
    return out;
}

double matching_cost(const LabelledGraph& a, const LabelledGraph& b, const Edges& pairs,
                     const GgdOptions& options) {
    const Images images = images_of(a, b, pairs);
    double cost = empty_matching_cost(a, b, options);
    for (std::size_t e = 0; e < a.edges.size(); ++e)
        if (images.edges[e]) // |e| + |e'| − ||e| − |e'||
            cost -= options.k_e * 2 * std::min(edge_length(a, a.edges[e]), edge_length(b, *images.edges[e]));
    for (int u = 0; u < std::ssize(images.vertices); ++u)
        if (images.vertices[u] >= 0) cost += vertex_cost(a, u, b, images.vertices[u], options);
    return cost;
}

GgdTerms matching_terms(const LabelledGraph& a, const LabelledGraph& b, const Edges& pairs,
                        const GgdOptions& options) {
    const Images images = images_of(a, b, pairs);
    GgdTerms terms;
    for (const auto& e : b.edges) terms.edges_b += options.k_e * edge_length(b, e);
    for (std::size_t e = 0; e < a.edges.size(); ++e) {
        const double drawn = edge_length(a, a.edges[e]);
        if (!images.edges[e]) {
            terms.edges_a += options.k_e * drawn;
            continue;
        }
        const double partner = edge_length(b, *images.edges[e]);
        terms.lengths += options.k_e * std::abs(drawn - partner);
        terms.edges_b -= options.k_e * partner;
    }
    terms.edges_b = std::max(0.0, terms.edges_b); // of rounding
    for (int u = 0; u < std::ssize(images.vertices); ++u) {
        const int v = images.vertices[u];
        if (v < 0) continue;
        const double place = options.k_v * distance(a.positions[u], b.positions[v]);
        terms.places += place;
        terms.labels += vertex_cost(a, u, b, v, options) - place;
    }
    return terms;
}

} // namespace pantin
