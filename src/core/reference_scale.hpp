// SPDX-License-Identifier: MIT
// Lengths in pixels hold for the thesis's working size and scale with that of the crop at hand.
#pragma once

#include <algorithm>

namespace pantin {

// Longer side, in pixels, of the crops for which the thesis states its lengths: the input of its network
// (ch. 5). References are drawn on a square of this side.
inline constexpr int reference_side = 321;

// What a length for that size is multiplied by in a crop of this width and height; no unit.
inline double reference_scale(int width, int height) {
    return std::max(width, height) / static_cast<double>(reference_side);
}

} // namespace pantin
