// SPDX-License-Identifier: MIT
// The drawing as the page shows it: small enough that a page with many characters stays light.
#pragma once

#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"
#include "pipeline/character.hpp"

namespace pantin {

inline RgbImage small_drawing(const Character& character) {
    constexpr double side = 640;
    const RgbImage& drawing = character.drawing;
    const double factor = side / std::max(drawing.width(), drawing.height());
    if (factor >= 1) return drawing;
    return resize(drawing, std::max(1, static_cast<int>(std::lrint(drawing.width() * factor))),
                  std::max(1, static_cast<int>(std::lrint(drawing.height() * factor))));
}

// Its ink at the same size; empty where the silhouette is exact (make_texture).
inline GreyImage small_ink(const Character& character) {
    if (character.exact_mask) return {};
    const RgbImage small = small_drawing(character);
    if (small.width() == character.ink.width()) return character.ink;
    return ink_of_crop(resize(darkness_of(character.ink), small.width(), small.height()));
}

} // namespace pantin
