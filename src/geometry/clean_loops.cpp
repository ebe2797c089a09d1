// SPDX-License-Identifier: MIT
// In come loops as they were drawn, out go simple lists of corners with the interior on the left, fit for the
// straight skeleton (Ma et al. 2021, 3.1). Our own.
#include "geometry/clean_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/extent.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw Error(ErrorKind::input, "straight skeleton: " + what);
}

double diagonal_of_all(const std::vector<std::vector<Point2d>>& loops) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point2d low{infinity, infinity}, high{-infinity, -infinity};
    for (const auto& loop : loops)
        for (const Point2d& p : loop) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y)) fail("a coordinate is not a number");
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    if (loops.empty() || low.x > high.x) fail("there is no corner");
    return distance(low, high);
}

// Whether a corner is the same as the one before, or on the straight line between its neighbours.
bool is_idle(Point2d before, Point2d corner, Point2d after, double small) {
    const Point2d u = corner - before, v = after - corner;
    if (length(u) <= small) return true;
    return length(v) > small && std::abs(cross(u, v)) <= small * std::max(length(u), length(v)) &&
           dot(u, v) > 0;
}

// Leaves out idle corners, once around; those that stay move to the front.
void clean_once(std::vector<Point2d>& loop, double small) {
    std::size_t kept = 0, i = 0;
    for (; i < loop.size() && kept + loop.size() - i >= 3; ++i) {
        const Point2d before = kept > 0 ? loop[kept - 1] : loop.back();
        const Point2d after = i + 1 < loop.size() ? loop[i + 1] : loop.front();
        if (!is_idle(before, loop[i], after, small)) loop[kept++] = loop[i];
    }
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(kept),
               loop.begin() + static_cast<std::ptrdiff_t>(i));
}

std::vector<Point2d> cleaned(std::vector<Point2d> loop, bool outer, double small) {
    for (std::size_t before = 0; loop.size() != before && loop.size() >= 3;) {
        before = loop.size();
        clean_once(loop, small);
    }
    if (loop.size() < 3) fail("a loop has fewer than three corners");
    const double area = area_of(loop);
    if (area == 0) fail("a loop has no area");
    if ((area > 0) != outer) std::reverse(loop.begin(), loop.end());
    return loop;
}

} // namespace

CleanLoops clean_loops(const std::vector<std::vector<Point2d>>& loops, double tolerance) {
    CleanLoops clean;
    clean.diagonal = diagonal_of_all(loops);
    for (std::size_t l = 0; l < loops.size(); ++l)
        clean.loops.push_back(cleaned(loops[l], l == 0, tolerance * clean.diagonal));
    return clean;
}

} // namespace pantin
