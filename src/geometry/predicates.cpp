// SPDX-License-Identifier: MIT
// Exact signs of determinants of integer points (Guibas & Stolfi 1985, CCW and InCircle), in 64 or 128 bits.
#include "geometry/wide_integer.hpp"
#include "pantin/geometry.hpp"

#include <algorithm>
#include <cstdlib>

namespace pantin {
namespace {

template <class Integer> int sign(Integer value) { return (value > 0) - (value < 0); }

// Guibas & Stolfi 1985: the lifted points' determinant, with d as the origin.
template <class Integer> int in_circle_as(Point2i a, Point2i b, Point2i c, Point2i d) {
    const Integer ax = a.x - d.x, ay = a.y - d.y;
    const Integer bx = b.x - d.x, by = b.y - d.y;
    const Integer cx = c.x - d.x, cy = c.y - d.y;
    return sign<Integer>((ax * ax + ay * ay) * (bx * cy - cx * by) +
                         (bx * bx + by * by) * (cx * ay - ax * cy) +
                         (cx * cx + cy * cy) * (ax * by - bx * ay));
}

int reach(Point2i p, Point2i d) { return std::max(std::abs(p.x - d.x), std::abs(p.y - d.y)); }

} // namespace

int orientation(Point2i a, Point2i b, Point2i c) {
    const std::int64_t abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
    return sign(abx * acy - aby * acx);
}

int in_circle(Point2i a, Point2i b, Point2i c, Point2i d) {
    // Differences below 2^14: every product stays below 2^58 and the sum below 2^60. Else up to 2^104.
    constexpr int small = 1 << 14;
    if (reach(a, d) < small && reach(b, d) < small && reach(c, d) < small)
        return in_circle_as<std::int64_t>(a, b, c, d);
    return in_circle_as<WideInteger>(a, b, c, d);
}

} // namespace pantin
