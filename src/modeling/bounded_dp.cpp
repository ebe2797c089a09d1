// SPDX-License-Identifier: MIT
// Ma et al. 2021, Algorithm 1.
#include <algorithm>
#include <cmath>

#include "pantin/modeling.hpp"

namespace pantin {
namespace {

// Distance of a point to the line through a and b; to a where they coincide.
double line_distance(Point2d p, Point2d a, Point2d b) {
    const double span = distance(a, b);
    return span > 0 ? std::abs(cross(b - a, p - a)) / span : distance(p, a);
}

} // namespace

std::vector<int> bounded_dp(const Cylinder& cylinder, double threshold, double shape_weight) {
    const int count = static_cast<int>(cylinder.axis.size());
    std::vector<double> along(count, 0.0); // arc length: the axis stretched straight
    for (int i = 1; i < count; ++i)
        along[i] = along[i - 1] + distance(cylinder.axis[i - 1], cylinder.axis[i]);
    const auto side_error = [&](const std::vector<double>& width, int i, int first, int last) {
        return line_distance({along[i], width[i]}, {along[first], width[first]}, {along[last], width[last]});
    };
    std::vector<char> keep(count);
    if (count > 0) keep.front() = keep.back() = 1;
    std::vector<std::pair<int, int>> pending = {{0, count - 1}};
    while (!pending.empty()) {
        const auto [first, last] = pending.back();
        pending.pop_back();
        int best = -1;
        double largest = threshold;
        for (int i = first + 1; i < last; ++i) {
            const double error = line_distance(cylinder.axis[i], cylinder.axis[first], cylinder.axis[last]) +
                                 shape_weight * (side_error(cylinder.left, i, first, last) +
                                                 side_error(cylinder.right, i, first, last));
            if (error > largest) largest = error, best = i;
        }
        if (best < 0) continue;
        keep[best] = 1;
        pending.emplace_back(first, best);
        pending.emplace_back(best, last);
    }
    std::vector<int> kept;
    for (int i = 0; i < count; ++i)
        if (keep[i]) kept.push_back(i);
    return kept;
}

} // namespace pantin
