// SPDX-License-Identifier: MIT
// Outlines in one go, as quick drawings have them: head, body and tail without a line between them.
#pragma once

#include "doodle/figure.hpp"

namespace pantin::doodle {

// A closed outline of smooth stretches and corners.
class Contour {
public:
    Contour& to(Point2d p) {
        points.push_back(p);
        return *this;
    }
    // A smooth curve from the last point through these.
    Contour& through(Path controls);

    Path points;
};

// The rectangle that begins across `at` and reaches along `along`: the area of a piece of an outline.
Path beyond(Point2d at, Point2d along, double half_width, double length);
// Points p of the path with distance(p, c) ≥ r.
Path outside(const Path& path, Point2d c, double r);

// A leg of one line with toes, of two lines, or an open V or U; hangs at `hip`, behind the body.
void add_line_leg(Builder& b, int trunk, Point2d hip, Point2d foot, double heading, int manner);
// Three toes or a flat foot at the end of a line.
void add_toes(Builder& b, Point2d foot, double size, double heading);
// A wing folded against the trunk: closed, a U, a 3, a V, filled with scribble.
void add_folded_wing(Builder& b, Frame frame, double depth);

} // namespace pantin::doodle
