// Step 1 (thesis 4.2): a page to characters, each with its box and its filled silhouette.
#pragma once

#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

struct DetectionOptions {
    int working_size = 512; // longer side of the working crop at most; `thesis`: 321 (its network's input, ch. 5)
    // The detector's own constants are added here, each with its source.
    int max_characters = 64;
};

struct DetectedCharacter {
    Box box;          // page pixels, margin of max(4, 2 % of the longer side) included, cut at the page's border
    double scale = 1; // working pixels per page pixel, ≤ 1
    double score = 0; // [0, 1]: share of the silhouette's outline that is inked
    RgbImage drawing; // the crop at the page's resolution
    Mask mask;        // the filled silhouette at working size
};

// Intermediate products are kept for `--trace` and `explain`.
struct Detection {
    int width = 0, height = 0; // of the page
    Mask ink;                  // after the adaptive threshold, page size
    std::vector<DetectedCharacter> characters; // left to right, then top to bottom, by box centre
};

// The contour-based detector (Suzuki & Abe 1985 on the closed ink). Throws Error(no_character) when the page holds none.
Detection detect(const RgbImage& page, const DetectionOptions& options = {});

} // namespace pantin
