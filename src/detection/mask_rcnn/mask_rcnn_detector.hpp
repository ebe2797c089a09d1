// SPDX-License-Identifier: MIT
// Mask R-CNN as a detection network of the pipeline.
#pragma once

#include <memory>

#include "detection/detection_network.hpp"

namespace pantin::mask_rcnn {

// Any size of it: one channel of `image_mean` takes ink darkness, three take colours. Error(weights) naming
// the file and the fact.
std::unique_ptr<detection::DetectionNetwork> load_detection_network(const network::WeightFile& file);

} // namespace pantin::mask_rcnn
