// SPDX-License-Identifier: MIT
// Filling of polygons and antialiased lines, our own.
#pragma once

#include <vector>

#include "doodle/curve.hpp"
#include "pantin/grid.hpp"

namespace pantin::doodle {

// A small raster somewhere on the page: values of the pixels of `box`.
template <class T> struct Patch {
    Box box;
    Grid<T> values;
    T at(int x, int y) const { return values.value_or(x - box.x, y - box.y, T{}); }
};

// The smallest pixel box around the points, grown by `margin` and cut at the page.
Box bounds(const Path& points, double margin, int width, int height);

// 1 where a pixel centre lies inside the closed polygon (non-zero winding).
Patch<std::uint8_t> fill_polygon(const Path& polygon, int width, int height);
// Coverage in [0, 1] of the polygon, from 4×4 samples a pixel.
Patch<float> cover_polygon(const Path& polygon, int width, int height);
// Coverage of a line of varying width: the union of its round-capped segments, each from its exact distance.
// `radius` has one value per point.
Patch<float> cover_line(const Path& line, const std::vector<double>& radius, int width, int height);

} // namespace pantin::doodle
