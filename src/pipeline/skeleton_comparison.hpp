// SPDX-License-Identifier: MIT
// The skeletons of all methods beside each other, for looking at (docs/formats.md, skeletons.png and
// skeletons.json).
#pragma once

#include <string>
#include <vector>

#include "pantin/skeletonization.hpp"

namespace pantin {

struct ComparedSkeleton {
    const char* name = "";     // of the method, as in a configuration file
    std::string status = "ok"; // or why there is none
    Skeletonization skeletonization;
};

// One for each method, in the order of the picture; everything but the method as in `options`.
std::vector<ComparedSkeleton> compare_skeletons(const LabelMap& labels, SkeletonizationOptions options);

// Panels from left to right over the drawing, which may have another size than the labels.
RgbImage comparison_picture(const std::vector<ComparedSkeleton>& skeletons, const LabelMap& labels,
                            const RgbImage& drawing);
std::string comparison_to_json(const std::vector<ComparedSkeleton>& skeletons);

} // namespace pantin
