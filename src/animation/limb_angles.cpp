// SPDX-License-Identifier: MIT
#include "animation/limb_angles.hpp"

#include <cmath>

#include "core/math.hpp"

namespace pantin {
namespace {

constexpr double still = 1e-3; // variance of a limb's tip, of its squared length, that decides nothing
constexpr double hardly_moves = 0.02;
// Of a limb's squared length, the least that a view must show of it: of one that moves, of one that does not.
constexpr double least_shown = 0.35, least_shown_still = 0.75;
constexpr double least_projection = 0.2; // of a limb's length: shorter ones have no direction

} // namespace

Directions directions_of(const std::vector<RecordedPose>& poses, int a, int b) {
    Directions all;
    for (const RecordedPose& p : poses)
        all.push_back(p.joints[static_cast<std::size_t>(b)] - p.joints[static_cast<std::size_t>(a)]);
    return all;
}

bool seen_from_the_side(const Directions& limb) {
    Vec3 mean, squares;
    const double n = static_cast<double>(limb.size());
    for (const Vec3& v : limb) {
        mean = mean + (1 / n) * v;
        squares = squares + (1 / n) * Vec3{v.x * v.x, v.y * v.y, v.z * v.z};
    }
    const double x = squares.x - mean.x * mean.x, z = squares.z - mean.z * mean.z;
    const double size = squares.x + squares.y + squares.z;
    const bool side = z > x + still * size;
    const double front_shows = squares.x + squares.y, side_shows = squares.z + squares.y;
    const double least =
        (x > hardly_moves * size || z > hardly_moves * size ? least_shown : least_shown_still);
    const double shown = side ? side_shows : front_shows, other = side ? front_shows : side_shows;
    return shown < least * size && other > shown ? !side : side;
}

std::vector<double> angles_in_picture(const Directions& limb, const std::vector<RecordedPose>& poses,
                                      bool from_the_side) {
    std::vector<double> angles;
    std::size_t unknown = 0; // at the beginning
    for (std::size_t i = 0; i < limb.size(); ++i) {
        const Vec3 v = limb[i];
        const Point2d d{from_the_side ? poses[i].forwards * v.z : v.x, v.y};
        const bool clear = length(d) > least_projection * length(v) && length(v) > 1e-9;
        if (!clear && unknown == i) ++unknown;
        angles.push_back(clear ? math::atan2(d.y, d.x) : angles.empty() ? 0 : angles.back());
        if (clear && unknown == i)
            for (std::size_t k = 0; k < i; ++k) angles[k] = angles[i];
    }
    if (unknown == limb.size()) angles.clear();
    return angles;
}

double nearest_turn(double angle, double near) {
    return angle + 2 * math::pi * std::rint((near - angle) / (2 * math::pi));
}

} // namespace pantin
