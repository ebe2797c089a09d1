// SPDX-License-Identifier: MIT
// Which limb every pixel and mesh vertex belongs to, measured inside the silhouette.
#pragma once

#include "pantin/grid.hpp"
#include "rigging/limbs.hpp"

namespace pantin {

struct Owner {
    int limb = -1;       // −1: the body
    double position = 0; // along the limb's path
    bool operator==(const Owner&) const = default;
};

// Geodesic nearest path point (8-connected, steps 5 and 7) inside the silhouette. A pixel is reached first
// through pixels of the label on which the path point lies; what no path reaches so takes the owner of its
// nearest neighbour inside the silhouette, then of the nearest pixel anywhere. Every pixel of the grid gets
// an owner. `skeleton`: all points of the skeleton; those on no limb belong to the body.
Grid<Owner> pixel_owners(const Limbs& limbs, const std::vector<Point2d>& skeleton, const Mask& silhouette,
                         const LabelMap& labels);

// Per limb: of the border of its pixels towards the background and towards the body or the limb that it hangs
// on, the share of the latter. A leg has little of it, a wing folded on the back or an arm along the body
// half or more.
std::vector<double> contact_shares(const Limbs& limbs, const Grid<Owner>& owners, const Mask& silhouette);

// All points of the skeleton graph.
std::vector<Point2d> skeleton_points(const SkeletonGraph& graph);

} // namespace pantin
