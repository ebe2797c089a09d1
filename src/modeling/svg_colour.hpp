// SPDX-License-Identifier: MIT
// Colours as SVG and CSS write them (CSS Color Module Level 4, W3C 2022, without device colours).
#pragma once

#include <optional>
#include <string>

#include "pantin/grid.hpp"

namespace pantin {

struct SvgColour {
    Rgb8 colour;
    double alpha = 1; // 0 … 1
};
// "#rgb", "#rrggbbaa", "rgb(…)", "hsl(…)", a name or "transparent", in small letters; nothing for anything
// else. No error. CSS Color 4.
std::optional<SvgColour> svg_colour(const std::string& text);
// "0.5" or "50%", clamped to 0 … 1; `missing` for anything else. No error.
double svg_opacity(const std::string& text, double missing = 1);

} // namespace pantin
