// SPDX-License-Identifier: MIT
// Homotopic thinning with anchors: the pixels of the mask are peeled off from the border inwards as long as
// each is simple (Yokoi, Toriwaki & Fukumura 1975) and none of the raster's own. What is left is homotopic to
// the mask by construction, contains the raster, and runs along the middle of the mask where the raster has a
// gap. Pudney, "Distance-ordered homotopic thinning", 1998.
#include "skeletonization/topology.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "pantin/geometry.hpp"
#include "pantin/image.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// Adds the pixel deepest in the mask, the first in raster order among equals.
void add_deepest_pixel(Mask& anchors, const Grid<int>& squared_depth) {
    const auto deepest = std::max_element(squared_depth.begin(), squared_depth.end());
    if (deepest != squared_depth.end() && *deepest > 0) anchors.data()[deepest - squared_depth.begin()] = 1;
}

Mask peel(const Mask& mask, const Mask& anchors, const Grid<int>& squared_depth) {
    Mask left = mask;
    const int width = mask.width();
    using Entry = std::pair<int, int>; // squared depth, pixel: the shallowest first, then in raster order
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const Point2i p : foreground_pixels(mask))
        if (squared_depth(p.x, p.y) == 1) queue.push({1, p.y * width + p.x});
    while (!queue.empty()) {
        const int index = queue.top().second, x = index % width, y = index / width;
        queue.pop();
        if (!left(x, y) || anchors(x, y) || connectivity_number(neighbourhood(left, x, y)) != 1) continue;
        left(x, y) = 0;
        for (const Point2i d : neighbour_offsets) // they may have become simple
            if (left.value_or(x + d.x, y + d.y, 0))
                queue.push({squared_depth(x + d.x, y + d.y), (y + d.y) * width + x + d.x});
    }
    return left;
}

} // namespace

Topology topology_of(const Mask& mask) {
    Topology topology;
    for (const Border& border : follow_borders(mask)) ++(border.outer ? topology.pieces : topology.holes);
    return topology;
}

Mask fill_spurious_cycles(const Mask& raster, const Mask& mask) {
    // Floods what the raster leaves of the mask, from the mask's border inwards; what it does not reach is
    // enclosed.
    Mask enclosed = mask;
    for (std::size_t i = 0; i < mask.size(); ++i) enclosed.data()[i] = mask.data()[i] && !raster.data()[i];
    const auto touches_background = [&mask](Point2i p) {
        return !mask.value_or(p.x - 1, p.y, 0) || !mask.value_or(p.x + 1, p.y, 0) ||
               !mask.value_or(p.x, p.y - 1, 0) || !mask.value_or(p.x, p.y + 1, 0);
    };
    std::vector<Point2i> flooded;
    for (const Point2i p : foreground_pixels(enclosed))
        if (touches_background(p)) {
            enclosed(p.x, p.y) = 0;
            flooded.push_back(p);
        }
    while (!flooded.empty()) {
        const Point2i p = flooded.back();
        flooded.pop_back();
        for (std::size_t k = 0; k < 8; k += 2) {
            const int x = p.x + neighbour_offsets[k].x, y = p.y + neighbour_offsets[k].y;
            if (!enclosed.value_or(x, y, 0)) continue;
            enclosed(x, y) = 0;
            flooded.push_back({x, y});
        }
    }
    Mask filled = raster;
    for (std::size_t i = 0; i < mask.size(); ++i) filled.data()[i] |= enclosed.data()[i];
    return filled;
}

Mask restore_topology(const Mask& raster, const Mask& mask, bool fill_pockets) {
    Mask filled = fill_spurious_cycles(raster, mask);
    Mask pockets = filled, whole = filled;
    for (std::size_t i = 0; i < pockets.size(); ++i) pockets.data()[i] -= raster.data()[i];
    // Every hole that is left holds a hole of the mask, so that equal numbers are enough.
    if (topology_of(filled) != topology_of(mask)) {
        const Grid<int> squared_depth = squared_distance_transform(mask);
        if (std::find(filled.begin(), filled.end(), 1) == filled.end())
            add_deepest_pixel(filled, squared_depth);
        whole = peel(mask, filled, squared_depth);
    }
    if (fill_pockets) return whole;
    for (std::size_t i = 0; i < whole.size(); ++i) whole.data()[i] -= pockets.data()[i];
    return whole;
}

} // namespace pantin
