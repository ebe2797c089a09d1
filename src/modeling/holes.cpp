// SPDX-License-Identifier: MIT
// An outline and the strokes drawn in it, the outline with its holes out.
#include "modeling/holes.hpp"

#include <algorithm>

#include "geometry/extent.hpp"
#include "modeling/axis_tree.hpp"

namespace pantin {
namespace {

constexpr double least_wall = 0.001; // between two borders, share of the outline's diagonal

PartOutline alone(const std::vector<Point2d>& loop) {
    PartOutline polygon;
    polygon.corners = loop;
    return polygon;
}

bool meet(const std::vector<Point2d>& one, const std::vector<Point2d>& other, double wall) {
    const PartOutline a = alone(one), b = alone(other);
    for (std::size_t i = 0; i < one.size(); ++i)
        if (radius_at(b, one[i]) < wall || leaves(b, one[i], one[(i + 1) % one.size()])) return true;
    return std::any_of(other.begin(), other.end(), [&](Point2d p) { return radius_at(a, p) < wall; });
}

} // namespace

bool is_apart(const PartOutline& outline, std::size_t hole) {
    const std::vector<Point2d>& loop = outline.holes[hole];
    const double wall = least_wall * diagonal_of(outline.corners);
    if (!holds(alone(outline.corners), loop.front()) || meet(loop, outline.corners, wall)) return false;
    return std::none_of(outline.holes.begin(), outline.holes.begin() + static_cast<std::ptrdiff_t>(hole),
                        [&](const std::vector<Point2d>& before) {
                            return holds(alone(before), loop.front()) || holds(alone(loop), before.front()) ||
                                   meet(loop, before, wall);
                        });
}

int cut_holes(PartOutline& outline, const std::vector<std::vector<Point2d>>& strokes,
              const SimplePolygonOptions& options) {
    int left_out = 0;
    for (const std::vector<Point2d>& stroke : strokes) {
        outline.holes.push_back(simple_polygon(stroke, options).corners);
        if (is_apart(outline, outline.holes.size() - 1)) continue;
        outline.holes.pop_back();
        ++left_out;
    }
    return left_out;
}

} // namespace pantin
