// SPDX-License-Identifier: MIT
// Holes of a part: the article knows none (Ma et al. 2021, section 3.1: "has no holes").
#pragma once

#include <string>
#include <vector>

#include "pantin/modeling.hpp"

namespace pantin {

// Whether a hole lies inside the border, outside the holes before it, and touches neither. No error. Own.
bool is_apart(const PartOutline& outline, std::size_t hole);
// Adds the strokes as holes, each made simple as the outline itself; those that are not apart are left out.
// Returns how many were. Error(input) as simple_polygon(). Own.
int cut_holes(PartOutline& outline, const std::vector<std::vector<Point2d>>& strokes,
              const SimplePolygonOptions& options);

} // namespace pantin
