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

} // namespace pantin
