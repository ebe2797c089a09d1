// SPDX-License-Identifier: MIT
// How large polygons are.
#pragma once

#include <algorithm>
#include <vector>

#include "pantin/point.hpp"

namespace pantin {

// Diagonal of the bounding box of at least one point.
inline double diagonal_of(const std::vector<Point2d>& points) {
    Point2d low = points.front(), high = low;
    for (const Point2d& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return distance(low, high);
}

// Positive where the interior lies on the left, x to the right and y up.
inline double area_of(const std::vector<Point2d>& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i], loop[(i + 1) % loop.size()]);
    return twice / 2;
}

} // namespace pantin
