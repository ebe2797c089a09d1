// SPDX-License-Identifier: MIT
// Limbs to bones (thesis 4.6; joints of the reference skeleton).
#pragma once

#include <vector>

#include "rigging/limbs.hpp"

namespace pantin {

// Bones of one limb: bone first + i covers the arc [joints[i], joints[i + 1]] of the path.
struct LimbBones {
    int first = 0;
    std::vector<double> joints;
    int count() const { return static_cast<int>(joints.size()) - 1; }
};

// A bone of the trunk that turns the part of the body beyond a joint of the spine: the chest against the
// hips.
struct SpineBone {
    int bone = -1;
    Point2d pivot, direction; // unit vector along the spine, away from the root
    double blend = 0; // half the way along the spine over which the weights pass from one side to the other
};

struct Skeleton {
    std::vector<Bone> bones;      // bone 0 is the body
    std::vector<LimbBones> limbs; // parallel to Limbs::limbs
    std::vector<SpineBone> spine; // at most one for each joint of the reference that moves a node of the body
};

// `head_centre`: the middle of the head's pixels; a head's bone points there, not to an ear.
Skeleton make_bones(const Limbs& limbs, const ReferenceSkeleton& reference, bool mirrored, int limb_segments,
                    Point2d head_centre);

// One bone per mapped end-effector, from its neighbour in the graph to the end (thesis 4.6, ERRATA 20).
std::vector<Bone> make_thesis_bones(const SkeletonGraph& graph, const ReferenceSkeleton& reference,
                                    const Mapping& mapping, bool mirrored, Point2d root);

} // namespace pantin
