// SPDX-License-Identifier: MIT
// Internal: which connected pieces of ink make one character.
#pragma once

#include <vector>

#include "pantin/detection.hpp"
#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

struct Grouping {
    Grid<int> groups;            // per pixel: 0, or number of the group (1, 2, …) that its ink belongs to
    std::vector<Box> boxes;      // per group, of its ink
    std::vector<double> scores;  // per group, of the network that found it; empty without one
    std::vector<int> detections; // per group, which of the network's it is, from 0; empty without one
};

// Rules in grouping.cpp. `ink`: the page, possibly reduced.
Grouping group_ink(const Mask& ink, const DetectionOptions& options);

} // namespace pantin
