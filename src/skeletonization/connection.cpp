#include "skeletonization/connection.hpp"

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

#include "pantin/image.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// Flat index of the pixel deepest in the mask (the first in raster order), −1 for an empty mask.
std::ptrdiff_t deepest_pixel(const Mask& mask, const Grid<int>& squared_depth) {
    std::ptrdiff_t deepest = -1;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask.data()[i] && (deepest < 0 || squared_depth.data()[i] > squared_depth.data()[deepest]))
            deepest = static_cast<std::ptrdiff_t>(i);
    return deepest;
}

// Cost of a step onto a pixel: its length (5 along an axis, 7 along a diagonal), dearer near the border.
std::int64_t step_cost(bool diagonal, int squared_depth) {
    return static_cast<std::int64_t>(diagonal ? 7 : 5) * (4 + 256 / (1 + squared_depth));
}

// Draws the cheapest path inside the mask from component 1 to the nearest other component (Dijkstra 1959;
// ties: the smallest pixel index).
void draw_bridge(Mask& raster, const Components& components, const Mask& mask,
                 const Grid<int>& squared_depth) {
    const int width = mask.width();
    Grid<std::int64_t> cost(width, mask.height(), -1);
    Grid<int> previous(width, mask.height(), -1);
    using Entry = std::tuple<std::int64_t, int, int>; // cost, pixel, the pixel it is reached from
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (int i = 0; i < static_cast<int>(mask.size()); ++i)
        if (components.ids.data()[i] == 1) queue.push({0, i, -1});
    while (!queue.empty()) {
        const auto [c, i, from] = queue.top();
        queue.pop();
        if (cost.data()[i] >= 0) continue;
        cost.data()[i] = c;
        previous.data()[i] = from;
        if (components.ids.data()[i] > 1) {
            for (int j = i; j >= 0; j = previous.data()[j]) raster.data()[j] = 1;
            return;
        }
        for (const Point2i d : neighbour_offsets) {
            const int x = i % width + d.x, y = i / width + d.y;
            if (!mask.value_or(x, y, 0) || cost(x, y) >= 0) continue;
            queue.push({c + step_cost(d.x != 0 && d.y != 0, squared_depth(x, y)), y * width + x, i});
        }
    }
    throw Error(ErrorKind::internal, "skeleton: the mask to bridge is not connected");
}

} // namespace

Mask fill_spurious_cycles(const Mask& raster, const Mask& mask) {
    // Floods what the raster leaves of the mask, from the mask's border inwards; what stays dry is enclosed.
    Mask dry = mask;
    for (std::size_t i = 0; i < mask.size(); ++i) dry.data()[i] = mask.data()[i] && !raster.data()[i];
    const auto touches_background = [&mask](Point2i p) {
        return !mask.value_or(p.x - 1, p.y, 0) || !mask.value_or(p.x + 1, p.y, 0) ||
               !mask.value_or(p.x, p.y - 1, 0) || !mask.value_or(p.x, p.y + 1, 0);
    };
    std::vector<Point2i> wet;
    for (const Point2i p : foreground_pixels(dry))
        if (touches_background(p)) {
            dry(p.x, p.y) = 0;
            wet.push_back(p);
        }
    while (!wet.empty()) {
        const Point2i p = wet.back();
        wet.pop_back();
        for (std::size_t k = 0; k < 8; k += 2) {
            const int x = p.x + neighbour_offsets[k].x, y = p.y + neighbour_offsets[k].y;
            if (!dry.value_or(x, y, 0)) continue;
            dry(x, y) = 0;
            wet.push_back({x, y});
        }
    }
    Mask filled = raster;
    for (std::size_t i = 0; i < mask.size(); ++i) filled.data()[i] |= dry.data()[i];
    return filled;
}

Mask bridge_gaps(const Mask& raster, const Mask& mask) {
    Mask joined = raster;
    Components components = connected_components(joined);
    if (components.list.size() == 1) return joined;
    const Grid<int> squared_depth = squared_distance_transform(mask);
    if (components.list.empty()) {
        const std::ptrdiff_t deepest = deepest_pixel(mask, squared_depth);
        if (deepest >= 0) joined.data()[deepest] = 1;
        return joined;
    }
    for (; components.list.size() > 1; components = connected_components(joined))
        draw_bridge(joined, components, mask, squared_depth);
    return joined;
}

} // namespace pantin
