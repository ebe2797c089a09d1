// SPDX-License-Identifier: MIT
// The Voronoi diagram as the dual of the Delaunay triangulation (thesis Def. 3.4.1): points and triangles in,
// edges between circumcentres out.
#include "geometry/wide_integer.hpp"
#include "pantin/geometry.hpp"

namespace pantin {
namespace {

WideInteger greatest_common_divisor(WideInteger a, WideInteger b) {
    if (a < 0) a = -a;
    while (b != 0) {
        const WideInteger r = a % b;
        a = b;
        b = r;
    }
    return a;
}

// numerator / denominator, denominator > 0. A function of the rational number alone, however it is written,
// so that cocircular triangles get the same centre to the bit: both sides are exact doubles, or else reduced
// first.
double quotient(WideInteger numerator, WideInteger denominator) {
    constexpr WideInteger exact = std::int64_t{1} << 53;
    if (numerator > exact || numerator < -exact || denominator > exact) {
        const WideInteger divisor = greatest_common_divisor(numerator, denominator);
        numerator /= divisor;
        denominator /= divisor;
    }
    return static_cast<double>(numerator) / static_cast<double>(denominator);
}

} // namespace

Point2d circumcentre(Point2i a, Point2i b, Point2i c) {
    const auto squared = [](Point2i p) {
        return static_cast<std::int64_t>(p.x) * p.x + static_cast<std::int64_t>(p.y) * p.y;
    };
    const WideInteger aa = squared(a), bb = squared(b), cc = squared(c);
    const std::int64_t ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
    const WideInteger denominator = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by));
    return {quotient(aa * (by - cy) + bb * (cy - ay) + cc * (ay - by), denominator),
            quotient(aa * (cx - bx) + bb * (ax - cx) + cc * (bx - ax), denominator)};
}

std::vector<VoronoiEdge> voronoi_edges(const std::vector<Point2i>& points, const Delaunay& triangulation) {
    const auto& triangles = triangulation.triangles;
    std::vector<Point2d> centres;
    centres.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) centres.push_back(circumcentre(points[a], points[b], points[c]));
    std::vector<VoronoiEdge> edges;
    edges.reserve(triangles.size() * 3 / 2);
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
        for (int i = 0; i < 3; ++i) {
            const int other = triangulation.neighbours[t][i];
            if (other > t)
                edges.push_back(
                    {centres[t], centres[other], triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]});
        }
    return edges;
}

} // namespace pantin
