// SPDX-License-Identifier: MIT
// How a recorded figure stands in its file: the vertical, and whether it is a biped or on four legs.
#pragma once

#include <optional>

#include "pantin/motion.hpp"

namespace pantin {

// Mean directions of a pose, not of unit length: of legs and arms from their roots to their ends, and from
// the middle of the hips to that of the shoulders.
struct LimbDirections {
    Vec3 legs, arms, trunk;
};
// From right to left, not of unit length.
Vec3 leftwards(const std::vector<Vec3>& pose, const MotionJoints& joints);
// Mean lengths of the two arms and the two legs, bent as they may be.
double arm_length(const std::vector<Vec3>& pose, const MotionJoints& joints);
double leg_length(const std::vector<Vec3>& pose, const MotionJoints& joints);
LimbDirections limb_directions(const std::vector<Vec3>& pose, const MotionJoints& joints);

struct BodyAxes {
    Vec3 up{0, 1, 0};            // along an axis of the file
    bool stands_at_rest = false; // the hierarchy's own pose is one in which such a body stands
    bool on_four_legs = false;
    std::optional<Vec3> rest_up; // where the hierarchy's own pose stands along another axis than the frames
};
// From the hierarchy's own pose, where it is that of a standing body (legs down, the trunk above them or
// across them): what the performer does, be it lying or standing on the hands, says nothing about where up
// is. From all frames otherwise, or where they contradict it: by the ground. No error. Own.
BodyAxes body_axes(const Motion& motion, const MotionJoints& joints);

} // namespace pantin
