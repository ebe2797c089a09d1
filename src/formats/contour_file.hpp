// SPDX-License-Identifier: MIT
// contour.json: the borders of the silhouette (docs/formats.md). Only written.
#pragma once

#include <string>
#include <vector>

#include "pantin/skeletonization.hpp"

namespace pantin {

std::string contour_to_json(const std::vector<Border>& contour);

} // namespace pantin
