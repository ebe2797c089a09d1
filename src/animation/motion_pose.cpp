// SPDX-License-Identifier: MIT
// Frames of a recorded motion to places of its joints (forward kinematics).
#include "animation/vector.hpp"
#include "core/math.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

Quaternion turn(Channel axis, double degrees) {
    const double half = degrees * (math::pi / 360), s = math::sin(half), c = math::cos(half);
    if (axis == Channel::x_rotation) return {s, 0, 0, c};
    if (axis == Channel::y_rotation) return {0, s, 0, c};
    return {0, 0, s, c};
}

} // namespace

std::vector<Vec3> joint_positions(const Motion& motion, std::size_t frame) {
    std::vector<Vec3> places(motion.joints.size());
    std::vector<Quaternion> turns(motion.joints.size());
    for (std::size_t j = 0; j < motion.joints.size(); ++j) {
        const MotionJoint& joint = motion.joints[j];
        Vec3 offset = joint.offset;
        Quaternion local;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            const double value = motion.values[frame * motion.channels + joint.first_channel + c];
            switch (joint.channels[c]) {
            case Channel::x_position:
                offset.x = value;
                break;
            case Channel::y_position:
                offset.y = value;
                break;
            case Channel::z_position:
                offset.z = value;
                break;
            case Channel::scale:
                break;
            default:
                local = local * turn(joint.channels[c], value);
            }
        }
        if (joint.parent < 0) {
            places[j] = offset;
            turns[j] = local;
        } else {
            const auto parent = static_cast<std::size_t>(joint.parent);
            places[j] = places[parent] + matrix_of(turns[parent]) * offset;
            turns[j] = normalised(turns[parent] * local);
        }
    }
    return places;
}

std::vector<Vec3> rest_positions(const Motion& motion) {
    std::vector<Vec3> places;
    for (const MotionJoint& joint : motion.joints)
        places.push_back(joint.parent < 0 ? joint.offset
                                          : places[static_cast<std::size_t>(joint.parent)] + joint.offset);
    return places;
}

} // namespace pantin
