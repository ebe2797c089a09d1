// SPDX-License-Identifier: MIT
// The outline of a mask as polygons that a constrained triangulation can take.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

inline constexpr int outline_units = 16; // of a loop's coordinates in a pixel

// The border of every component and hole, half a pixel beyond the centres of its pixels, with a corner about
// every pixel and without the staircase. Loops are simple and keep apart, also around lines that are one
// pixel wide.
std::vector<std::vector<Point2i>> smooth_outline(const Mask& mask);

} // namespace pantin
