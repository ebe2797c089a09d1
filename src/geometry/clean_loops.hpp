// SPDX-License-Identifier: MIT
// Loops of a polygon as the straight skeleton takes them.
#pragma once

#include <vector>

#include "pantin/point.hpp"

namespace pantin {

struct CleanLoops {
    // The outer border first; without equal consecutive points and points on the straight line between their
    // neighbours, interiors on the left (x to the right, y up).
    std::vector<std::vector<Point2d>> loops;
    double diagonal = 0; // of the box of all points, in their unit
};

// loops: in either orientation. tolerance: lengths below this share of the diagonal count as zero.
// Error(input) when a coordinate is not a number, there is no point, or a loop has fewer than three corners
// left or no area.
CleanLoops clean_loops(const std::vector<std::vector<Point2d>>& loops, double tolerance);

} // namespace pantin
