// SPDX-License-Identifier: MIT
// The colours of the page's pictures. A part has the same one in all of them (and in assets/page.css): those
// of the thesis (Fig. 4.13).
#pragma once

#include <array>
#include <string>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"

namespace pantin {

inline constexpr std::array<Rgb8, label_count> part_palette = {{{120, 120, 120},
                                                                {60, 100, 224},
                                                                {220, 60, 60},
                                                                {40, 160, 75},
                                                                {240, 130, 40},
                                                                {206, 162, 0}}}; // by label
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
inline std::string css(Label label) { return css(part_palette[static_cast<int>(label)]); }
inline Rgb8 category(std::size_t i) { return categories[i % categories.size()]; }
// From violet (0) over green to yellow (1), like matplotlib's viridis.
Rgb8 heat(double share);

} // namespace pantin
