// SPDX-License-Identifier: MIT
// Internal: the squared distance transform towards either value of a mask.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

// Exact squared Euclidean distance of every pixel to the nearest pixel with that value (0 or 1); with
// `outside`, the pixels around the image count as having it too. Where there is none: (width + height)² or
// more, which is larger than any true distance in the image.
Grid<int> squared_distance_to(const Mask& mask, std::uint8_t value, bool outside);

// Whether a pixel with that value lies at most `radius` away: the same question for one radius, several times
// faster.
Mask within_disc(const Mask& mask, std::uint8_t value, bool outside, double radius);

} // namespace pantin
