// SPDX-License-Identifier: MIT
// The subpaths of one filled path as outlines of what is filled and of the holes in it (SVG 2, 13.4.2).
#pragma once

#include <utility>
#include <vector>

#include "modeling/svg_path.hpp"

namespace pantin {

enum class FillRule { nonzero, even_odd };
struct FilledOutlines {
    std::vector<std::size_t> parts; // subpaths that border something filled, in order
    // That border what is not filled, each with the place in `parts` of the smallest part around it.
    std::vector<std::pair<std::size_t, std::size_t>> holes;
    std::size_t inner = 0;  // with something filled on both sides, which nobody sees
    std::size_t empty = 0;  // without area
    std::size_t specks = 0; // parts too small beside the largest one, holes beside their part
};
// Each subpath is closed on its own. Of subpaths that cross each other the one counts as inside that has most
// of its points there. No error. Own, by the fill rules of SVG 2.
FilledOutlines filled_outlines(const std::vector<Subpath>& subpaths, FillRule rule);

// Whether three points of it, at least, are not on one line. No error. Own.
bool has_area(const std::vector<Point2d>& outline);
// How often the closed outline runs round the point, counted with its sense; on its border either side. No
// error. Sunday 2001.
int winding(const std::vector<Point2d>& outline, Point2d p);

// Share of the outline's points that lie inside the other outline. No error. Own.
double share_inside(const std::vector<Point2d>& outline, const std::vector<Point2d>& other);

} // namespace pantin
