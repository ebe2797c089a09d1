// SPDX-License-Identifier: MIT
// The simple shape of a reference skeleton (thesis 4.5), which the mapping compares with the drawing.
#pragma once

#include "core/reference_scale.hpp"
#include "pantin/identification.hpp"
#include "rigging/figure.hpp"

namespace pantin {

inline constexpr int reference_margin = 40; // pixels on each side of the square of reference_side
inline constexpr int reference_span =
    reference_side - 1 - 2 * reference_margin; // pixels for coordinates 0 to 1

// Discs of radius r along every edge, growing or shrinking from one node to the other; its skeleton is the
// edges, one pixel wide. `mirrored`: left for right.
Figure draw_reference(const ReferenceSkeleton& reference, bool mirrored);

} // namespace pantin
