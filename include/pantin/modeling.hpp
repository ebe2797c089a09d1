// SPDX-License-Identifier: MIT
// From strokes to skeletons and models (Ma et al., RealSkel: real-time skeletonization of user-sketched
// parts, 2021). Coordinates of strokes: any unit, x to the right, y up or down. Lengths that the article
// gives in pixels of its canvas are shares of the stroke's diagonal, the diagonal of its bounding box, so
// that results do not depend on resolution (docs/errata.md).
#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "pantin/geometry.hpp"
#include "pantin/point.hpp"

namespace pantin {

// A part's outline as simple_polygon() gives it, with the holes in it.
struct PartOutline : SimplePolygon {
    PartOutline() = default;
    PartOutline(SimplePolygon polygon) : SimplePolygon(std::move(polygon)) {}
    // Apart from each other and from the border, in any orientation.
    std::vector<std::vector<Point2d>> holes;
};

// --- sub-skeleton (3.1) ------------------------------------------------------------------------------------

// An axis with the shape's half widths on both sides at points of equal arc length: the general cylinder of a
// branch.
struct Cylinder {
    std::vector<Point2d> axis;
    std::vector<double> left, right; // along the perpendicular, from the axis to the border
};
// Indices of the axis' points that are kept, ends included (Algorithm 1): the point with the largest error d⊥
// + shape_weight · (d⁺ + d⁻) is kept while it exceeds the threshold. d⊥: from the point to the line through
// the ends; d⁺, d⁻: from the ends of its slice to the sides of the trapezoid between the first and the last
// slice, with the axis stretched straight. threshold: the axis' units. No error. RealSkel 3.1, Algorithm 1.
std::vector<int> bounded_dp(const Cylinder& cylinder, double threshold, double shape_weight);

struct SubSkeletonOptions {
    SimplePolygonOptions polygon{300, 0.0006};
    // The skeleton is that of an outline simplified so far, share of the diagonal, or half as far as often as
    // it would leave the outline: a tremor below it leaves no trace.
    double coarsest = 0.015;
    // Of the straight skeleton all edges but those that begin at the outline, as printed: a sharp arm has no
    // axis then. Otherwise those that contribute to the shape (errata 23).
    bool printed_axis = false;
    double collapse = 0.5;     // of the mean edge: shorter edges of the straight skeleton are collapsed, …
    int collapse_rounds = 3;   // … so often
    double threshold = 0.0077; // of BoundedDP at first; 5 pixels of the article's canvas
    double least_threshold = 0.0015; // below it, 1 pixel, all slices are kept
    double threshold_factor = 0.8;   // by which it is lowered while a bone leaves the shape (Algorithm 2)
    double shape_weight = 0.25;      // α_s; the article does not print it
    // Instead of `threshold`, by number of the branch; −1: of all others (3.3, branch level).
    std::map<int, double> branch_thresholds;
};
struct SubSkeleton {
    struct Joint {
        Point2d place;
        double radius = 0; // distance to the outline
    };
    PartOutline outline;
    std::vector<Joint> joints;
    std::vector<std::pair<int, int>> bones; // a tree
    // Their joints from an end or a junction to the next one; numbered by the outline alone.
    std::vector<std::vector<int>> branches;
};
// The axis of a part, before it is simplified: what depends on its outline alone.
struct PartAxis {
    struct Branch {
        int from = 0, to = 0; // joints
        Cylinder cylinder;
    };
    PartOutline outline;
    std::vector<SubSkeleton::Joint> joints; // ends and junctions
    std::vector<Branch> branches;
    std::vector<SubSkeleton::Joint> discs; // at all nodes of the straight skeleton: they cover the shape
};
// Straight skeleton within an outline as simple_polygon() gives it, what of it is the axis, short edges
// collapsed; every branch is smoothed by a spline and sliced evenly. What is found on a coarser outline
// (options.coarsest) and would leave the outline itself is found anew on a finer one. Around a hole the axis
// is cut where it is thinnest. No error. RealSkel 3.1 (errata 23).
PartAxis part_axis(const PartOutline& outline, const SubSkeletonOptions& options = {});
// Every branch simplified by BoundedDP, so that its bones stay inside the shape. unit: the length whose
// shares the thresholds are. No error. RealSkel 3.1.
SubSkeleton sub_skeleton(const PartAxis& axis, double unit, const SubSkeletonOptions& options = {});
// All of it; thresholds are shares of the outline's diagonal. stroke: a closed outline, any unit.
// Error(input) as simple_polygon().
SubSkeleton sub_skeleton(const std::vector<Point2d>& stroke, const SubSkeletonOptions& options = {});

// --- skeletons in space ------------------------------------------------------------------------------------

// Joints of one part or of a whole model, joined to trees.
struct JointTree {
    struct Joint {
        Vec3 place;
        double radius = 0; // of the ball inscribed there (3.2)
        int part = 0;
        bool operator==(const Joint&) const = default;
    };
    std::vector<Joint> joints;
    std::vector<std::pair<int, int>> bones;
    bool operator==(const JointTree&) const = default;
};

// --- connection (3.2) --------------------------------------------------------------------------------------

// What connect() found for one part.
struct Attachment {
    int parent = -1;       // part; −1: a root
    int joint = -1;        // of the part, in the connected tree: where it hangs
    int parent_joint = -1; // that it hangs on, in the connected tree
    bool split = false;    // bone-split event: that joint is new, on a bone of the parent; else joint-connect
};
struct Connection {
    JointTree tree;
    std::vector<Attachment> attachments; // per part
};
// What is known of a part's parent before connect() searches for it.
struct ParentWish {
    int parent = -1; // this part, or its copy, whatever is met
    int like = -1;   // the part is a copy of this one: it hangs on the same part, or on that part's copy
};
// Connects the parts' skeletons in modelling order. A part hangs on the earlier part in whose balls and
// cylinders one of its ends or junctions lies, the nearest one by Eq. (1); else on one whose balls and
// cylinders meet its own; else it is a root. The joint and the bone of the smallest distance (Eq. 1) are
// joined: on the bone (bone-split event) when the foot of the perpendicular lies inside it, else at its
// nearer end (joint-connect event). wishes[i] is about part i and names earlier parts. Canvas
// units. No error. RealSkel 3.2 (errata 25 to 27).
// balls: per part what it consists of besides the balls and cylinders of its tree; none: no part has more.
Connection connect(const std::vector<JointTree>& parts, const std::vector<ParentWish>& wishes,
                   const std::vector<std::vector<JointTree::Joint>>& balls = {});

// --- refinement (3.3) --------------------------------------------------------------------------------------

// Thresholds, shares of the diagonal. Alone, a larger one never gives more joints; 0 does nothing.
struct RefinementOptions {
    double merge = 0.046;      // junctions so close along one branch become one
    double prune = 0.046;      // a branch that ends and is shorter goes
    double collapse = 0.015;   // a shorter bone between two inner joints becomes a joint
    double least_bone = 0.005; // any shorter bone becomes a joint (own)
};
RefinementOptions times(const RefinementOptions& shares, double length);
// Whether a bone of one part, between these places, stays inside it.
using StaysInside = std::function<bool(int part, Vec3 from, Vec3 to)>;
// Merges, prunes and collapses, in this order, and takes out what bones are too short. limits[part]: absolute
// lengths; between joints of two parts the larger one holds. Branches are pruned one after the other, the
// shortest first, each as long as it then is: of a fork with two short prongs one stays. Of joints that
// become one the widest gives the place, the first one on a tie; where a bone would leave its part (`inside`,
// if it is given) they stay two. No error. RealSkel 3.3 (errata 24).
JointTree refine(const JointTree& tree, const std::vector<RefinementOptions>& limits,
                 const StaysInside& inside = {});
// The same in the plane; shares of the outline's diagonal. No error. RealSkel 3.3.
SubSkeleton refine(const SubSkeleton& skeleton, const RefinementOptions& options = {});

// From the least to the largest threshold that makes a difference to a skeleton: the ends of a slider. Its
// unit.
struct ThresholdRange {
    double least = 0, most = 0;
};
struct ThresholdRanges {
    ThresholdRange merge;    // between two junctions along one branch
    ThresholdRange prune;    // branches that end
    ThresholdRange collapse; // bones between two inner joints
};
// "Calculated from the current geometric state of the skeleton"; 0 where there is nothing to change. No
// error. RealSkel 1 and 3.3.
ThresholdRanges threshold_ranges(const JointTree& tree);

} // namespace pantin
