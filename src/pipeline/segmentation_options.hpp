// SPDX-License-Identifier: MIT
// The options of segmentation for one drawing.
#pragma once

#include "pantin/image.hpp"
#include "pantin/segmentation.hpp"

namespace pantin {

// With the question answered whether the drawing is a photograph (thesis ch. 5).
inline SegmentationOptions segmentation_options(const RgbImage& drawing, SegmentationOptions options) {
    if (options.grey_erosion == GreyErosion::photographs)
        options.grey_erosion = is_photograph(drawing) ? GreyErosion::always : GreyErosion::never;
    return options;
}

} // namespace pantin
