// SPDX-License-Identifier: MIT
// The small languages inside SVG attributes: path data, transforms, lists of numbers and lengths (Scalable
// Vector Graphics (SVG) 2, W3C 2018, chapters 8 and 9). Every result is bit-identical on every platform.
//
// Errors are Error(input): `where`, which names file, element and attribute, then the position and the fact.
// SVG wants a bad path drawn up to the error; half a part would be a wrong model, so here it is an error.
#pragma once

#include <string>
#include <vector>

#include "pantin/point.hpp"

namespace pantin {

inline constexpr double svg_limit =
    1e15; // of the magnitude of every number and of every coefficient of a transform

// (x, y) ↦ (a·x + c·y + e, b·x + d·y + f), in the order of SVG's matrix().
struct Affine {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
    bool operator==(const Affine&) const = default;
};
inline Point2d operator*(const Affine& m, Point2d p) {
    return {m.a * p.x + m.c * p.y + m.e, m.b * p.x + m.d * p.y + m.f};
}
// First `inner`, then `outer`.
inline Affine operator*(const Affine& outer, const Affine& inner) {
    const Point2d o = outer * Point2d{inner.e, inner.f};
    return {outer.a * inner.a + outer.c * inner.b,
            outer.b * inner.a + outer.d * inner.b,
            outer.a * inner.c + outer.c * inner.d,
            outer.b * inner.c + outer.d * inner.d,
            o.x,
            o.y};
}
// Whether its coefficients are numbers within the limit.
bool is_moderate(const Affine& transform);

struct Subpath {
    std::vector<Point2d> points; // at least one; the first one may come back as the last one
    bool closed = false;         // by a Z
};
// The attribute `d`, moved by the transform, curves as chords. No chord is farther from its curve than 1/2000
// of the diagonal of the whole path's bounding box. Empty for "" and "none".
std::vector<Subpath> svg_path(const std::string& data, const Affine& transform, const std::string& where);

// The attribute `transform`; a list is applied from right to left.
Affine svg_transform(const std::string& text, const std::string& where);
// Numbers with white space or commas between them.
std::vector<double> svg_numbers(const std::string& text, const std::string& where);
// A number with a unit or none, in user units (CSS pixels, 96 an inch; fonts are 16 pixels large);
// percentages are of `whole`.
double svg_length(const std::string& text, const std::string& where, double whole);

} // namespace pantin
