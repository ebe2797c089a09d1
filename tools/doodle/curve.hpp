// SPDX-License-Identifier: MIT
// Curves that drawings are made of: splines, ellipses, ribbons along a midline, and their resampling.
// Points are in the figure's own units or in pixels, y down; a closed path does not repeat its first point.
#pragma once

#include <vector>

#include "core/random.hpp"
#include "pantin/point.hpp"

namespace pantin::doodle {

using Path = std::vector<Point2d>;

// An outline or a line of which some vertices are not drawn (an open foot, the seam of a limb).
struct Outline {
    Path points;
    std::vector<char> undrawn; // one per point: the stretch from this point to the next has no line
    bool closed = true;
};

inline Point2d mix(Point2d a, Point2d b, double t) { return a + t * (b - a); }
Point2d rotated(Point2d v, double angle); // y down: a positive angle turns clockwise on the page
Point2d direction(double angle);          // (cos, sin)
Point2d unit(Point2d v);                  // (1, 0) for the zero vector

double path_length(const Path& path, bool closed = false);
// Catmull–Rom through all points.
Path spline(const Path& points, bool closed, int steps = 8);
// Superellipse |x/rx|^e + |y/ry|^e = 1 turned by `angle`; exponent 2 is an ellipse, 4 nearly a rectangle.
Path ellipse(Point2d centre, double rx, double ry, double angle = 0.0, double exponent = 2.0);
// Points every `step` along the path (at least 2); flags follow their stretch.
Outline resample(const Outline& outline, double step);
Path resample(const Path& path, double step, bool closed = false);
// Douglas–Peucker with a distance tolerance; an open path.
Path simplify(const Path& path, double tolerance);

enum class Cap { round, flat, pointed };
struct RibbonEnds {
    Cap start = Cap::round, end = Cap::round;
    bool open_start = false, open_end = false; // the cap has no line
};
// The outline of a limb: a band around a smooth midline whose radii are interpolated along its length.
Outline ribbon(const Path& midline, const std::vector<double>& radii, RibbonEnds ends = {});

// Smooth periodic noise in about [−1, 1] over t in [0, 1): the hand's slow deviations.
class Waver {
public:
    Waver(Random& random, int harmonics, double falloff = 1.0);
    double operator()(double t) const;

private:
    std::vector<Point2d> waves_; // amplitude of cosine and sine per harmonic
};

} // namespace pantin::doodle
