// SPDX-License-Identifier: MIT
// The colours of the page's pictures. A part has the same one in all of them: that of the label table.
#pragma once

#include <array>
#include <string>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"

namespace pantin {

// For things that are told apart and nothing else: bones, borders, cases. Cyclic.
inline constexpr std::array<Rgb8, 12> categories = {{{38, 98, 214},
                                                     {214, 96, 0},
                                                     {24, 138, 66},
                                                     {142, 52, 168},
                                                     {200, 30, 60},
                                                     {0, 140, 150},
                                                     {166, 126, 0},
                                                     {90, 90, 200},
                                                     {120, 80, 40},
                                                     {230, 70, 150},
                                                     {80, 130, 0},
                                                     {90, 110, 120}}};

std::string css(Rgb8 colour); // "#rrggbb"
inline std::string css(Label label) { return css(row_of(label).colour); }
// Style sheet rules for all labels: the variable --<name>, and a swatch's class part-<name>.
std::string label_styles();
inline Rgb8 category(std::size_t i) { return categories[i % categories.size()]; }
// From violet (0) over green to yellow (1), like matplotlib's viridis.
Rgb8 heat(double share);

} // namespace pantin
