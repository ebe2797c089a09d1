// SPDX-License-Identifier: MIT
// Limbs that the mesh joins, and how far a clip pulls the mesh between them (thesis 6.3, Fig. 6.9).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "figures/gallery.hpp"
#include "figures/svg.hpp"

namespace pantin::figures {

// Edges of the mesh from a vertex of one limb to a vertex of another. A vertex is of the limb whose bones
// move it most, if they have a quarter of its weight.
struct JoinedLimbs {
    std::vector<std::pair<int, int>> edges;
    // Of the edge that the clip stretches most: length / length at rest, in 3D as in tools/motion_quality,
    // the pose in seconds, and the two limbs by name; 1, 0 and none without edges.
    double largest = 1, time = 0;
    std::string first, second;
};
JoinedLimbs joined_limbs_of(const Rig& rig, const BoneAnimation& animation);

// The two limbs that the clip pulls apart most (there must be some) at that time, cut out of the posed mesh,
// each in a shade of its own, the edges between limbs in red.
void draw_joined(Svg& svg, Rectangle place, const Rig& rig, const BoneAnimation& animation,
                 const JoinedLimbs& joined);

} // namespace pantin::figures
