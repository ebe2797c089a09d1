// Step 1 (thesis 4.2): a page to characters, each with its box and its filled silhouette.
#pragma once

#include <string>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

struct DetectionOptions {
    int working_size =
        512; // longer side of the working crop at most; `thesis`: 321 (its network's input, ch. 5)
    int max_characters = 64; // a page with more keeps the ones with the largest boxes

    // Ink. Shares of the darkness of the darkest strokes (ink_darkness).
    double ink_contrast = 0.15;    // a stroke is darker than the local mean by this
    double lightest_stroke = 0.38; // and at least this dark itself
    double filled_darkness = 0.5;  // a filled area is at least this dark
    int threshold_windows = 40;    // half a window of the local mean = longer side / this

    // Grouping of ink pieces (src/detection/grouping.cpp), measured on pages composed of real drawings
    // (tools/evaluate_detection.py). Gaps relative to the diagonal of a box.
    int grouping_size = 1024; // longer side of the page on which pieces are grouped, at most
    double mark_size = 0.35;  // a mark is at most this share of its character …
    double mark_gap = 0.12;   // … and this far from it (share of the character)
    double touching_gap =
        0.02; // pieces of like size this close are one (here and below: share of the smaller one)
    double closed_share = 0.03; // what encloses this share of its squared diagonal could stand alone
    double deepest_pen = 0.02; // ink deeper than this share of its diagonal is colour, not a stroke
    double contact_share =
        0.05;               // an open line has this share of the border of a room that it helps to enclose
    double head_size = 0.5; // a closed shape beside another is its head up to this share of it,
    double stacked_head_size = 0.7; // or this one when one is above the other,
    double head_gap = 0.1;          // and this gap; all other closed shapes stay apart
    double open_gap = 0.15;         // an open line and anything of like size
    double stacked_gap = 0.2;       // the same, one above the other
    double room_gain = 0.2;         // side by side only if this share of what they enclose needs both
    double min_share = 0.15;        // groups smaller than this share of the largest are dropped
    int min_side = 16;              // page pixels; smaller characters are dropped
};

struct DetectedCharacter {
    Box box; // page pixels, margin of max(4, 2 % of the longer side) included, cut at the page's border
    double scale = 1; // working pixels per page pixel, ≤ 1
    double score = 0; // [0, 1]: share of the silhouette's outline that is inked
    RgbImage drawing; // the crop at the page's resolution
    Mask mask;        // the filled silhouette at working size
};

// Intermediate products are kept for `--trace` and `explain`.
struct Detection {
    int width = 0, height = 0;                 // of the page
    Mask ink;                                  // after the adaptive threshold, page size
    std::vector<DetectedCharacter> characters; // left to right, then top to bottom, by box centre
};

// The contour-based detector (Suzuki & Abe 1985 on the closed ink). Throws Error(no_character) when the page
// holds none.
Detection detect(const RgbImage& page, const DetectionOptions& options = {});

} // namespace pantin
