// SPDX-License-Identifier: MIT
// Parts of the label map as pieces of the silhouette, for parts in which the skeleton has no end-effector.
#pragma once

#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/point.hpp"

namespace pantin {

struct PartComponent {
    Label label = Label::limb;
    std::vector<Point2i> pixels; // raster order
    double free_share = 0;       // of its border that meets the background
    Point2i attachment; // the border pixel towards other parts that lies nearest to the middle of all of them
    std::vector<Point2d> path; // inside the part, from the attachment to the pixel farthest from it
};

// 8-connected components of one label inside the silhouette (depth > 0) with at least `min_area` pixels and a
// border to another part, labels ascending, then raster order. Paths prefer the middle of the part.
std::vector<PartComponent> part_components(const LabelMap& labels, const Grid<float>& depth, int min_area);

} // namespace pantin
