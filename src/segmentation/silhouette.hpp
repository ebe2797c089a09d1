// SPDX-License-Identifier: MIT
// The silhouette's last word and the labels inside it (SilhouetteOptions in pantin/segmentation.hpp).
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/segmentation.hpp"

namespace pantin::segmentation {

// detected: the detector's mask; foreground: p; ink: ink darkness; all of working size. One 8-connected
// piece, or empty when both the detector and the network see nothing.
Mask decide_silhouette(const Mask& detected, const Grid<float>& foreground, const Grid<float>& ink,
                       const SilhouetteOptions& options);

// probabilities: [label_count] at working size. 0 outside the silhouette, a part's label everywhere inside.
LabelMap label_parts(const Mask& silhouette, const std::vector<Grid<float>>& probabilities,
                     const SilhouetteOptions& options);

} // namespace pantin::segmentation
