// SPDX-License-Identifier: MIT
// Internal: the final silhouette (SilhouetteOptions in pantin/segmentation.hpp says how it is made).
#pragma once

#include "pantin/grid.hpp"
#include "pantin/segmentation.hpp"

namespace pantin::segmentation {

// detected: the detector's mask; foreground: p; ink: ink darkness; all of working size. One 8-connected
// piece, or empty when both the detector and the network see nothing.
Mask decide_silhouette(const Mask& detected, const Grid<float>& foreground, const Grid<float>& ink,
                       const SilhouetteOptions& options);

} // namespace pantin::segmentation
