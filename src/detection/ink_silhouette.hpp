// SPDX-License-Identifier: MIT
// Internal: from the ink of one character to its filled silhouette.
#pragma once

#include "detection/enclosed_regions.hpp"
#include "pantin/grid.hpp"

namespace pantin {

struct InkSilhouetteOptions {
    EnclosedRegionOptions enclosed;
    // An outline that encloses less than this share of its box is hollow; then one region that is most of the
    // figure may be almost as wide at its mouth as anywhere. Figures of lines have no such region and stay
    // lines.
    double hollow_share = 0.15;
    EnclosedRegionOptions last_resort{1.6, 1.04, 0.25, 0.3, 1.4};
    double stroke_width = 2.5; // lines that enclose nothing get this many pen widths
};

// Width of the pen in pixels: twice the lower quartile (filled areas are wider than strokes) of the distance
// to the background along the middle of the strokes, less one; from 1 to 2.5 % of the picture's mean side.
double pen_width(const Mask& ink);

// Ink, the regions that it encloses (enclosed_regions.hpp), single strokes thickened, pieces joined by
// bridges: one 8-connected shape without holes. Empty when `ink` is.
Mask silhouette_of(const Mask& ink, const InkSilhouetteOptions& options = {});

} // namespace pantin
