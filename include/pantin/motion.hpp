// SPDX-License-Identifier: MIT
// Recorded motions: Biovision hierarchies (BVH), and what they do to a humanoid character.
//
// A motion is 3D, a drawing is flat. Limb by limb the motion is projected on the plane in which it moves
// most, seen from the front (the frontal plane) or from the side (the sagittal plane), and the limb is turned
// to the direction that the projection has; lengths stay those of the drawing (after Smith et al., A Method
// for Animating Children's Drawings of the Human Figure, 2023, section 3.4).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/identification.hpp"

namespace pantin {

// Scales are read and not followed.
enum class Channel { x_position, y_position, z_position, x_rotation, y_rotation, z_rotation, scale };

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
    // What was wrong with the file and what was done about it, one line each.
    std::vector<std::string> repairs;

    std::size_t frames() const { return channels > 0 ? values.size() / channels : 0; }
};

// A Biovision hierarchy: angles in degrees, lengths in the file's units, seconds. All whole frames are used,
// whatever their declared number. Error(input) names `file`, the line and the fact. Own reading of
// Biovision's format.
Motion parse_bvh(std::string_view text, const std::string& file);
// Places of all joints in a frame (0 … frames() − 1), the file's units. Rotations apply in the order of the
// channels; position channels replace the offset. No error. Own, as parse_bvh().
std::vector<Vec3> joint_positions(const Motion& motion, std::size_t frame);
// The same in the pose of the hierarchy itself: the offsets, without any frame. No error. Own.
std::vector<Vec3> rest_positions(const Motion& motion);

// An animation as BVH: a joint for every bone (end sites at the tips of limbs), a frame for each key pose,
// the character 100 units high, y up, degrees. No error. Own, as parse_bvh().
std::string to_bvh(const Rig& rig, const BoneAnimation& animation);

// What kind of body was recorded.
enum class BodyPlan { humanoid, quadruped, bird };
// As in a map of joints, by value of BodyPlan.
inline constexpr std::array<std::string_view, 3> body_plan_names = {"humanoid", "quadruped", "bird"};
static_assert(body_plan_names.size() == static_cast<std::size_t>(BodyPlan::bird) + 1);

// The joints of a motion that stand for the parts of a body; −1 where it has none. Left and right are those
// of the recorded figure. An animal's forelegs and a bird's wings are its arms.
struct MotionJoints {
    BodyPlan plan = BodyPlan::humanoid;
    int hips = -1, neck = -1, head = -1, head_end = -1;
    struct Side {
        int upper_arm = -1, forearm = -1, hand = -1, thigh = -1, shin = -1, foot = -1;
    };
    Side left, right;
    std::vector<int> tail; // from its root to its tip
};
// Part of the body ("hips", "left upper arm", …: the words of match_table()) → name of a joint.
using JointMap = std::vector<std::pair<std::string, std::string>>;
// A map from a JSON object of such pairs. Error(input) names `file`, the key and what is wrong. Own format
// (docs/formats.md).
JointMap parse_motion_map(const std::string& text, const std::string& file);

// By the names that common programs use ("mixamorig:LeftArm", "lShldr", "upper_arm.L", "LeftShoulder" over
// "LeftElbow", …), with any prefix that most joints share; where names do not say, by the shape of the
// skeleton: two limbs from the hips, two from the chest, one way up. `by_hand` overrules both. Error(input)
// names `file` and the first part of the body that no joint stands for; neck and head may be missing. Own.
MotionJoints match_joints(const Motion& motion, const std::string& file, const JointMap& by_hand = {});
// Part of the body → name of the joint, for people to read. No error. Own.
JointMap match_table(const Motion& motion, const MotionJoints& joints);

// The words that JointMap knows. No error. Own.
std::vector<std::string> motion_parts();

// Whether a bone that follows a joint of that name ("arm_left") belongs to the left of the picture, which is
// the right of the recorded figure. No error. Own.
bool shown_left(const Bone& bone, const std::string& joint);

// What becomes of the way that a recorded figure goes.
enum class Way {
    automatic, // whole; where it is long, films follow it
    whole,     // the figure goes it in the picture
    follow,    // the figure goes it, and films go along
    in_place,  // it stays where it is
};
struct FollowOptions {
    double start = 0, seconds = 12; // of the recording, cut to what there is
    Way way = Way::automatic;
};
// Whether a character of that reference has the limbs of such a body. No error. Own.
bool can_follow(const ReferenceSkeleton& reference, BodyPlan plan);
// The motion on a character's bones; can_follow(reference, joints.plan). A humanoid faces the viewer: its
// left is the right of the picture; it stands, lies or stands on its hands as recorded. Limbs before the
// trunk are drawn before it. Animals swing their limbs from the pose as drawn as the recorded ones do from
// theirs. The hips' way is scaled by the length of the legs, so that the feet keep the ground; what ends
// where it began ends there. No error. Thesis 3.3 (Fig. 3.12); Smith et al. 2023, section 3.4.
BoneAnimation follow(const Rig& rig, const ReferenceSkeleton& reference, const Motion& motion,
                     const MotionJoints& joints, const FollowOptions& options = {});

} // namespace pantin
