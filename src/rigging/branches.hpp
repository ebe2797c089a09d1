// SPDX-License-Identifier: MIT
// Branches of the skeleton that may become limbs.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/rigging.hpp"
#include "rigging/inward_paths.hpp"

namespace pantin {

// The first `extent` points of an inward path.
struct Branch {
    const InwardPath* path = nullptr; // null: a part of its own, no path of the skeleton
    int extent = 0;
    Label label = Label::limb;
    int reference_end = -1; // as the mapping says
    bool matched = false;   // … and the labels agree
    double length = 0;      // pixels
};

// Arc length between two points of the path, by their indices; pixels.
double arc_length(const InwardPath& path, int from, int to);

// One for every path that leaves an end-effector along three points or more of a part that is not body; the
// matched ones first, then by length, the longest first. They point into `paths`. labels: every pixel has
// one; depth: distance transform of the silhouette.
std::vector<Branch> find_branches(const InwardPaths& paths, const SkeletonGraph& graph,
                                  const LabelMap& labels, const Grid<float>& depth,
                                  const ReferenceSkeleton& reference, const Mapping& mapping);

} // namespace pantin
