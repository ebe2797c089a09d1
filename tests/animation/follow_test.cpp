// SPDX-License-Identifier: MIT
// Recorded motions on a drawn figure: directions of limbs, facing, the way of the hips.
#include <catch2/catch.hpp>

#include <cmath>

#include "animation/vector.hpp"
#include "core/math.hpp"
#include "pantin/motion.hpp"
#include "support/performers.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

const ReferenceSkeleton& humanoid() {
    static const ReferenceSkeleton reference = load_references()[0];
    return reference;
}

int joint(const std::string& name) {
    for (std::size_t j = 0; j < humanoid().joints.size(); ++j)
        if (humanoid().joints[j].name == name) return static_cast<int>(j);
    return -1;
}

// A character in a T pose, 100 pixels high: body, head, two-segment arms and legs.
Rig doll() {
    Rig rig;
    rig.width = rig.height = 101;
    const auto add = [&](const std::string& name, int parent, Point2d head, Point2d tail,
                         const std::string& driver, int segment) {
        Bone bone;
        bone.name = name;
        bone.parent = parent;
        bone.head = head;
        bone.tail = tail;
        bone.label = Label::limb;
        bone.reference_joint = joint(driver);
        bone.segment = segment;
        rig.bones.push_back(bone);
    };
    add("hips", -1, {50, 55}, {50, 54}, "hips", 0);
    add("head", 0, {50, 25}, {50, 10}, "head", 0);
    add("arm_left", 0, {45, 28}, {28, 28}, "arm_left", 0);
    add("arm_left.1", 2, {28, 28}, {12, 30}, "arm_left", 1);
    add("arm_right", 0, {55, 28}, {72, 28}, "arm_right", 0);
    add("arm_right.1", 4, {72, 28}, {88, 26}, "arm_right", 1);
    add("leg_left", 0, {46, 58}, {44, 78}, "leg_left", 0);
    add("leg_left.1", 6, {44, 78}, {42, 98}, "leg_left", 1);
    add("leg_right", 0, {54, 58}, {56, 78}, "leg_right", 0);
    return rig; // the right leg is one stiff bone
}

BoneAnimation followed(const std::string& bvh, const Rig& rig) {
    Motion motion = parse_bvh(bvh, "p.bvh");
    motion.name = "p";
    return follow(rig, humanoid(), motion, match_joints(motion, "p.bvh"));
}

// Angle of a bone in the picture at a key, in degrees, counter-clockwise from the right.
double angle_of(const Rig& rig, const BoneAnimation& animation, std::size_t bone, std::size_t key) {
    const Bone& b = rig.bones[bone];
    Quaternion turn = animation.rotations[bone][key];
    for (int p = b.parent; p >= 0; p = rig.bones[static_cast<std::size_t>(p)].parent)
        turn = animation.rotations[static_cast<std::size_t>(p)][key] * turn;
    const Vec3 d = matrix_of(turn) * Vec3{b.tail.x - b.head.x, b.head.y - b.tail.y, 0};
    CHECK(std::abs(d.z) < 1e-9); // nothing leaves the picture's plane
    return std::atan2(d.y, d.x) * 180 / math::pi;
}

double turned(double angle) { return angle - 360 * std::rint(angle / 360); }

} // namespace

TEST_CASE("Limbs take the directions of a motion in the frontal plane, left and right as in a mirror",
          "[motion]") {
    const Rig rig = doll();
    const BoneAnimation animation = followed(performer(mixamo, jumping_jack), rig);
    REQUIRE(animation.times.size() == 31);
    CHECK(animation.duration == Approx(1.0));
    for (std::size_t i = 0; i < animation.times.size(); ++i) {
        CAPTURE(i);
        const double open = 0.5 - 0.5 * std::cos(2 * math::pi * animation.times[i]);
        // The performer's left arm is on the right of the picture.
        CHECK(angle_of(rig, animation, 4, i) == Approx(-70 + 140 * open).margin(0.01));
        CHECK(turned(angle_of(rig, animation, 5, i) - (-70 + 160 * open)) == Approx(0).margin(0.01));
        CHECK(turned(angle_of(rig, animation, 2, i) - (180 + 70 - 140 * open)) == Approx(0).margin(0.01));
        CHECK(angle_of(rig, animation, 8, i) == Approx(-90 + 25 * open).margin(0.01));
        CHECK(angle_of(rig, animation, 6, i) == Approx(-90 - 25 * open).margin(0.01));
        CHECK(angle_of(rig, animation, 1, i) == Approx(90).margin(0.01));
    }
}

TEST_CASE(
    "Legs that swing forwards are seen from the side, and the hips go their way on the scale of the legs",
    "[motion]") {
    const Rig rig = doll();
    const BoneAnimation animation = followed(performer(mixamo, walking), rig);
    for (std::size_t i = 0; i < animation.times.size(); ++i) {
        const double swing = 30 * std::sin(2 * math::pi * animation.times[i]);
        CHECK(angle_of(rig, animation, 8, i) == Approx(-90 + swing).margin(0.01)); // the performer's left leg
        CHECK(angle_of(rig, animation, 6, i) == Approx(-90 - swing).margin(0.01));
        // 40 units a second; legs of 80 units are as long as those of the drawing.
        const double legs = 0.5 * (2 * std::hypot(2, 20) + std::hypot(2, 20)) / 101;
        CHECK(animation.root_translation[i].x == Approx(40 * animation.times[i] * legs / 80).margin(1e-6));
    }
}

TEST_CASE("A performer that faces another way, or has z up, moves the drawing alike", "[motion]") {
    const Rig rig = doll();
    const BoneAnimation plain = followed(performer(mixamo, walking), rig);
    const auto turned_about_y = [](const std::string& name, double time) {
        return name == "hips" ? std::vector<double>{0, 0, 130} : walking(name, time);
    };
    const BoneAnimation turned_round = followed(performer(mixamo, turned_about_y), rig);
    for (std::size_t b = 0; b < rig.bones.size(); ++b)
        for (std::size_t i = 0; i < plain.times.size(); ++i)
            CHECK(angle_of(rig, turned_round, b, i) == Approx(angle_of(rig, plain, b, i)).margin(0.01));
}

TEST_CASE("Limbs of little freedom and bones without a part follow less, or their parent", "[motion]") {
    Rig rig = doll();
    rig.bones[4].freedom = 0.5;
    rig.bones[1].reference_joint = -1;
    const BoneAnimation animation = followed(performer(mixamo, jumping_jack), rig);
    CHECK(angle_of(rig, animation, 4, 0) == Approx(-35).margin(0.01));
    for (const Quaternion& q : animation.rotations[1]) CHECK(q.w == 1);
}

TEST_CASE("A motion of one frame is a pose", "[motion]") {
    const Rig rig = doll();
    const BoneAnimation animation = followed(performer(mixamo, jumping_jack, 1), rig);
    CHECK(animation.times.size() == 2);
    CHECK(angle_of(rig, animation, 4, 0) == Approx(angle_of(rig, animation, 4, 1)));
}

TEST_CASE("Only references with arms and legs can follow a human motion", "[motion]") {
    for (const ReferenceSkeleton& reference : load_references())
        CHECK(is_humanoid(reference) == (reference.name == "humanoid"));
}
