// SPDX-License-Identifier: MIT
#include "skeletonization/parts.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "pantin/image.hpp"
#include "skeletonization/graph_edit.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// A connected region of one label.
struct Part {
    Label label = Label::background;
    std::vector<Point2i> pixels;
};

// The 8-connected parts of the mask that are not body, in raster order of their first pixels.
std::vector<Part> find_parts(const Mask& mask, const LabelMap& labels) {
    std::vector<Part> parts;
    Mask seen(mask.width(), mask.height());
    for (const Point2i start : foreground_pixels(mask)) {
        const auto label = static_cast<Label>(labels(start.x, start.y));
        if (seen(start.x, start.y) || label == Label::body || label == Label::background) continue;
        Part part{label, {start}};
        seen(start.x, start.y) = 1;
        for (std::size_t i = 0; i < part.pixels.size(); ++i)
            for (const Point2i d : neighbour_offsets) {
                const Point2i q = {part.pixels[i].x + d.x, part.pixels[i].y + d.y};
                if (!mask.value_or(q.x, q.y, 0) || seen(q.x, q.y) ||
                    labels(q.x, q.y) != static_cast<std::uint8_t>(label))
                    continue;
                seen(q.x, q.y) = 1;
                part.pixels.push_back(q);
            }
        parts.push_back(std::move(part));
    }
    return parts;
}

// Whether a quarter of the part's border pixels or more touch the background.
bool touches_outside(const Part& part, const Mask& mask, const LabelMap& labels) {
    long border = 0, outer = 0;
    for (const Point2i p : part.pixels) {
        bool is_border = false, is_outer = false;
        for (std::size_t k = 0; k < 8; k += 2) {
            const int x = p.x + neighbour_offsets[k].x, y = p.y + neighbour_offsets[k].y;
            const bool inside = mask.value_or(x, y, 0) != 0;
            is_outer |= !inside;
            is_border |= !inside || labels(x, y) != static_cast<std::uint8_t>(part.label);
        }
        border += is_border;
        outer += is_outer;
    }
    return 4 * outer >= border;
}

// Whether the ridges run through the part over a quarter of its size (the root of its area) or more.
bool is_represented(const Part& part, const Mask& raster) {
    const auto ridge = std::count_if(part.pixels.begin(), part.pixels.end(),
                                     [&](Point2i p) { return raster(p.x, p.y) != 0; });
    return 16 * static_cast<long>(ridge) * static_cast<long>(ridge) >= static_cast<long>(part.pixels.size());
}

Point2i deepest_pixel(const Part& part) {
    const auto [left, right] = std::minmax_element(part.pixels.begin(), part.pixels.end(),
                                                   [](Point2i a, Point2i b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(part.pixels.begin(), part.pixels.end(),
                                                   [](Point2i a, Point2i b) { return a.y < b.y; });
    Mask region(right->x - left->x + 1, bottom->y - top->y + 1);
    for (const Point2i p : part.pixels) region(p.x - left->x, p.y - top->y) = 1;
    const Grid<int> depth = squared_distance_transform(region);
    const auto index = static_cast<int>(std::max_element(depth.begin(), depth.end()) - depth.begin());
    return {left->x + index % region.width(), top->y + index / region.width()};
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
    for (const Part& part : find_parts(mask, labels)) {
        if (static_cast<double>(part.pixels.size()) < share * area || is_represented(part, raster) ||
            !touches_outside(part, mask, labels))
            continue;
        const Point2i anchor = deepest_pixel(part);
        anchored(anchor.x, anchor.y) = 1;
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
