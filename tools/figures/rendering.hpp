// SPDX-License-Identifier: MIT
// Pictures of a rigged character from our rasteriser.
#pragma once

#include <string>

#include "figures/gallery.hpp"
#include "figures/svg.hpp"

namespace pantin::figures {

BoneAnimation clip_of(const Run& run, const std::string& clip);
// `count` frames side by side, the first at the share `start` of the clip, evenly spaced over one cycle.
void draw_film(Svg& svg, Rectangle place, const Run& run, const std::string& clip, int count,
               double start = 0);

} // namespace pantin::figures
