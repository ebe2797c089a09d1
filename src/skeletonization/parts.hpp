// SPDX-License-Identifier: MIT
// What the default preset adds to the thesis's skeleton so that every drawn part can move. Both are options
// that `thesis` switches off.
#pragma once

#include "pantin/skeletonization.hpp"

namespace pantin {

// The raster with one more pixel, an anchor for `restore_topology`, in every head, limb, tail and wing that
// the ridges hardly enter: a connected region of one label of at least `share` of the mask's area, a quarter
// of whose border or more is the shape's own. Short tails and feet whose branch falls below the residual
// threshold thus get an end of their own. The anchor is the region's deepest pixel (the first in raster
// order).
Mask anchor_missing_parts(const Mask& raster, const Mask& mask, const LabelMap& labels, double share);

// The skeleton with every cycle cut that runs through a limb, tail, wing or head: two legs whose feet touch
// have no end that could move. The cut is where the cycle is farthest from the body, counted along the
// skeleton, and so wide that its two ends are more than `gap` apart.
Mask cut_cycles(const Mask& skeleton, const LabelMap& labels, double gap);

} // namespace pantin
