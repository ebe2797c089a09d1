// SPDX-License-Identifier: MIT
// The straight skeleton of a mask, as pixels.
#pragma once

#include "pantin/geometry.hpp"

namespace pantin {

// The arcs that do not begin at a corner of the simplified borders (one pixel of tolerance; borders without
// area are left out).
Mask straight_ridges(const std::vector<Border>& borders, const Mask& mask);

} // namespace pantin
