// SPDX-License-Identifier: MIT
// Values of a grid at points that lie between its pixels.
#pragma once

#include <algorithm>
#include <cmath>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

// The pixel whose centre is nearest to the point (halfway: the even coordinate); for a point beside the
// grid, which has at least one pixel, that of the border.
template <class T> Point2i nearest_pixel(const Grid<T>& grid, Point2d p) {
    return {std::clamp(static_cast<int>(std::rint(p.x)), 0, grid.width() - 1),
            std::clamp(static_cast<int>(std::rint(p.y)), 0, grid.height() - 1)};
}

// Its value.
template <class T> const T& at_nearest(const Grid<T>& grid, Point2d p) {
    const Point2i pixel = nearest_pixel(grid, p);
    return grid(pixel.x, pixel.y);
}

} // namespace pantin
