// SPDX-License-Identifier: MIT
// Internal: the labels inside the final silhouette.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/segmentation.hpp"

namespace pantin::segmentation {

// probabilities: [label_count] at working size. 0 outside the silhouette, a part's label everywhere inside.
LabelMap label_parts(const Mask& silhouette, const std::vector<Grid<float>>& probabilities,
                     const SilhouetteOptions& options);

} // namespace pantin::segmentation
