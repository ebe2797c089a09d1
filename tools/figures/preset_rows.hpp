// SPDX-License-Identifier: MIT
// What both presets make of one drawing, a row of panels each, and the words for it.
#pragma once

#include <cstdint>
#include <string>

#include "figures/gallery.hpp"
#include "figures/panel.hpp"

namespace pantin::figures {

inline constexpr const char* presets[] = {"thesis", "default"};
inline constexpr double preset_column = 236, preset_row = 190; // a panel
inline constexpr double preset_header = 46;                    // room for head_lines

// A character of tools/doodle, upright, with one even pen on white, so that what goes wrong is not the
// paper's fault.
RgbImage doodled(const std::string& what, std::uint64_t seed);

// At the top of a figure: what the thesis says, and what is seen here.
void head_lines(Svg& svg, const std::string& thesis, const std::string& here);

// "preset thesis: …".
std::string of_preset(int index, const std::string& text);
// "leg_front_left" for readers.
std::string spoken(std::string name);
// The reference's ends that the drawing's ends of the label were mapped to, from top to bottom: "hand left,
// hand right".
std::string partners_of(const Run& run, Label label);

void draw_labelled(Svg& svg, Rectangle place, const Run& run); // parts and skeleton
// Silhouette, parts, mapping and the pose at a share of the clip, in the row of the preset, columns 0 to 3.
void draw_preset_row(Sheet& sheet, int index, const Run& run, double share = 0.25);

} // namespace pantin::figures
