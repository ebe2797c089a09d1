// SPDX-License-Identifier: MIT
// From the skeleton graph and the end-effector mapping to limbs: where each leaves the body and along which
// path of the skeleton it runs. Bones, pixel ownership and weights are all expressed along these paths.
#pragma once

#include <vector>

#include "pantin/rigging.hpp"

namespace pantin {

// Positions along a limb are arc lengths of `path` in working pixels, 0 at the attachment.
struct Limb {
    int end = -1; // skeleton vertex (end-effector); beyond the graph's vertices for a part that has none
    int reference_end = -1; // reference node that drives it
    bool matched = false;   // paired by the mapping, or a follower
    Label label = Label::limb;
    std::vector<Point2d> path;    // from the attachment to the end-effector, steps of about one pixel
    std::vector<double> position; // arc length at each point of `path`
    int parent = -1;              // limb that it hangs from, −1 the body; parents come first
    double parent_position = 0;   // where on the parent's path
    double phase_shift = 0;       // of a follower, in cycles
    double contact = 0;           // share of the limb's border that meets what it hangs on (contact_shares)
    double width = 0;             // twice the mean distance to the silhouette's border along the path

    double length() const { return position.empty() ? 0 : position.back(); }
    Point2d at(double s) const; // point of the path at arc length s, clamped
};

// A branch of the skeleton that belongs to a limb (heel, finger, ear): it moves with the limb at `position`.
struct SideBranch {
    int limb = 0;
    double position = 0;       // of the fork along the limb's path
    std::vector<Point2d> path; // from the branch's end to the fork
};

struct Limbs {
    Point2d root; // the body's pivot: the skeleton point with label body that lies deepest inside
    std::vector<Limb> limbs;
    std::vector<SideBranch> side_branches;
};

// labels: every pixel has a label (nearest_labels), of the graph's size; depth: distance transform of the
// silhouette, pixels. Limbs that nothing drives are left out; there may be none. Parents come before what
// hangs on them, else limbs go by `end`.
Limbs find_limbs(const SkeletonGraph& graph, const LabelMap& labels, const Grid<float>& depth,
                 const ReferenceSkeleton& reference, const Mapping& mapping);

} // namespace pantin
