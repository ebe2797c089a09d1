// SPDX-License-Identifier: MIT
// How far a clip stretches the mesh (thesis 6.3, Fig. 6.9), and the pose in which it does so most.
#pragma once

#include <utility>
#include <vector>

#include "figures/gallery.hpp"
#include "figures/svg.hpp"

namespace pantin::figures {

// Over all key poses of a clip, of one edge of the mesh: length / length at rest, in 3D. Edges shorter than a
// hundredth of the mean are left out, as tools/motion_quality does.
struct Stretch {
    double largest = 1;
    double time = 0; // of the pose with the largest one, seconds
};
Stretch stretch_of(const Rig& rig, const BoneAnimation& animation);

// The mesh in the pose at that time, the edges that are longer there than `limit` times their length at rest
// in red.
void draw_stretched(Svg& svg, Rectangle place, const Rig& rig, const BoneAnimation& animation, double time,
                    double limit);

} // namespace pantin::figures
