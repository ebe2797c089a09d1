// SPDX-License-Identifier: MIT
// Intermediate products for --trace, in a folder `trace` (docs/formats.md).
#pragma once

#include <filesystem>

#include "pantin/grid.hpp"
#include "pantin/segmentation.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

void trace_detection(const std::filesystem::path& folder, const Mask& ink);
// The two silhouettes of a character between which DetectionOptions::mask chooses; an empty one is left out.
void trace_masks(const std::filesystem::path& folder, const Mask& ink_mask, const Mask& network_mask);
void trace_segmentation(const std::filesystem::path& folder, const Segmentation& segmentation);
void trace_skeletonization(const std::filesystem::path& folder, const Skeletonization& skeletonization);

} // namespace pantin
