// SPDX-License-Identifier: MIT
// Internal: what a Segmenter holds.
#pragma once

#include "pantin/segmentation.hpp"
#include "segmentation/segmentation_network.hpp"

namespace pantin {

struct Segmenter::Model {
    std::unique_ptr<segmentation::SegmentationNetwork> network;
};

} // namespace pantin
