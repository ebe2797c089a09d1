// SPDX-License-Identifier: MIT
// Whether every head, limb, tail and wing of a drawing has an end of the skeleton.
#pragma once

#include <vector>

#include "pantin/evaluation.hpp"
#include "pantin/point.hpp"

namespace pantin {

// An end-effector of a skeleton graph.
struct SkeletonEnd {
    Point2d place; // pixels of the page
    Label label = Label::body;
};

// `labels`: the truth of one character, page size. An end belongs to a piece of its own label that it lies in
// or closer to than `reach` pixels. `limbs`: how many limbs were drawn, −1: not known, then each connected
// piece of the label is one, however many legs have grown together in it. One end is never two limbs: it
// counts for the nearest piece, and a piece has at most as many limbs as the others leave. No error. Own; the
// thesis judged by eye (6.1).
EndCount count_ends(const LabelMap& labels, const std::vector<SkeletonEnd>& ends, int limbs, double reach);

} // namespace pantin
