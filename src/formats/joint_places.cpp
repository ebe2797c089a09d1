// SPDX-License-Identifier: MIT
// A silhouette and joints in, how many of these belong elsewhere out.
#include "formats/joint_places.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

constexpr double near = 0.05; // of the diagonal of the silhouette's box

double diagonal_of_box(const Mask& mask) {
    int left = mask.width(), right = -1, top = mask.height(), bottom = -1;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (!mask(x, y)) continue;
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    return right < 0 ? 0 : distance(to_double({left, top}), to_double({right + 1, bottom + 1}));
}

bool has_pixel_within(const Mask& mask, Point2d p, double reach) {
    // Joints lie less than three pictures away (read_joints), so that the corners are whole numbers.
    const auto first = [&](double v) { return std::max(0, static_cast<int>(std::ceil(v - reach))); };
    const auto last = [&](double v, int size) {
        return std::min(size - 1, static_cast<int>(std::floor(v + reach)));
    };
    for (int y = first(p.y); y <= last(p.y, mask.height()); ++y)
        for (int x = first(p.x); x <= last(p.x, mask.width()); ++x)
            if (mask(x, y) && distance(p, to_double({x, y})) <= reach) return true;
    return false;
}

} // namespace

int joints_outside(const Mask& mask, const std::vector<FigureJoint>& joints) {
    const double reach = near * diagonal_of_box(mask);
    return static_cast<int>(std::count_if(joints.begin(), joints.end(), [&](const FigureJoint& joint) {
        return !has_pixel_within(mask, joint.place, reach);
    }));
}

} // namespace pantin
