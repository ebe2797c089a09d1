// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "animation/follow.hpp"
#include "animation/vector.hpp"
#include "core/math.hpp"

namespace pantin {

AnimalFollower::AnimalFollower(const Rig& rig, const ReferenceSkeleton& reference, const Recording& recording,
                               const MotionJoints& joints)
    : rig_(rig), reference_(reference), recording_(recording), joints_(joints) {
    turns_.assign(rig.bones.size(), std::vector<double>(recording.poses().size()));
    // References of animals look to the left.
    forwards_ = !rig.bones.empty() && rig.bones[0].mirrored ? 1 : -1;
    for (std::size_t b = 0; b < rig.bones.size(); ++b) drive(b);
}

// The joints that a reference's joint follows, from its root outwards.
AnimalFollower::Limb AnimalFollower::limb_of(const std::string& joint) const {
    const MotionJoints::Side& side = joint.ends_with("left") ? joints_.left : joints_.right;
    const std::vector<int> arm = {side.upper_arm, side.forearm, side.hand},
                           leg = {side.thigh, side.shin, side.foot};
    if (joint.starts_with("wing")) return {arm, true};
    if (joint.starts_with("leg_front")) return {arm};
    if (joint.starts_with("leg")) return {leg};
    const int neck = joints_.neck >= 0 ? joints_.neck : joints_.head;
    if (joint == "head" && neck >= 0 && joints_.head_end >= 0)
        return {{neck, joints_.head, joints_.head_end}};
    if (joint == "tail" && joints_.tail.size() >= 2) return {joints_.tail};
    if (joint == "hips" && neck >= 0) return {{joints_.hips, neck}};
    return {};
}

void AnimalFollower::drive(std::size_t b) {
    const Bone& bone = rig_.bones[b];
    const std::string name = bone.reference_joint >= 0 ? reference_.joints[bone.reference_joint].name : "";
    const Limb limb = limb_of(name);
    if (bone.parent >= 0) turns_[b] = turns_[static_cast<std::size_t>(bone.parent)];
    if (limb.chain.empty() || bone.segment > 1) return;
    const std::size_t middle = limb.chain.size() / 2;
    const int from = bone.segment == 0 ? limb.chain.front() : limb.chain[middle];
    const int to = bone.segment == 0 && goes_on(rig_, b) ? limb.chain[middle] : limb.chain.back();
    const std::vector<double> own = swing(from, to, limb.wing);
    if (own.empty()) return;
    const double outwards = bone.tail.x >= bone.head.x ? 1 : -1;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const double against = limb.wing ? outwards * own[i] : forwards_ * own[i];
        const double parent = turns_[b][i];
        // Wings beat against the body, legs and head against the vertical.
        turns_[b][i] =
            limb.wing ? parent + bone.freedom * against : parent + bone.freedom * (against - parent);
    }
}

// By how much a limb turns from its rest: seen from the side with forwards to the right, counter-clockwise; a
// wing, seen from the front, upwards. Empty without a visible direction.
std::vector<double> AnimalFollower::swing(int from, int to, bool wing) const {
    Directions limb = directions_of(recording_.poses(), from, to);
    const auto outside = [](Vec3 v) { return Vec3{std::abs(v.x), v.y, v.z}; };
    if (wing) std::transform(limb.begin(), limb.end(), limb.begin(), outside);
    std::vector<double> angles = angles_in_picture(limb, recording_.poses(), !wing);
    if (angles.empty()) return angles;
    double rest = 0;
    if (!recording_.rest().empty()) {
        const Vec3 v = recording_.rest()[static_cast<std::size_t>(to)] -
                       recording_.rest()[static_cast<std::size_t>(from)];
        rest = wing ? math::atan2(v.y, std::abs(v.x)) : math::atan2(v.y, v.z);
    } else {
        double x = 0, y = 0;
        for (const double a : angles) x += math::cos(a), y += math::sin(a);
        rest = math::atan2(y, x);
    }
    double last = 0;
    for (double& angle : angles) angle = last = nearest_turn(angle - rest, last);
    return angles;
}

} // namespace pantin
