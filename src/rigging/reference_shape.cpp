// SPDX-License-Identifier: MIT
// The simple shape of a reference skeleton (thesis 4.5: "for each of the characters we define a simple
// shape"): nodes with radii in, a mask's distance transform and a graph of pixels out.
#include "rigging/reference_shape.hpp"

#include <algorithm>
#include <cmath>

#include "image/nearest_pixel.hpp"

namespace pantin {
namespace {

constexpr int canvas = reference_side, margin = reference_margin;
constexpr double span = reference_span;

struct Disc {
    Point2d centre;
    double radius;
};

Disc disc_of(const ReferenceNode& node, bool mirrored) {
    return {{margin + span * (mirrored ? 1 - node.x : node.x), margin + span * node.y}, span * node.r};
}

void fill_disc(Mask& mask, const Disc& disc) {
    const auto [c, r] = disc;
    const int reach = static_cast<int>(std::ceil(r));
    const int cx = static_cast<int>(std::floor(c.x)), cy = static_cast<int>(std::floor(c.y));
    for (int y = std::max(0, cy - reach); y <= std::min(canvas - 1, cy + reach + 1); ++y) {
        const auto inside = [&, c = c, r = r](int x) {
            return (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) <= r * r;
        };
        int left = std::max(0, cx - reach), right = std::min(canvas - 1, cx + reach + 1);
        while (left <= right && !inside(left)) ++left;
        while (left <= right && !inside(right)) --right;
        for (int x = left; x <= right; ++x) mask(x, y) = 1;
    }
}

// A disc at every half pixel along the edge.
void fill_edge(Mask& mask, const Disc& a, const Disc& b) {
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * distance(a.centre, b.centre))));
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        fill_disc(mask, {a.centre + t * (b.centre - a.centre), a.radius + t * (b.radius - a.radius)});
    }
}

SkeletonEdge draw_edge(int u, int v, const Disc& a, const Disc& b) {
    SkeletonEdge edge{u, v, 0, {}};
    const double reach = std::max(std::abs(b.centre.x - a.centre.x), std::abs(b.centre.y - a.centre.y));
    const int steps = std::max(1, static_cast<int>(std::ceil(reach)));
    for (int k = 0; k <= steps; ++k) {
        const Point2d p = a.centre + (static_cast<double>(k) / steps) * (b.centre - a.centre);
        const Point2i pixel = pixel_at_or_after(p);
        if (!edge.pixels.empty() && edge.pixels.back() == pixel) continue;
        if (!edge.pixels.empty()) edge.length += distance(to_double(edge.pixels.back()), to_double(pixel));
        edge.pixels.push_back(pixel);
    }
    return edge;
}

} // namespace

Figure draw_reference(const ReferenceSkeleton& reference, bool mirrored) {
    Mask mask(canvas, canvas);
    SkeletonGraph graph;
    graph.width = graph.height = canvas;
    std::vector<Disc> discs;
    std::vector<int> degree(reference.nodes.size());
    for (const auto& [u, v] : reference.edges) {
        ++degree[u];
        ++degree[v];
    }
    for (std::size_t i = 0; i < reference.nodes.size(); ++i) {
        const ReferenceNode& node = reference.nodes[i];
        discs.push_back(disc_of(node, mirrored));
        const Point2d c = to_double(pixel_at_or_after(discs.back().centre));
        graph.vertices.push_back({c.x, c.y, node.label, degree[i] == 1});
    }
    for (const auto& [u, v] : reference.edges) {
        fill_edge(mask, discs[u], discs[v]);
        graph.edges.push_back(draw_edge(u, v, discs[u], discs[v]));
    }
    return make_figure(std::move(graph), mask);
}

} // namespace pantin
