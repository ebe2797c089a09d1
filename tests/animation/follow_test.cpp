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

// --- as performed, whatever it is
// ------------------------------------------------------------------------------

namespace {

using Angles = std::vector<double>;

BoneAnimation performed(const Posture& posture, const Rig& rig, int frames = 31, Way way = Way::automatic) {
    Motion motion = parse_bvh(performer(mixamo, posture, frames), "p.bvh");
    motion.name = "p";
    FollowOptions options;
    options.way = way;
    return follow(rig, humanoid(), motion, match_joints(motion, "p.bvh"), options);
}

// Of the pose at a key: the bone's angle in the picture against `wanted`, in (−180, 180].
double off(const Rig& rig, const BoneAnimation& a, std::size_t bone, std::size_t key, double wanted) {
    return turned(angle_of(rig, a, bone, key) - wanted);
}

constexpr std::size_t trunk = 0, head_bone = 1, left_arm = 4, right_arm = 2, left_leg = 8, right_leg = 6;

} // namespace

TEST_CASE("A figure that lies on its back lies in the picture, and kicks", "[motion]") {
    const Rig rig = doll();
    const auto lying = [](const std::string& joint, double time) -> Angles {
        if (joint == "hips") return {0, -90, 0};
        if (joint == "left thigh") return {0, -30 + 20 * std::sin(6.28 * time), 0};
        return {0, 0, 0};
    };
    const BoneAnimation a = performed(lying, rig);
    for (std::size_t i = 0; i < a.times.size(); ++i) {
        CHECK(off(rig, a, trunk, i, 180) == Approx(0).margin(0.01)); // forwards would be to the right
        CHECK(off(rig, a, head_bone, i, 180) == Approx(0).margin(0.01));
        CHECK(off(rig, a, right_leg, i, 0) == Approx(0).margin(0.01));
        // Its back is on the ground, so a thigh that comes forwards goes up.
        CHECK(off(rig, a, left_leg, i, 30 - 20 * std::sin(6.28 * a.times[i])) == Approx(0).margin(0.01));
    }
}

TEST_CASE("A figure on all fours has a level trunk and hanging arms", "[motion]") {
    const Rig rig = doll();
    const auto crawling = [](const std::string& joint, double) -> Angles {
        if (joint == "hips") return {0, 90, 0};
        if (joint == "left upper arm") return {0, 0, -90}; // from the side of the body to before it
        if (joint == "right upper arm") return {0, 0, 90};
        if (joint == "left thigh" || joint == "right thigh") return {0, -90, 0};
        return {0, 0, 0};
    };
    const BoneAnimation a = performed(crawling, rig);
    for (const std::size_t i : {std::size_t{0}, a.times.size() - 1}) {
        CHECK(off(rig, a, trunk, i, 0) == Approx(0).margin(0.01));
        for (const std::size_t limb : {left_arm, right_arm, left_leg, right_leg})
            CHECK(off(rig, a, limb, i, -90) == Approx(0).margin(0.01));
    }
}

TEST_CASE("A handstand is upside down, and a figure that comes to it forwards keeps facing the viewer",
          "[motion]") {
    const Rig rig = doll();
    const auto upside_down = [](const std::string& joint, double) -> Angles {
        if (joint == "hips") return {0, 180, 0};
        if (joint == "left upper arm") return {90, 0, 0};
        if (joint == "right upper arm") return {-90, 0, 0};
        return {0, 0, 0};
    };
    const BoneAnimation a = performed(upside_down, rig);
    CHECK(off(rig, a, trunk, 3, -90) == Approx(0).margin(0.01));
    CHECK(off(rig, a, left_arm, 3, -90) == Approx(0).margin(0.01)); // to the ground
    CHECK(off(rig, a, left_leg, 3, 90) == Approx(0).margin(0.01));
}

