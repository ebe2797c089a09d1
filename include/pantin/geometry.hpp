// SPDX-License-Identifier: MIT
// Points, polygons and the structures on them. Coordinates that decide topology are integers, so every sign
// is exact. A function that names no error throws none; coordinates beyond its limits give wrong results.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

// --- exact predicates (|coordinate| < 2^24) ----------------------------------------------------------------

// Sign of the signed area of (a, b, c): +1 when c lies to the left of a→b in a y-up frame, 0 on the line, −1.
// No errors. Guibas & Stolfi 1985 (CCW).
int orientation(Point2i a, Point2i b, Point2i c);
// +1 when d lies inside the circumcircle of the positively oriented triangle (a, b, c), 0 on it, −1 outside.
// No errors. Guibas & Stolfi 1985 (InCircle), in 128-bit integers.
int in_circle(Point2i a, Point2i b, Point2i c, Point2i d);

// --- Delaunay and Voronoi ----------------------------------------------------------------------------------

struct Delaunay {
    std::vector<std::array<int, 3>> triangles; // point indices, positively oriented
    std::vector<std::array<int, 3>>
        neighbours; // neighbours[t][i]: triangle across the edge opposite corner i, −1 hull
};
// Delaunay triangulation, |coordinate| < 2^24. Of equal points only the first is used; no triangles without
// three points that are not collinear. How cocircular points are split follows from a rule (delaunay.cpp) on
// the set of points alone, not on their order. No errors. Guibas & Stolfi 1985; thesis 3.4.
Delaunay delaunay(const std::vector<Point2i>& points);

// Centre of the circle through three points that are not collinear, |coordinate| < 2^24, in their unit. Exact
// up to the last rounding, so that of cocircular triangles it is the same to the bit. No errors; collinear
// points give coordinates that are not finite. Own arithmetic.
Point2d circumcentre(Point2i a, Point2i b, Point2i c);
// An edge of the Voronoi diagram: dual of the Delaunay edge between two sites.
struct VoronoiEdge {
    Point2d from, to;           // circumcentres
    int site_a = 0, site_b = 0; // indices of the two nearest sites
};
// All finite Voronoi edges. Between cocircular triangles `from` == `to`, to the bit: where four sites or more
// lie on one circle the diagram has one vertex, and the edges of no length depend on how the triangulation
// splits them. `triangulation`: delaunay(points). No errors. Thesis Def. 3.4.1, Fig. 3.13.
std::vector<VoronoiEdge> voronoi_edges(const std::vector<Point2i>& points, const Delaunay& triangulation);

// --- borders (Suzuki & Abe 1985) ---------------------------------------------------------------------------

// A closed chain of 8-connected border pixels, in tracing order; a pixel on a one-pixel neck occurs twice.
struct Border {
    bool outer = true; // outer border, or border of a hole
    int parent = -1;   // index of the enclosing border, −1 for the frame
    std::vector<Point2i> points;
};
// Border following with full hierarchy (Suzuki & Abe 1985, Algorithm 1), borders in raster order of their
// start, points in pixels. The order of points equals that of OpenCV's findContours(RETR_TREE,
// CHAIN_APPROX_NONE). No errors; an empty mask has no border. Thesis 4.4, Fig. 4.9.
std::vector<Border> follow_borders(const Mask& mask);
// Sum of the steps of a closed border, in pixels: 1 along an axis, √2 along a diagonal. 0 for a single pixel.
// No errors. Own; the border of thesis Fig. 3.14 is measured by it.
double closed_length(const std::vector<Point2i>& border);

// --- polylines ---------------------------------------------------------------------------------------------

// Sum of the distances of consecutive points, in their unit; 0 for fewer than two. No errors. Own.
double polyline_length(const std::vector<Point2d>& line);
// `count` ≥ 2 points at equal arc length along a line of at least one point, ends included. No errors. Ma et
// al. 2021, 3.1 (even sampling of a stroke).
std::vector<Point2d> resample(const std::vector<Point2d>& line, int count);
// The indices kept, ascending, ends included; what is dropped lies within `tolerance` (≥ 0, in the unit of
// the points) of its segment. No errors. Douglas & Peucker 1973; Ma et al. 2021, 3.1.
std::vector<int> douglas_peucker(const std::vector<Point2d>& line, double tolerance);

// --- simple polygons (Ma et al. 2021, section 3.1) ---------------------------------------------------------

struct SimplePolygonOptions {
    int samples = 200;         // points on the stroke at equal arc length; 0: the stroke's own points
    double tolerance = 0.0025; // of Douglas–Peucker, share of the diagonal
    int finer = 3;             // how often a tenth of it is tried on a stroke that it flattens
    // A lobe beyond a crossing stays when its area is this share of the rest's or its diagonal the other one
    // of the rest's; it hangs on a neck so wide, of the diagonal.
    double lobe_area = 0.03, lobe_size = 0.2, neck = 0.02;
};
struct SimplePolygon {
    std::vector<Point2d> corners; // interior on the left where y points up
    int cut = 0;                  // crossings that were cut off, each with the smaller of its two loops
    int joined = 0;               // crossings that became necks between two lobes
    int uncrossed = 0;            // crossings of a thin strip, whose sides were exchanged
};
// Closes the stroke (points in any unit, the result in the same), samples it evenly, simplifies it and takes
// its crossings out, that of the shortest loop first: a loop that lies outside the rest and is no slip of the
// pen is joined to it by a neck, so that both lobes of a figure eight stay; what the rest covers, or is
// small, is cut off; a thin strip, which cutting would take a piece of its length, is uncrossed. A stroke so
// thin that nothing of its area is left is simplified with a tenth of the tolerance, up to `finer` times
// (own). Error(input) for a coordinate that is not a number and for a stroke without area. Ma et al.
// 2021, 3.1, "Simple polygon acquisition" (errata 23).
SimplePolygon simple_polygon(const std::vector<Point2d>& stroke, const SimplePolygonOptions& options = {});
// A simple polygon by Douglas–Peucker with the tolerance (its unit), or with a quarter of it as often as the
// result would cross itself or lose a tenth of its area. No error. Ma et al. 2021, 3.1.
std::vector<Point2d> coarser_polygon(const std::vector<Point2d>& polygon, double tolerance);

} // namespace pantin
