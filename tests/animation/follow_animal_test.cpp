// SPDX-License-Identifier: MIT
// Recorded animals on drawn ones: which motions are theirs, and what their limbs do.
#include <catch2/catch.hpp>

#include <cmath>

#include "animation/vector.hpp"
#include "core/math.hpp"
#include "pantin/motion.hpp"
#include "support/skeletons.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

const ReferenceSkeleton& reference_named(const std::string& name) {
    static const std::vector<ReferenceSkeleton> all = load_references();
    return find_reference(all, name);
}

// A dog of 60 units facing +z, y up: hips at the back, a neck that rises, a tail of two.
SkeletonJoint dog(bool human_names) {
    const auto name = [&](const std::string& human, const std::string& other) {
        return human_names ? human : other;
    };
    SkeletonJoint hips{name("Hips", "m0"), 0, 0, 0, {}}, chest{name("Spine", "m1"), 0, 0, 50, {}};
    for (const bool left : {true, false}) {
        const double s = left ? 1 : -1;
        const std::string side = human_names ? (left ? "Left" : "Right") : (left ? "k" : "j");
        hips.children.push_back({side + name("UpLeg", "1"),
                                 6 * s,
                                 -4,
                                 0,
                                 {{side + name("Leg", "2"),
                                   0,
                                   -25,
                                   0,
                                   {{side + name("Foot", "3"), 0, -25, 0, {{"", 0, -3, 4, {}}}}}}}});
        chest.children.push_back({side + name("Arm", "4"),
                                  6 * s,
                                  -4,
                                  0,
                                  {{side + name("ForeArm", "5"),
                                    0,
                                    -25,
                                    0,
                                    {{side + name("Hand", "6"), 0, -25, 0, {{"", 0, -3, 4, {}}}}}}}});
    }
    chest.children.push_back(
        {name("Neck", "m2"), 0, 6, 4, {{name("Head", "m3"), 0, 14, 10, {{"", 0, 0, 18, {}}}}}});
    hips.children.push_back(
        {name("Tail", "m4"), 0, 4, -4, {{name("Tail1", "m5"), 0, 4, -12, {{"", 0, 4, -12, {}}}}}});
    hips.children.push_back(chest);
    return hips;
}

// The value of a rotation channel of a joint in a frame.
double& angle(Motion& motion, const std::string& name, std::size_t frame, Channel channel) {
    for (const MotionJoint& joint : motion.joints)
        if (joint.name == name)
            for (std::size_t c = 0; c < joint.channels.size(); ++c)
                if (joint.channels[c] == channel)
                    return motion.values[frame * motion.channels + joint.first_channel + c];
    throw std::logic_error(name);
}

Bone bone(const ReferenceSkeleton& reference, const std::string& driver, int parent, Point2d head,
          Point2d tail, int segment = 0) {
    Bone b;
    b.name = driver + (segment ? ".1" : "");
    b.parent = parent;
    b.head = head;
    b.tail = tail;
    b.segment = segment;
    for (std::size_t j = 0; j < reference.joints.size(); ++j)
        if (reference.joints[j].name == driver) b.reference_joint = static_cast<int>(j);
    return b;
}

// A drawn dog that looks to the left, as the reference does, with bent forelegs.
Rig drawn_dog(bool mirrored = false) {
    const ReferenceSkeleton& r = reference_named("quadruped");
    Rig rig;
    rig.width = 150, rig.height = 101;
    rig.bones = {bone(r, "hips", -1, {75, 50}, {75, 50}),
                 bone(r, "leg_front_left", 0, {40, 60}, {35, 80}),
                 bone(r, "leg_front_left", 1, {35, 80}, {40, 100}, 1),
                 bone(r, "leg_hind_left", 0, {110, 60}, {110, 100}),
                 bone(r, "head", 0, {40, 40}, {20, 20}),
                 bone(r, "tail", 0, {115, 45}, {140, 30})};
    for (Bone& b : rig.bones) b.mirrored = mirrored;
    return rig;
}

double turn_of(const Rig& rig, const BoneAnimation& a, std::size_t b, std::size_t key) {
    double turn = 0;
    for (int i = static_cast<int>(b); i >= 0; i = rig.bones[static_cast<std::size_t>(i)].parent) {
        const Quaternion q = a.rotations[static_cast<std::size_t>(i)][key];
        turn += 2 * std::atan2(q.z, q.w) * 180 / math::pi;
    }
    return turn;
}

} // namespace

TEST_CASE("A motion on four legs is an animal's, with human names and with none", "[motion]") {
    for (const bool human_names : {true, false}) {
        CAPTURE(human_names);
        const Motion motion = parse_bvh(still_motion(dog(human_names)), "dog.bvh");
        const MotionJoints joints = match_joints(motion, "dog.bvh");
        CHECK(joints.plan == BodyPlan::quadruped);
        const auto name = [&](int j) { return motion.joints[static_cast<std::size_t>(j)].name; };
        CHECK(name(joints.left.thigh) == (human_names ? "LeftUpLeg" : "k1"));
        CHECK(name(joints.right.hand) == (human_names ? "RightHand" : "j6"));
        CHECK(name(joints.head) == (human_names ? "Head" : "m3"));
        REQUIRE(joints.tail.size() == 3);
        CHECK(name(joints.tail[0]) == (human_names ? "Tail" : "m4"));
        CHECK(match_table(motion, joints).front() ==
              std::pair<std::string, std::string>("body", "quadruped"));
    }
}

