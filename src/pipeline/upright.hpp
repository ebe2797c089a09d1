// SPDX-License-Identifier: MIT
// A page that lies on its side or upside down, by what the segmentation network says of its characters. Own.
#pragma once

#include <vector>

#include "pantin/detection.hpp"
#include "pipeline/context.hpp"

namespace pantin {

// Degrees by which the page is turned clockwise so that it is upright: 0, 90, 180 or 270. All characters of a
// page stand the same way, so their probabilities are multiplied (each at least a small one, so that no
// single character decides); a turn that has DetectionOptions::turn_probability counts. Error(weights).
int find_page_turn(const std::vector<DetectedCharacter>& characters, Context& context);

} // namespace pantin