TEST_CASE("A cartwheel goes once round in the picture's plane without turning away", "[motion]") {
    const Rig rig = doll();
    const auto wheel = [](const std::string& joint, double time) -> Angles {
        return joint == "hips" ? Angles{-360 * time, 0, 0} : Angles{0, 0, 0};
    };
    const BoneAnimation a = performed(wheel, rig);
    for (std::size_t i = 0; i < a.times.size(); ++i) {
        const double turn = -360 * a.times[i];
        CHECK(off(rig, a, trunk, i, 90 + turn) == Approx(0).margin(0.5));
        CHECK(off(rig, a, left_arm, i, turn) == Approx(0).margin(0.5));
        CHECK(off(rig, a, left_leg, i, turn - 90) == Approx(0).margin(0.5));
    }
}

TEST_CASE("A hierarchy that does not stand at rest lets the frames say where up is", "[motion]") {
    // All bones along x at rest, as some programs write; the frames turn them to a standing figure that
    // walks.
    const auto standing = [](const std::string& joint, double time) -> Angles {
        if (joint == "left thigh" || joint == "right thigh") {
            const double swing = 30 * std::sin(2 * math::pi * time) * (joint == "left thigh" ? 1 : -1);
            return {-90 + swing, 0, 0}; // legs swing along x: it looks to +x
        }
        if (joint == "neck") return {90, 0, 0};
        return {0, 0, 0};
    };
    std::string text = performer(mixamo, standing);
    const auto along_x = [&](const std::string& from, const std::string& to) {
        for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
            text.replace(at, from.size(), to);
    };
    along_x("OFFSET 0 -40 0", "OFFSET 40 0 0");
    along_x("OFFSET 9.000000 -5.000000 0.000000", "OFFSET 0 -5 -9"); // hips and shoulders lie along z
    along_x("OFFSET -9.000000 -5.000000 0.000000", "OFFSET 0 -5 9");
    along_x("OFFSET 17.000000 45.000000 0.000000", "OFFSET 0 45 -17");
    along_x("OFFSET -17.000000 45.000000 0.000000", "OFFSET 0 45 17");
    along_x("OFFSET 0 8 0", "OFFSET 8 0 0");
    along_x("OFFSET 0 20 0", "OFFSET 20 0 0");
    const Rig rig = doll();
    const BoneAnimation a = followed(text, rig);
    for (std::size_t i = 0; i < a.times.size(); ++i) {
        const double swing = 30 * std::sin(2 * math::pi * a.times[i]);
        CHECK(off(rig, a, left_leg, i, -90 + swing) == Approx(0).margin(0.05));
        CHECK(off(rig, a, head_bone, i, 90) == Approx(0).margin(0.05));
    }
}

TEST_CASE("A body that rolls over while it lies stays straight", "[motion]") {
    const Rig rig = doll();
    // From its back over a side to its belly.
    const auto rolling = [](const std::string& joint, double time) -> Angles {
        if (joint == "hips") return {0, -90, 180 * time}; // about its own axis
        if (joint == "left upper arm") return {-90, 0, 0};
        if (joint == "right upper arm") return {90, 0, 0};
        return {0, 0, 0};
    };
    const BoneAnimation a = performed(rolling, rig);
    for (std::size_t i = 0; i < a.times.size(); ++i) {
        CHECK(off(rig, a, trunk, i, 180) == Approx(0).margin(0.5));
        for (const std::size_t limb : {left_leg, right_leg, left_arm, right_arm})
            CHECK(off(rig, a, limb, i, 0) == Approx(0).margin(0.5));
    }
}

TEST_CASE("Frames that stand and walk along another axis than the rest pose are believed", "[motion]") {
    const Rig rig = doll();
    // z up in the frames: the hips are turned by 90° about x, and their way lies on the ground of x and y.
    const auto tipped = [](const std::string& joint, double time) {
        return joint == "hips" ? Angles{0, 90, 0} : walking(joint, time);
    };
    std::string text = performer(mixamo, tipped, 151);
    const std::size_t values = text.find('\n', text.find("Frame Time")) + 1;
    std::string frames;
    for (std::size_t at = values, i = 0; at < text.size(); ++i) {
        const std::size_t end = text.find('\n', at),
                          third = text.find(' ', text.find(' ', text.find(' ', at) + 1) + 1);
        const double time = static_cast<double>(i) / 30;
        frames += std::to_string(10 * time) + " " + std::to_string(-40 * time) + " 85" +
                  text.substr(third, end + 1 - third);
        at = end + 1;
    }
    const BoneAnimation a = followed(text.substr(0, values) + frames, rig);
    for (std::size_t i = 0; i < a.times.size(); ++i) {
        const double swing = 30 * std::sin(2 * math::pi * a.times[i]);
        CHECK(off(rig, a, trunk, i, 90) == Approx(0).margin(0.01));
        CHECK(off(rig, a, left_leg, i, -90 + swing) == Approx(0).margin(0.01));
    }
}

