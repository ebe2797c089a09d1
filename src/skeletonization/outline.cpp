// SPDX-License-Identifier: MIT
// The corners are the midpoints of the sides between a pixel of the mask and one outside, joined as marching
// squares joins them (an 8-connected mask), then smoothed. The borders of follow_borders would not do: they
// pass lines of one pixel's width twice.
#include "skeletonization/outline.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

constexpr int reach = 3; // corners to each side that the mean takes
// Pixels that a corner moves at most. Two edges without a common corner are at least √½ apart, and so are a
// corner and the edge before the last: with less than half of that from each, rounding included, nothing can
// touch.
constexpr double farthest_move = 0.3;

// The side of `pixel` that faces `side`, 0 to 3 from the north clockwise.
struct Crack {
    Point2i pixel;
    int side = 0;
    bool operator==(const Crack&) const = default;
};

Point2i direction(int side) { return neighbour_offsets[static_cast<std::size_t>(2 * (side & 3))]; }
Point2i moved(Point2i p, Point2i by) { return {p.x + by.x, p.y + by.y}; }
bool inside(const Mask& mask, Point2i p) { return mask.value_or(p.x, p.y, 0) != 0; }

// The next one clockwise around the mask, which lies on the right.
Crack next(const Mask& mask, const Crack& crack) {
    const Point2i ahead = direction(crack.side + 1);
    const Point2i beside = moved(crack.pixel, ahead), diagonal = moved(beside, direction(crack.side));
    if (inside(mask, diagonal)) return {diagonal, (crack.side + 3) & 3};
    if (inside(mask, beside)) return {beside, crack.side};
    return {crack.pixel, (crack.side + 1) & 3};
}

std::vector<Point2d> follow(const Mask& mask, const Crack& first, Grid<std::uint8_t>& seen) {
    std::vector<Point2d> loop;
    Crack crack = first;
    do {
        seen(crack.pixel.x, crack.pixel.y) |= static_cast<std::uint8_t>(1 << crack.side);
        loop.push_back(to_double(crack.pixel) + 0.5 * to_double(direction(crack.side)));
        crack = next(mask, crack);
    } while (!(crack == first));
    return loop;
}

// Each corner moves towards the mean of those around it.
std::vector<Point2i> smooth(const std::vector<Point2d>& loop) {
    const int count = static_cast<int>(loop.size());
    std::vector<Point2i> result;
    for (int i = 0; i < count; ++i) {
        Point2d sum;
        for (int k = -reach; k <= reach; ++k)
            sum = sum + loop[static_cast<std::size_t>((i + k + reach * count) % count)];
        const Point2d at = loop[static_cast<std::size_t>(i)], move = (1.0 / (2 * reach + 1)) * sum - at;
        const double size = length(move);
        const Point2d to = static_cast<double>(outline_units) *
                           (at + (size > farthest_move ? farthest_move / size : 1) * move);
        result.push_back({static_cast<int>(std::rint(to.x)), static_cast<int>(std::rint(to.y))});
    }
    return result;
}

} // namespace

std::vector<std::vector<Point2i>> smooth_outline(const Mask& mask) {
    std::vector<std::vector<Point2i>> loops;
    Grid<std::uint8_t> seen(mask.width(), mask.height());
    for (const Point2i p : foreground_pixels(mask))
        for (int side = 0; side < 4; ++side)
            if (!inside(mask, moved(p, direction(side))) && !(seen(p.x, p.y) >> side & 1))
                loops.push_back(smooth(follow(mask, {p, side}, seen)));
    return loops;
}

} // namespace pantin
