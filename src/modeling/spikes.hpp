// SPDX-License-Identifier: MIT
// Where an outline runs out into a point.
#pragma once

#include <vector>

#include "pantin/modeling.hpp"

namespace pantin {

// From a sharp corner of an outline to where the straight skeleton of its two sides ends: sub_skeleton()
// leaves that way out, and of a needle it is all there is.
struct Spike {
    Point2d tip, root;
    double radius = 0; // of the disc that fits in at the root
};

// The spikes whose sides meet at less than 60°, in the order of the corners. No error: an outline without a
// straight skeleton has none. Own.
std::vector<Spike> spikes_of(const SimplePolygon& outline);

} // namespace pantin
