// SPDX-License-Identifier: MIT
// The straight skeleton of a polygon (Aichholzer et al. 1995; Ma et al. 2021, section 3.1, Algorithm 3): its
// edges move inward at unit speed, each along its own perpendicular; the skeleton is what the corners trace.
#pragma once

#include <vector>

#include "pantin/point.hpp"

namespace pantin {

struct StraightSkeleton {
    struct Node {
        Point2d place;
        double time = 0; // when the moving edges meet there: the distance to the lines of its edges
    };
    // A corner of the moving polygon on its way from one node to another: it lies between two edges and is
    // equally far from both.
    struct Arc {
        int from = 0, to = 0;
        int left = 0,
            right = 0; // edges: on the left and on the right of the way; the corner comes after `left`
    };
    std::vector<Point2d>
        corners;           // of all loops, one after the other, interiors on the left (x to the right, y up)
    std::vector<int> next; // corner after each: edge i runs from corner i to corner next[i]
    std::vector<Node> nodes; // the corners first, at time 0
    std::vector<Arc> arcs;
};

// loops: the outer border and the borders of holes, simple and disjoint, in either orientation; consecutive
// equal points and points on a straight line between their neighbours are left out. Coordinates of any size;
// lengths below 1e-9 of the diagonal count as zero. Events are taken in the order of time, then edge events
// before split events, then of their edges' numbers. Error(input) when a loop has fewer than three corners
// left or an area of zero, or a coordinate is not a number. Time: about n log n for n corners, by an index of
// the moving edges; more, up to about n^1.5, for thousands of needle-thin spikes, and n² where a good part of
// all corners meets at one place, as in regular stars. Loops that cross get a result in several attempts.
// Places and times in the unit of the loops. Felkel & Obdržálek 1998; Ma et al. 2021, Algorithm 3.
StraightSkeleton straight_skeleton(const std::vector<std::vector<Point2d>>& loops);

} // namespace pantin
