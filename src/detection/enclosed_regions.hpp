// SPDX-License-Identifier: MIT
// Internal: which background belongs to a shape whose outline has gaps.
#pragma once

#include "pantin/grid.hpp"

namespace pantin {

// A region counts as enclosed when inradius / half-width of its mouth reaches a ratio that falls with the
// region's area: a small one must be clearly wider than its mouth, the one that is most of the character may
// have a wide gap. (A pocket and its mouth in Edelsbrunner et al. 1998.)
struct EnclosedRegionOptions {
    double small_ratio = 1.5; // for a region of no area
    double large_ratio = 1.1; // for one of at least `large_share`
    double large_share = 0.4; // of the convex hull's area
    double max_mouth = 0.2;   // half-width of a mouth over the diagonal of the ink's box, at most
    double corridor = 1.4;    // a corridor leads on while it is no wider than this times its narrowest place
};

// The background that the ink encloses, wholly or but for narrow mouths. 1 = interior, ink itself is 0.
Mask find_enclosed_regions(const Mask& ink, const EnclosedRegionOptions& options = {});

} // namespace pantin