TEST_CASE("Motions go with the references of their kind of body", "[motion]") {
    for (const ReferenceSkeleton& r : load_references()) {
        CAPTURE(r.name);
        CHECK(can_follow(r, BodyPlan::humanoid) == (r.name == "humanoid"));
        CHECK(can_follow(r, BodyPlan::quadruped) == (r.name == "quadruped"));
        CHECK(can_follow(r, BodyPlan::bird) == (r.name == "flying"));
    }
}

TEST_CASE("A drawn quadruped swings its legs from the pose as drawn, towards where it looks", "[motion]") {
    Motion motion = parse_bvh(still_motion(dog(true), 5), "dog.bvh");
    motion.name = "dog";
    // Forwards by 30° in the hips of the left legs, the left elbow bent backwards by 40°, in frame 2.
    angle(motion, "LeftArm", 2, Channel::x_rotation) = -30;
    angle(motion, "LeftForeArm", 2, Channel::x_rotation) = 40;
    angle(motion, "LeftUpLeg", 2, Channel::x_rotation) = -30;
    angle(motion, "Tail", 2, Channel::x_rotation) = 25; // up
    const MotionJoints joints = match_joints(motion, "dog.bvh");
    for (const bool mirrored : {false, true}) {
        const Rig rig = drawn_dog(mirrored);
        const BoneAnimation a = follow(rig, reference_named("quadruped"), motion, joints);
        const double forwards = mirrored ? 1 : -1; // counter-clockwise is forwards for a leg that looks right
        for (std::size_t b = 0; b < rig.bones.size(); ++b)
            CHECK(turn_of(rig, a, b, 0) == Approx(0).margin(1e-6));
        CHECK(turn_of(rig, a, 1, 2) == Approx(forwards * 30).margin(0.01));
        CHECK(turn_of(rig, a, 2, 2) == Approx(forwards * -10).margin(0.01));
        CHECK(turn_of(rig, a, 3, 2) == Approx(forwards * 30).margin(0.01));
        CHECK(turn_of(rig, a, 4, 2) == Approx(0).margin(0.01));
        CHECK(turn_of(rig, a, 5, 2) == Approx(forwards * -25).margin(0.01));
    }
}

TEST_CASE("A quadruped that trots forwards goes where it looks", "[motion]") {
    Motion motion = parse_bvh(still_motion(dog(true), 5), "dog.bvh");
    for (std::size_t i = 0; i < 5; ++i)
        angle(motion, "Hips", i, Channel::z_position) = 20 * static_cast<double>(i);
    const MotionJoints joints = match_joints(motion, "dog.bvh");
    const BoneAnimation left = follow(drawn_dog(), reference_named("quadruped"), motion, joints),
                        right = follow(drawn_dog(true), reference_named("quadruped"), motion, joints);
    CHECK(left.root_translation.back().x < -0.3);
    CHECK(right.root_translation.back().x == Approx(-left.root_translation.back().x));
}

TEST_CASE("Wings that beat in a motion beat on both sides of a drawn bird", "[motion]") {
    SkeletonJoint hips{"Hips", 0, 0, 0, {}}, chest{"Chest", 0, 6, 6, {}};
    for (const bool left : {true, false}) {
        const double s = left ? 1 : -1;
        const std::string side = left ? "L" : "R";
        hips.children.push_back(
            {side + "_Thigh",
             3 * s,
             -2,
             0,
             {{side + "_Shin", 0, -8, 0, {{side + "_Foot", 0, -8, 0, {{"", 0, 0, 3, {}}}}}}}});
        chest.children.push_back(
            {side + "_Wing1",
             3 * s,
             2,
             0,
             {{side + "_Wing2", 15 * s, 0, 0, {{side + "_Wing3", 15 * s, 0, 0, {{"", 9 * s, 0, 0, {}}}}}}}});
    }
    chest.children.push_back({"Neck", 0, 5, 3, {{"Head", 0, 4, 2, {{"", 0, 0, 4, {}}}}}});
    hips.children.push_back(chest);
    Motion motion = parse_bvh(still_motion(hips, 3), "bird.bvh");
    angle(motion, "L_Wing1", 1, Channel::z_rotation) = 35; // both up
    angle(motion, "R_Wing1", 1, Channel::z_rotation) = -35;
    const MotionJoints joints = match_joints(motion, "bird.bvh");
    CHECK(joints.plan == BodyPlan::bird);
    const ReferenceSkeleton& r = reference_named("flying");
    Rig rig;
    rig.width = rig.height = 101;
    rig.bones = {bone(r, "hips", -1, {50, 50}, {50, 49}), bone(r, "wing_left", 0, {45, 45}, {5, 30}),
                 bone(r, "wing_right", 0, {55, 45}, {95, 30})};
    const BoneAnimation a = follow(rig, r, motion, joints);
    CHECK(turn_of(rig, a, 1, 0) == Approx(0).margin(1e-6));
    CHECK(turn_of(rig, a, 1, 1) == Approx(-35).margin(0.01)); // the left wing's tip goes up clockwise
    CHECK(turn_of(rig, a, 2, 1) == Approx(35).margin(0.01));
}
