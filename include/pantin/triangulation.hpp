// SPDX-License-Identifier: MIT
// Triangles inside polygons: the constrained Delaunay triangulation and its refinement to well shaped
// triangles.
#pragma once

#include <array>
#include <vector>

#include "pantin/point.hpp"

namespace pantin {

struct Triangulation {
    std::vector<Point2i> points;
    std::vector<std::array<int, 3>> triangles; // point indices, positively oriented
    std::vector<std::array<int, 3>>
        neighbours; // neighbours[t][i]: triangle across the edge opposite corner i, −1: the border
};

// The constrained Delaunay triangulation of the inside of loops (a border and its holes, simple, disjoint, in
// any orientation), |coordinate| < 2^22: every edge of a loop is one of its edges, or several when a corner
// lies on it, and no corner that is seen from inside a triangle lies in its circle (Chew 1989). Equal corners
// are one. Points keep the order of the loops' corners. Error(input) when nothing is inside. Sloan 1993;
// Prasad 1997 builds the chordal axis on it.
Triangulation constrained_delaunay(const std::vector<std::vector<Point2i>>& loops);

struct TriangleQuality {
    double longest_edge = 0;  // longer edges are split; 0: any length
    double shortest_edge = 4; // no edge is split to shorter ones
    double ratio = 1.42; // of circumradius to shortest edge, at most; √2 is an angle of 20.7° (Ruppert 1995)
    bool free_chords = true; // edges inside that join two points of the border are split: no triangle has its
                             // three corners on it
    int most_points = 200000;
};
// Delaunay refinement (Ruppert 1995): circumcentres of bad triangles are inserted, edges of the border that
// they lie beyond or encroach upon are halved. New points are rounded to whole coordinates, so that every
// predicate stays exact; the border moves by less than one unit. Lengths in units of the coordinates. No
// errors; it stops at `most_points`, where bad triangles may be left.
Triangulation refined(const Triangulation& triangulation, const TriangleQuality& quality);

} // namespace pantin
