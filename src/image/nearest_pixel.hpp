// SPDX-License-Identifier: MIT
// The pixels nearest to points, and the values of a grid there.
#pragma once

#include <algorithm>
#include <cmath>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

// The pixel whose centre is nearest to the point; of two equally near ones that with the even coordinate.
inline Point2i pixel_at(Point2d p) {
    return {static_cast<int>(std::rint(p.x)), static_cast<int>(std::rint(p.y))};
}
// The same, of two equally near ones that with the larger coordinate.
inline Point2i pixel_at_or_after(Point2d p) {
    return {static_cast<int>(std::floor(p.x + 0.5)), static_cast<int>(std::floor(p.y + 0.5))};
}

// pixel_at; for a point beside the grid, which has at least one pixel, that of its border.
template <class T> Point2i nearest_pixel(const Grid<T>& grid, Point2d p) {
    const Point2i pixel = pixel_at(p);
    return {std::clamp(pixel.x, 0, grid.width() - 1), std::clamp(pixel.y, 0, grid.height() - 1)};
}
// Its value.
template <class T> const T& at_nearest(const Grid<T>& grid, Point2d p) {
    const Point2i pixel = nearest_pixel(grid, p);
    return grid(pixel.x, pixel.y);
}

} // namespace pantin
