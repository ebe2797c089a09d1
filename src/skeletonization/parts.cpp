// SPDX-License-Identifier: MIT
// Two repairs of the thesis's skeleton (thesis 4.4), our own: in come the ridges or the skeleton as a raster
// and the labels; out goes the raster with a pixel more in parts that no ridge enters, or the skeleton
// without cycles through limbs.
#include "skeletonization/parts.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "image/label_map.hpp"
#include "pantin/image.hpp"
#include "skeletonization/graph_edit.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// Whether a quarter of the piece's border pixels or more touch the background.
bool touches_outside(const LabelPiece& piece, Label label, const Mask& mask, const LabelMap& labels) {
    long border = 0, outer = 0;
    for (const Point2i p : piece.pixels) {
        bool is_border = false, is_outer = false;
        for (std::size_t k = 0; k < 8; k += 2) {
            const int x = p.x + neighbour_offsets[k].x, y = p.y + neighbour_offsets[k].y;
            const bool inside = mask.value_or(x, y, 0) != 0;
            is_outer |= !inside;
            is_border |= !inside || labels(x, y) != static_cast<std::uint8_t>(label);
        }
        border += is_border;
        outer += is_outer;
    }
    return 4 * outer >= border;
}

// Whether the ridges run through the piece over a quarter of its size (the root of its area) or more.
bool is_represented(const LabelPiece& piece, const Mask& raster) {
    const auto ridge = std::count_if(piece.pixels.begin(), piece.pixels.end(),
                                     [&](Point2i p) { return raster(p.x, p.y) != 0; });
    return 16 * static_cast<long>(ridge) * static_cast<long>(ridge) >= piece.area();
}

// The first in raster order among equals.
Point2i deepest_pixel(const LabelPiece& piece) {
    const Grid<int> depth = squared_distance_transform(cropped_mask(piece));
    const auto index = static_cast<int>(std::max_element(depth.begin(), depth.end()) - depth.begin());
    return {piece.box.x + index % depth.width(), piece.box.y + index / depth.width()};
}

// Length of the way along the skeleton to the nearest pixel of body, in fifths of a pixel (5 along an axis, 7
// along a diagonal); −1 where there is none.
Grid<int> distance_from_body(const Mask& skeleton, const LabelMap& labels) {
    Grid<int> distance(skeleton.width(), skeleton.height(), -1);
    using Entry = std::pair<int, int>; // distance, pixel
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const Point2i p : foreground_pixels(skeleton))
        if (labels(p.x, p.y) == static_cast<std::uint8_t>(Label::body))
            queue.push({0, p.y * skeleton.width() + p.x});
    while (!queue.empty()) {
        const auto [length, index] = queue.top();
        queue.pop();
        const int x = index % skeleton.width(), y = index / skeleton.width();
        if (distance(x, y) >= 0) continue;
        distance(x, y) = length;
        for (const Point2i d : neighbour_offsets)
            if (skeleton.value_or(x + d.x, y + d.y, 0))
                queue.push({length + (d.x != 0 && d.y != 0 ? 7 : 5), (y + d.y) * skeleton.width() + x + d.x});
    }
    return distance;
}

// Whether u and v are joined without that edge, so that it lies on a cycle.
bool on_cycle(const SkeletonGraph& graph, std::size_t without) {
    std::vector<bool> reached(graph.vertices.size(), false);
    reached[graph.edges[without].u] = true;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const auto [u, v] = std::pair(graph.edges[e].u, graph.edges[e].v);
            if (e == without || reached[u] == reached[v]) continue;
            reached[u] = reached[v] = changed = true;
        }
    }
    return reached[graph.edges[without].v];
}

struct Cut {
    std::vector<Point2i> pixels; // to clear
    int distance = -1;           // from the body
};

// The cut around pixels[at] of a chain, whose ends stay; none when the chain is too short.
std::optional<std::vector<Point2i>> cut_at(const std::vector<Point2i>& pixels, int at, double gap) {
    const int last = static_cast<int>(pixels.size()) - 1;
    for (int reach = 1; at - reach >= 1 && at + reach <= last - 1; ++reach)
        if (distance(to_double(pixels[at - reach]), to_double(pixels[at + reach])) > gap)
            return std::vector<Point2i>(pixels.begin() + at - reach + 1, pixels.begin() + at + reach);
    return std::nullopt;
}

// The cut farthest from the body (the first such along the first such edge).
Cut best_cut(const SkeletonGraph& graph, const Grid<int>& from_body, const LabelMap& labels, double gap) {
    Cut best;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        if (!on_cycle(graph, e)) continue;
        const std::vector<Point2i>& pixels = graph.edges[e].pixels;
        for (int at = 1; at + 1 < static_cast<int>(pixels.size()); ++at) {
            const Point2i p = pixels[at];
            if (labels(p.x, p.y) == static_cast<std::uint8_t>(Label::body) ||
                from_body(p.x, p.y) <= best.distance)
                continue;
            if (auto cleared = cut_at(pixels, at, gap)) best = {std::move(*cleared), from_body(p.x, p.y)};
        }
    }
    return best;
}

} // namespace

Mask anchor_missing_parts(const Mask& raster, const Mask& mask, const LabelMap& labels, double share) {
    Mask anchored = raster;
    const auto area = static_cast<double>(std::count(mask.begin(), mask.end(), 1));
    for (const Label label : {Label::head, Label::limb, Label::tail, Label::wing}) {
        Mask part = part_mask(labels, {label});
        std::transform(part.begin(), part.end(), mask.begin(), part.begin(), std::logical_and<>());
        for (const LabelPiece& piece : pieces_of(part)) {
            if (piece.area() < share * area || is_represented(piece, raster) ||
                !touches_outside(piece, label, mask, labels))
                continue;
            const Point2i anchor = deepest_pixel(piece);
            anchored(anchor.x, anchor.y) = 1;
        }
    }
    return anchored;
}

Mask cut_cycles(const Mask& skeleton, const LabelMap& labels, double gap) {
    Mask cut = skeleton;
    for (;;) {
        const SkeletonGraph graph = extract_graph(cut, labels);
        // A connected graph with fewer edges than vertices is a tree.
        if (graph.edges.size() < graph.vertices.size()) return cut;
        const Cut best = best_cut(graph, distance_from_body(cut, labels), labels, gap);
        if (best.pixels.empty()) return cut;
        for (const Point2i p : best.pixels) cut(p.x, p.y) = 0;
    }
}

} // namespace pantin
