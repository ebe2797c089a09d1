// SPDX-License-Identifier: MIT
// Recorded motions: Biovision hierarchies (BVH), and what they do to a humanoid character.
//
// A motion is 3D, a drawing is flat. Limb by limb the motion is projected on the plane in which it moves
// most, seen from the front (the frontal plane) or from the side (the sagittal plane), and the limb is turned
// to the direction that the projection has; lengths stay those of the drawing (after Smith et al., A Method
// for Animating Children's Drawings of the Human Figure, 2023, section 3.4).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/identification.hpp"

namespace pantin {

enum class Channel { x_position, y_position, z_position, x_rotation, y_rotation, z_rotation };

struct MotionJoint {
    std::string name; // "" for an end site
    int parent = -1;  // parents come first
    Vec3 offset;      // from the parent, in the file's units
    std::vector<Channel> channels;
    std::size_t first_channel = 0; // of a frame
};
struct Motion {
    std::string name;                // file name without its ending
    std::vector<MotionJoint> joints; // the first is the root
    double frame_time = 1.0 / 30;    // seconds
    std::size_t channels = 0;        // values of a frame; angles in degrees
    std::vector<double> values;      // frame by frame

    std::size_t frames() const { return channels > 0 ? values.size() / channels : 0; }
};

// A Biovision hierarchy: angles in degrees, lengths in the file's units, seconds. Error(input) names `file`,
// the line and the fact. Own reading of Biovision's format.
Motion parse_bvh(std::string_view text, const std::string& file);
// Places of all joints in a frame (0 … frames() − 1), the file's units. Rotations apply in the order of the
// channels; position channels replace the offset. No error. Own, as parse_bvh().
std::vector<Vec3> joint_positions(const Motion& motion, std::size_t frame);

// An animation as BVH: a joint for every bone (end sites at the tips of limbs), a frame for each key pose,
// the character 100 units high, y up, degrees. No error. Own, as parse_bvh().
std::string to_bvh(const Rig& rig, const BoneAnimation& animation);

// The joints of a motion that stand for the parts of a human body; −1 where it has none. Left and right are
// those of the recorded figure.
struct MotionJoints {
    int hips = -1, neck = -1, head = -1, head_end = -1;
    struct Side {
        int upper_arm = -1, forearm = -1, hand = -1, thigh = -1, shin = -1, foot = -1;
    };
    Side left, right;
};
// By the names that common programs use ("mixamorig:LeftArm", "lShldr", "upper_arm.L", "LeftShoulder" over
// "LeftElbow", …). Error(input) names `file` and the first part of the body that no joint stands for; neck
// and head may be missing. Own.
MotionJoints match_joints(const Motion& motion, const std::string& file);
// Part of the body → name of the joint, for people to read. No error. Own.
std::vector<std::pair<std::string, std::string>> match_table(const Motion& motion,
                                                             const MotionJoints& joints);

// Whether a bone that follows a joint of that name ("arm_left") belongs to the left of the picture, which is
// the right of the recorded figure. No error. Own.
bool shown_left(const Bone& bone, const std::string& joint);

// The motion on a character's bones. The recorded figure faces the viewer: its left is the right of the
// picture. The hips' way is scaled by the length of the legs, so that
// the feet keep the ground; start, seconds: of the recording, cut to what there is. No error. Thesis 3.3
// (Fig. 3.12); Smith et al. 2023, section 3.4.
BoneAnimation follow(const Rig& rig, const ReferenceSkeleton& reference, const Motion& motion,
                     const MotionJoints& joints, double start = 0, double seconds = 12);

} // namespace pantin