TEST_CASE("A figure that sits from the first frame on has its thighs to the side that it looks to",
          "[motion]") {
    const Rig rig = doll();
    const auto sitting = [](const std::string& joint, double) -> Angles {
        if (joint == "left thigh" || joint == "right thigh") return {0, -90, 0};
        if (joint == "left shin" || joint == "right shin") return {0, 90, 0};
        return {0, 0, 0};
    };
    const BoneAnimation a = performed(sitting, rig);
    CHECK(off(rig, a, right_leg, 0, 0) == Approx(0).margin(0.01));
    CHECK(off(rig, a, right_leg + 1, 0, -90) == Approx(0).margin(0.01));
    CHECK(off(rig, a, trunk, 0, 90) == Approx(0).margin(0.01));
}

TEST_CASE(
    "A head without a length stays on the neck; one that first points at the viewer begins as it goes on",
    "[motion]") {
    const Rig rig = doll();
    const auto nodding = [](const std::string& joint, double time) -> Angles {
        return joint == "head" ? Angles{0, time < 0.3 ? 90.0 : 0.0, 0} : Angles{0, 0, 0};
    };
    std::string text = performer(mixamo, jumping_jack);
    text.replace(text.find("OFFSET 0 20 0"), 13, "OFFSET 0 0 0");
    for (const BoneAnimation& a : {followed(text, rig), performed(nodding, rig)})
        for (std::size_t i = 0; i < a.times.size(); ++i) {
            const double angle = angle_of(rig, a, head_bone, i);
            CHECK(angle > -1); // never hanging
            CHECK(angle < 181);
        }
    const BoneAnimation stiff = followed(text, rig);
    for (std::size_t i = 0; i < stiff.times.size(); ++i)
        CHECK(off(rig, stiff, head_bone, i, 90) == Approx(0).margin(0.01));
}

TEST_CASE("A tilt that the skeleton has at rest is no lean", "[motion]") {
    const Rig rig = doll();
    std::string text = performer(mixamo, walking);
    text.replace(text.find("OFFSET 0 20 0"), 13, "OFFSET 0 20 9");
    // The head turns a little to and fro, so that it is seen from the side.
    const BoneAnimation a = followed(text, rig);
    for (std::size_t i = 0; i < a.times.size(); ++i)
        CHECK(off(rig, a, head_bone, i, 90) == Approx(0).margin(0.01));
}

TEST_CASE("Limbs before the trunk are drawn before it, those behind it behind", "[motion]") {
    const Rig rig = doll();
    const auto reaching = [](const std::string& joint, double) -> Angles {
        if (joint == "left upper arm") return {0, 0, -90};  // before the chest
        if (joint == "right upper arm") return {0, 0, -90}; // behind the back
        return {0, 0, 0};
    };
    const BoneAnimation a = performed(reaching, rig);
    REQUIRE(a.depths.size() == rig.bones.size());
    CHECK(a.depths[left_arm][0] > 0.015);
    CHECK(a.depths[left_arm + 1][0] > a.depths[left_arm][0]); // the hand before the elbow
    CHECK(a.depths[right_arm][0] < -0.015);
    CHECK(a.depths[left_leg][0] == 0);
    // Skinned vertices go along.
    Rig flat = rig;
    flat.mesh.vertices = {{80, 28}, {50, 54}};
    flat.weights = {{{5}, {1}}, {{0}, {1}}};
    flat.depth = {0, 0};
    const std::vector<Vec3> posed = skin(flat, a, 0);
    CHECK(posed[0].z == Approx(a.depths[left_arm + 1][0]));
    CHECK(posed[1].z == 0);
}

