// SPDX-License-Identifier: MIT
// Small pictures and random shapes for the tests of skeletonization.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "pantin/geometry.hpp"
#include "pantin/image.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin::test {

inline Mask picture(const std::vector<std::string>& rows) {
    Mask mask(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) mask(x, y) = rows[y][x] == '#';
    return mask;
}

inline std::vector<std::string> rows_of(const Mask& mask) {
    std::vector<std::string> rows;
    for (int y = 0; y < mask.height(); ++y) {
        rows.emplace_back();
        for (int x = 0; x < mask.width(); ++x) rows.back() += mask(x, y) ? '#' : '.';
    }
    return rows;
}

inline void fill_disc(Mask& mask, double cx, double cy, double radius, std::uint8_t value = 1) {
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius) mask(x, y) = value;
}

// A thick line with round ends.
inline void fill_capsule(Mask& mask, Point2d a, Point2d b, double radius) {
    const int steps = static_cast<int>(2 * distance(a, b)) + 1;
    for (int i = 0; i <= steps; ++i) {
        const Point2d p = a + (static_cast<double>(i) / steps) * (b - a);
        fill_disc(mask, p.x, p.y, radius);
    }
}

// Connected blobs of strokes and discs, sometimes with holes.
inline Mask random_blob(Random& random, int side) {
    Mask mask(side, side);
    Point2d at = {side / 2.0, side / 2.0};
    const int strokes = random.integer(1, 6);
    for (int i = 0; i < strokes; ++i) {
        const double x = random.uniform(4, side - 5), y = random.uniform(4, side - 5);
        const double radius = random.uniform(0.5, side / 10.0);
        fill_capsule(mask, at, {x, y}, radius);
        if (random.chance(0.5)) at = {x, y};
    }
    if (random.chance(0.4)) {
        const double x = random.uniform(0, side), y = random.uniform(0, side);
        fill_disc(mask, x, y, random.uniform(0.5, 5), 0);
    }
    return largest_component(mask);
}

inline LabelMap all_of(const Mask& mask, Label label) {
    LabelMap labels(mask.width(), mask.height());
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask.data()[i]) labels.data()[i] = static_cast<std::uint8_t>(label);
    return labels;
}

// Numbers of 8-connected foreground components and of 4-connected holes.
struct CountedTopology {
    int components = 0, holes = 0;
    bool operator==(const CountedTopology&) const = default;
};
inline CountedTopology topology(const Mask& mask) {
    CountedTopology result;
    for (const Border& border : follow_borders(mask)) (border.outer ? result.components : result.holes) += 1;
    return result;
}

inline long count(const Mask& mask) {
    long sum = 0;
    for (const auto pixel : mask) sum += pixel;
    return sum;
}

// Independent cycles of a graph: E − V + components.
inline int cycles(const SkeletonGraph& graph) {
    std::vector<int> root(graph.vertices.size());
    for (std::size_t i = 0; i < root.size(); ++i) root[i] = static_cast<int>(i);
    const auto find = [&](int i) {
        while (root[i] != i) i = root[i];
        return i;
    };
    int closing = 0;
    for (const SkeletonEdge& edge : graph.edges) {
        const int u = find(edge.u), v = find(edge.v);
        if (u == v) ++closing;
        root[u] = v;
    }
    return closing;
}
inline int graph_components(const SkeletonGraph& graph) {
    return static_cast<int>(graph.vertices.size()) - static_cast<int>(graph.edges.size()) + cycles(graph);
}

} // namespace pantin::test
