// SPDX-License-Identifier: MIT
// Lines of some width as areas (Scalable Vector Graphics (SVG) 2, W3C 2018, 13.5: the shape of a stroke).
#pragma once

#include <vector>

#include "pantin/point.hpp"

namespace pantin {

enum class LineCap { butt, round, square };
enum class LineJoin { miter, round, bevel };
struct LineStyle {
    double width = 1; // > 0, the unit of the points
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
    double miter_limit = 4; // of a miter's length, in widths; a longer one is cut off
};

// The border of an open line as one closed outline; it may cross itself where the line bends more tightly
// than it is wide. Empty where the line has no length and no cap to show. No error. SVG 2, 13.5.
std::vector<Point2d> thick_line(const std::vector<Point2d>& way, const LineStyle& style);
// The same area, of a closed line too, as convex pieces that overlap, all of one orientation. No error.
std::vector<std::vector<Point2d>> line_pieces(const std::vector<Point2d>& way, bool closed,
                                              const LineStyle& style);

} // namespace pantin
