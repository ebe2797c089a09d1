// SPDX-License-Identifier: MIT
// The colours of all figures. Parts have those of `pantin explain`, which are the thesis's (Fig. 4.13).
#pragma once

#include <array>
#include <cstdint>

#include "explain/palette.hpp"
#include "pantin/grid.hpp"
#include "pantin/label.hpp"

namespace pantin::figures {

inline constexpr Rgb8 paper{255, 255, 255}, ink{32, 32, 36}, faint{196, 200, 208}, muted{110, 114, 122};
inline constexpr Rgb8 silhouette_colour{52, 54, 60}; // black of the thesis, soft enough for lines on it
inline constexpr Rgb8 accent{214, 40, 40}, second{30, 100, 210}, third{20, 140, 70}, fourth{214, 110, 0},
    highlight{226, 70, 190};
inline constexpr std::array<Rgb8, label_count> part_colours = [] { // by label
    std::array<Rgb8, label_count> colours = label_column(&LabelRow::colour);
    colours[0] = paper;
    return colours;
}();

inline constexpr Rgb8 mixed(Rgb8 a, Rgb8 b, double share_of_b) {
    const auto mix = [share_of_b](int x, int y) {
        return static_cast<std::uint8_t>(x + (y - x) * share_of_b + 0.5);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}
inline constexpr Rgb8 pale(Rgb8 colour) { return mixed(colour, paper, 0.72); }
inline constexpr Rgb8 part_colour(Label label) { return part_colours[static_cast<std::size_t>(label)]; }

} // namespace pantin::figures
