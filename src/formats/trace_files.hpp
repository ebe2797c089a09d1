// SPDX-License-Identifier: MIT
// Intermediate products for --trace, in a folder `trace` (docs/formats.md).
#pragma once

#include <filesystem>

#include "pantin/grid.hpp"
#include "pantin/segmentation.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

void trace_detection(const std::filesystem::path& folder, const Mask& ink);
void trace_segmentation(const std::filesystem::path& folder, const Segmentation& segmentation);
void trace_skeletonization(const std::filesystem::path& folder, const Skeletonization& skeletonization);

} // namespace pantin
