// SPDX-License-Identifier: MIT
// SketchParse as a segmentation network of the pipeline. Metadata of the weight file (docs/formats.md):
// `experts`, their names; `parts`, the label of each channel, experts separated by semicolons; `input`, the
// side of the square (321); `poses`, the direction of each value of the pose head (the authors' order);
// `expert`, the one that is always taken, for weights without a router.
#pragma once

#include <memory>

#include "segmentation/segmentation_network.hpp"

namespace pantin::sketch_parse {

// Error(weights) naming the file and the fact.
std::unique_ptr<segmentation::SegmentationNetwork> load_segmentation_network(const network::WeightFile& file);

} // namespace pantin::sketch_parse
