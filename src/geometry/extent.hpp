// How large a stroke is.
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

} // namespace pantin
