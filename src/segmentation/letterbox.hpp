// SPDX-License-Identifier: MIT
// The crop inside the network's square input and back.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/network.hpp"
#include "pantin/point.hpp"

namespace pantin::segmentation {

// Where a crop of that size lies in a square of `side`: scaled so that its longer side fits, in the middle.
Box letterbox(int width, int height, int side);

// Ink darkness of the crop → [1, 1, side, side], background (0) around it; `grey_erosion`:
// SegmentationOptions.
network::Tensor to_input(const Grid<float>& ink, int side, bool grey_erosion);

// Each channel of [1, c, side, side] cut to the crop.
std::vector<Grid<float>> from_output(const network::Tensor& output, Box box);

} // namespace pantin::segmentation