namespace {

// Once round a circle of `radius` units in six seconds, or straight on.
std::string walk_round(double radius, int frames = 181) {
    std::string text = performer(mixamo, walking, frames);
    const std::size_t begin = text.find("Frame Time");
    std::string head = text.substr(0, text.find('\n', begin) + 1), values;
    for (int i = 0; i < frames; ++i) {
        const double time = i / 30.0, angle = 2 * math::pi * time / 6;
        // Heading (cos, −sin) of (z, x): the way's own direction.
        values +=
            std::to_string(radius * std::cos(angle)) + " 85 " + std::to_string(radius * std::sin(angle));
        values += " 0 0 " + std::to_string(-angle * 180 / math::pi);
        const double swing = 30 * std::sin(2 * math::pi * time);
        for (const char* joint :
             {"lt", "s", "f", "la", "fa", "h", "rt", "s", "f", "ra", "fa", "h", "n", "hd"}) {
            const std::string j = joint;
            values += j == "lt"   ? " 0 " + std::to_string(-swing) + " 0"
                      : j == "rt" ? " 0 " + std::to_string(swing) + " 0"
                      : j == "la" ? " -80 0 0"
                      : j == "ra" ? " 80 0 0"
                                  : " 0 0 0";
        }
        values += "\n";
    }
    return head + values;
}

BoneAnimation going(const std::string& text, const Rig& rig, Way way) {
    Motion motion = parse_bvh(text, "p.bvh");
    motion.name = "p";
    FollowOptions options;
    options.way = way;
    return follow(rig, humanoid(), motion, match_joints(motion, "p.bvh"), options);
}

double width_of(const BoneAnimation& a) {
    double least = 0, most = 0;
    for (const Vec3& t : a.root_translation) least = std::min(least, t.x), most = std::max(most, t.x);
    return most - least;
}

} // namespace

TEST_CASE("A walk round a circle ends where it began, and the camera goes along", "[motion]") {
    const Rig rig = doll();
    const BoneAnimation whole = going(walk_round(300), rig, Way::whole);
    CHECK(whole.root_translation.back().x == Approx(0).margin(1e-3));
    // The circle's diameter on the scale of the legs.
    const double legs = 0.5 * (2 * std::hypot(2, 20) + std::hypot(2, 20)) / 101;
    CHECK(width_of(whole) == Approx(600 * legs / 80).epsilon(0.01));
    CHECK(whole.camera.empty());
    for (const Way way : {Way::automatic, Way::follow}) {
        const BoneAnimation followed = going(walk_round(300), rig, way);
        CHECK(width_of(followed) == Approx(width_of(whole)));
        REQUIRE(followed.camera.size() == followed.times.size());
        CHECK(width_of(as_filmed(followed)) < 0.25);
    }
    CHECK(width_of(going(walk_round(300), rig, Way::in_place)) == 0);
    CHECK(going(walk_round(30), rig, Way::automatic).camera.empty()); // a small way is shown
}

TEST_CASE("A figure that walks back walks to the left", "[motion]") {
    const Rig rig = doll();
    const BoneAnimation a = going(walk_round(300), rig, Way::whole);
    // While it goes to the right, a leg before the body is to the right; half way round, to the left.
    std::size_t right = 0, wrong = 0;
    for (std::size_t i = 0; i + 1 < a.times.size(); ++i) {
        const double speed = 30 * (a.root_translation[i + 1].x - a.root_translation[i].x);
        const double swing = std::sin(2 * math::pi * a.times[i]);
        if (std::abs(speed) < 0.5 || std::abs(swing) < 0.3) continue;
        const double lean = off(rig, a, left_leg, i, -90); // positive: to the right
        ((lean > 0) == (swing * speed > 0) ? right : wrong) += 1;
    }
    CHECK(right > 60);
    CHECK(wrong == 0);
}
