// SPDX-License-Identifier: MIT
// The Voronoi skeleton of a mask (thesis 3.4): sites on the borders, residuals, rasterisation.
#pragma once

#include <vector>

#include "pantin/geometry.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

// Where a border passes a site: arc length from the border's first point.
struct Visit {
    int border = 0;
    double position = 0;
};

// The distinct pixels of all borders, in the order in which the borders first reach them.
struct BorderSites {
    std::vector<Point2i> points;
    std::vector<std::vector<Visit>> visits; // per point
    std::vector<double> lengths;            // per border
};
BorderSites border_sites(const std::vector<Border>& borders, int width, int height);

// Length of border between two sites, the shorter way round, the smallest over repeated visits; infinite when
// no border visits both.
double border_arc(const BorderSites& sites, int a, int b);

// Residual of a Voronoi edge between two sites (ERRATA 1, 2).
double residual_between(const BorderSites& sites, int a, int b, Residual kind);
// Residual of a pixel that lies on a border more than once, its own opposite (ERRATA 3): the smallest arc
// between two of its visits, infinite between two borders; −1 for a pixel that is visited once. Both kinds
// agree.
double neck_residual(const std::vector<Visit>& visits, const std::vector<double>& lengths);

// Whether both ends of a Voronoi edge, rounded to pixels, lie in the mask.
bool edge_inside(const VoronoiEdge& edge, const Mask& mask);

// Edges and necks whose residual reaches the threshold, as pixels of the mask.
Mask rasterise(const std::vector<VoronoiEdge>& edges, const std::vector<double>& residuals,
               const BorderSites& sites, const Mask& mask, double threshold);

// The pixels of the straight line from a to b, both ends included (Bresenham 1965).
std::vector<Point2i> straight_line(Point2i a, Point2i b);

} // namespace pantin
