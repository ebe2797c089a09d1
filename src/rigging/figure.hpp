// SPDX-License-Identifier: MIT
// What the path distance compares: a skeleton inside a shape (thesis 4.6).
#pragma once

#include "pantin/grid.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

struct Figure {
    SkeletonGraph graph;
    Grid<int> squared_distance; // of every pixel to the outside of the shape
    double mean_distance = 0;   // mean of the distance over the shape's pixels, > 0
};
Figure make_figure(SkeletonGraph graph, const Mask& shape);

} // namespace pantin
