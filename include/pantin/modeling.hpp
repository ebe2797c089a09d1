// From strokes to skeletons and models (Ma et al., RealSkel: real-time skeletonization of user-sketched parts, 2021).
// Coordinates of strokes: any unit, x to the right, y up or down. Lengths that the paper gives in pixels of its canvas are shares of the
// stroke's diagonal, the diagonal of its bounding box, so that results do not depend on resolution (docs/errata.md).
#pragma once

#include <utility>
#include <vector>

#include "pantin/geometry.hpp"
#include "pantin/point.hpp"

namespace pantin {

// --- sub-skeleton (3.1) ------------------------------------------------------------------------------------

// An axis with the shape's half widths on both sides at points of equal arc length: the general cylinder of a branch.
struct Cylinder {
    std::vector<Point2d> axis;
    std::vector<double> left, right; // along the perpendicular, from the axis to the border
};
// Indices of the axis' points that are kept, ends included (Algorithm 1): the point with the largest error d⊥ + shape_weight · (d⁺ + d⁻)
// is kept while it exceeds the threshold. d⊥: from the point to the line through the ends; d⁺, d⁻: from the ends of its slice to the
// sides of the trapezoid between the first and the last slice, with the axis stretched straight.
std::vector<int> bounded_dp(const Cylinder& cylinder, double threshold, double shape_weight);

struct SubSkeletonOptions {
    SimplePolygonOptions polygon;
    double collapse = 0.5;         // of the mean edge: shorter edges of the straight skeleton are collapsed, …
    int collapse_rounds = 3;       // … so often
    double threshold = 0.0077;     // of BoundedDP at first, share of the diagonal; 5 pixels of the paper's canvas
    double least_threshold = 0.0015;
    double threshold_factor = 0.8; // by which it is lowered while a bone leaves the shape (Algorithm 2)
    double shape_weight = 0.25;    // α_s; the paper does not print it
};
struct SubSkeleton {
    struct Joint {
        Point2d place;
        double radius = 0; // distance to the outline
    };
    SimplePolygon outline;
    std::vector<Joint> joints;
    std::vector<std::pair<int, int>> bones; // a tree
};
// Straight skeleton, without its peripheral arcs (those that begin at the outline), short edges collapsed; every branch is smoothed by a
// spline, sliced evenly and simplified by BoundedDP, so that its bones stay inside the shape.
SubSkeleton sub_skeleton(const std::vector<Point2d>& stroke, const SubSkeletonOptions& options = {});

// --- refinement (3.3) --------------------------------------------------------------------------------------

// Thresholds, shares of the diagonal. A larger one never gives more joints; 0 does nothing.
struct RefinementOptions {
    double prune = 0.046;    // a branch that ends and is shorter goes
    double merge = 0.046;    // junctions so close along one branch become one
    double collapse = 0.015; // a shorter bone between two inner joints becomes a joint
};
// Prunes, merges and collapses, in this order. Of joints that become one the widest gives the place, the first one on a tie.
SubSkeleton refine(const SubSkeleton& skeleton, const RefinementOptions& options = {});

} // namespace pantin
