// SPDX-License-Identifier: MIT
#include "animation/body_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pantin {
namespace {

constexpr double along = 0.7;            // cosine of a direction that counts as that of an axis
constexpr double across = 0.6;           // of one that counts as across it, at most
constexpr std::size_t most_frames = 200; // that are looked at

constexpr std::array<Vec3, 6> axes = {{{0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}}};

double cosine(Vec3 a, Vec3 axis) {
    const double n = length(a);
    return n > 1e-9 ? dot(a, axis) / n : 0;
}

Vec3 nearest_axis(Vec3 direction) {
    return *std::max_element(axes.begin(), axes.end(), [&](const Vec3& a, const Vec3& b) {
        return dot(direction, a) < dot(direction, b);
    });
}

bool on_four(const LimbDirections& d, Vec3 up) {
    return cosine(d.arms, up) < -0.5 && std::abs(cosine(d.trunk, up)) < across;
}

double arms_to_legs(const Motion& motion, const MotionJoints& joints) {
    const std::vector<Vec3> pose = joint_positions(motion, 0);
    const auto bone = [&](int a, int b) {
        return distance(pose[static_cast<std::size_t>(a)], pose[static_cast<std::size_t>(b)]);
    };
    double arms = 0, legs = 0;
    for (const auto& s : {joints.left, joints.right}) {
        arms += bone(s.upper_arm, s.forearm) + bone(s.forearm, s.hand);
        legs += bone(s.thigh, s.shin) + bone(s.shin, s.foot);
    }
    return legs > 0 ? arms / legs : 0;
}

} // namespace

LimbDirections limb_directions(const std::vector<Vec3>& pose, const MotionJoints& joints) {
    const auto at = [&](int joint) { return pose[static_cast<std::size_t>(joint)]; };
    const auto& [l, r] = std::pair(joints.left, joints.right);
    const Vec3 thighs = 0.5 * (at(l.thigh) + at(r.thigh)), arms = 0.5 * (at(l.upper_arm) + at(r.upper_arm));
    return {0.5 * (at(l.foot) + at(r.foot)) - thighs, 0.5 * (at(l.hand) + at(r.hand)) - arms, arms - thighs};
}

BodyAxes body_axes(const Motion& motion, const MotionJoints& joints) {
    BodyAxes result;
    const LimbDirections rest = limb_directions(rest_positions(motion), joints);
    result.up = nearest_axis(-1 * rest.legs);
    if (cosine(rest.legs, result.up) < -along) {
        result.on_four_legs = on_four(rest, result.up);
        result.stands_at_rest =
            result.on_four_legs || cosine(rest.trunk, result.up) > along || joints.plan == BodyPlan::bird;
        if (result.stands_at_rest) return result;
    }
    Vec3 standing, on_limbs;
    std::vector<LimbDirections> poses;
    const std::size_t step = std::max<std::size_t>(1, motion.frames() / most_frames);
    for (std::size_t i = 0; i < motion.frames(); i += step) {
        poses.push_back(limb_directions(joint_positions(motion, i), joints));
        const auto& [legs, arms, trunk] = poses.back();
        standing = standing + trunk - legs;
        on_limbs = on_limbs - legs - arms;
    }
    const Vec3 up_on_four = nearest_axis(on_limbs);
    const auto four = std::count_if(poses.begin(), poses.end(),
                                    [&](const LimbDirections& d) { return on_four(d, up_on_four); });
    // A person who crawls now and then is none, nor one who crawls all the time: arms are shorter than legs.
    result.on_four_legs = static_cast<double>(four) > 0.8 * static_cast<double>(poses.size()) &&
                          arms_to_legs(motion, joints) > 0.8;
    result.up = result.on_four_legs ? up_on_four : nearest_axis(standing);
    return result;
}

} // namespace pantin
