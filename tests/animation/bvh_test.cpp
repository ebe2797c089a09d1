// SPDX-License-Identifier: MIT
// BVH files: read, written, damaged in every way; names of joints of the common programs.
#include <catch2/catch.hpp>

#include <cmath>

#include "animation/vector.hpp"
#include "core/math.hpp"
#include "export/rigs.hpp"
#include "pantin/error.hpp"
#include "pantin/motion.hpp"
#include "support/performers.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

const std::string arm = R"(HIERARCHY
ROOT shoulder
{
  OFFSET 1 2 3
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT elbow
  {
    OFFSET 10 0 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 5 0 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.04
0 0 0 0 0 0 0 0 0
1 1 1 90 0 0 0 0 -90
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string refusal(const std::string& text) {
    try {
        parse_bvh(text, "arm.bvh");
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "";
}

void check_near(Vec3 a, Vec3 b) {
    CHECK(a.x == Approx(b.x).margin(1e-6));
    CHECK(a.y == Approx(b.y).margin(1e-6));
    CHECK(a.z == Approx(b.z).margin(1e-6));
}

} // namespace

TEST_CASE("A BVH file gives joints, channels and frames", "[motion]") {
    const Motion motion = parse_bvh(arm, "arm.bvh");
    REQUIRE(motion.joints.size() == 3);
    CHECK(motion.joints[1].name == "elbow");
    CHECK(motion.joints[1].parent == 0);
    CHECK(motion.joints[2].name.empty());
    CHECK(motion.joints[2].parent == 1);
    CHECK(motion.channels == 9);
    CHECK(motion.frames() == 2);
    CHECK(motion.frame_time == 0.04);
}

TEST_CASE("Joints are where the rotations put them", "[motion]") {
    const Motion motion = parse_bvh(arm, "arm.bvh");
    check_near(joint_positions(motion, 0)[2], {15, 0, 0}); // position channels replace the root's offset
    // Turned by 90° about z, the arm points up; the forearm, by −90° about its own y, towards the viewer.
    const std::vector<Vec3> places = joint_positions(motion, 1);
    check_near(places[0], {1, 1, 1});
    check_near(places[1], {1, 11, 1});
    check_near(places[2], {1, 11, 6});
}

TEST_CASE("A damaged BVH file is refused with its line", "[motion]") {
    CHECK(refusal("") == "arm.bvh: line 1: 'HIERARCHY' is expected, not ''");
    CHECK(refusal(replaced(arm, "OFFSET 10", "OFFSET ten")) ==
          "arm.bvh: line 8: an offset is expected, not 'ten'");
    CHECK(refusal(replaced(arm, "3 Zrotation", "4 Zrotation")).find("'End' is no channel") !=
          std::string::npos);
    CHECK(refusal(replaced(arm, "Yrotation\n    End", "Wrotation\n    End"))
              .find("line 9: 'Wrotation' is no channel") != std::string::npos);
    CHECK(refusal(arm + "1 2 3") == "arm.bvh: line 21: the last frame has 3 of 9 values");
    CHECK(refusal(arm.substr(0, arm.find("0 0 0 0 0 0 0 0 0"))).find("there is no frame") !=
          std::string::npos);
    CHECK(refusal(replaced(arm, "Frames: 2", "Frames: 2.5")).find("there must be") != std::string::npos);
    CHECK(refusal(replaced(arm, "Frame Time: 0.04", "Frame Time: -1")).find("a frame must take") !=
          std::string::npos);
    CHECK(refusal(replaced(arm, "0 0 0 0 0 0 0 0 0", "0 0 0 none 0 0 0 0 0")).find("not 'none'") !=
          std::string::npos);
    CHECK(refusal("\xFF\xFEH").find("UTF-16") != std::string::npos);
    CHECK(refusal(arm.substr(0, 200)).starts_with("arm.bvh: line "));
}

TEST_CASE("What a program writes beside the format is used, with a line where it changes the motion",
          "[motion]") {
    const Motion plain = parse_bvh(arm, "arm.bvh");
    const auto same = [&](const std::string& text) {
        const Motion motion = parse_bvh(text, "arm.bvh");
        CHECK(motion.values == plain.values);
        CHECK(motion.joints.size() == plain.joints.size());
        CHECK(motion.frame_time == plain.frame_time);
        return motion.repairs;
    };
    using Lines = std::vector<std::string>;
    CHECK(same("\xEF\xBB\xBF" + arm).empty());
    CHECK(same(arm + "\x1a").empty());
    std::string text = arm;
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    CHECK(same(text).empty());
    CHECK(same(replaced(arm, "Frames: 2", "Frames:2")).empty());
    CHECK(same(replaced(arm, "Frame Time: 0.04", "FRAME time:\t0,04")).empty());
    CHECK(same(replaced(arm, "OFFSET 5 0 0", "OFFSET 5,0 0 0")).empty());
    CHECK(same(replaced(arm, "End Site", "End Site fingertip")).empty());
    CHECK(same(replaced(arm, "ROOT shoulder\n{", "ROOT shoulder {")).empty());
    CHECK(same(replaced(arm, "Frames: 2", "Frames: 3")) ==
          Lines{"2 frames are there, not 3 as declared; all are used"});
    CHECK(same(replaced(arm, "Frames: 2", "Frames: 1")) ==
          Lines{"2 frames are there, not 1 as declared; all are used"});
    CHECK(same(replaced(arm, "Frames: 2", "Frames: 0")) ==
          Lines{"2 frames are there, not 0 as declared; all are used"});
}

TEST_CASE("Names of joints may hold spaces", "[motion]") {
    const Motion motion = parse_bvh(replaced(arm, "JOINT elbow", "JOINT Left  Fore Arm "), "arm.bvh");
    CHECK(motion.joints[1].name == "Left  Fore Arm");
}

TEST_CASE("Values that are no numbers keep what was there before, scales are passed over", "[motion]") {
    const Motion motion = parse_bvh(replaced(arm, "1 1 1 90", "1 -nan(ind) 1 90"), "arm.bvh");
    CHECK(motion.values[10] == 0);
    CHECK(motion.repairs == std::vector<std::string>{"1 value is no number; the frame before stands for it"});
    const Motion first = parse_bvh(replaced(arm, "0 0 0 0 0 0 0 0 0", "nan 0 0 0 0 0 0 0 0"), "arm.bvh");
    CHECK(first.values[0] == 1); // what it will be
    std::string text = replaced(arm, "CHANNELS 3 Zrotation Xrotation Yrotation",
                                "CHANNELS 4 Xscale Zrotation Xrotation Yrotation");
    text = replaced(text, "0 0 0 0 0 0 0 0 0", "0 0 0 0 0 0 9 0 0 0");
    text = replaced(text, "1 1 1 90 0 0 0", "1 1 1 90 0 0 9 0");
    const Motion scaled = parse_bvh(text, "arm.bvh");
    CHECK(scaled.repairs == std::vector<std::string>{"scales are not followed"});
    check_near(joint_positions(scaled, 1)[2], {1, 11, 6});
    const Motion timeless = parse_bvh(replaced(arm, "Frame Time: 0.04", "Frame Time: 0"), "arm.bvh");
    CHECK(timeless.frame_time == Approx(1.0 / 30));
    CHECK(timeless.repairs.size() == 1);
}

TEST_CASE("A first frame of the pose at rest is left out where the motion begins elsewhere", "[motion]") {
    std::string text = replaced(arm, "Frames: 2", "Frames: 3") + "1 1 1 80 0 0 0 0 -80\n";
    const Motion motion = parse_bvh(text, "arm.bvh");
    CHECK(motion.frames() == 2);
    CHECK(motion.values[3] == 90);
    CHECK(motion.repairs == std::vector<std::string>{"the first frame is the pose at rest and is left out"});
    text = replaced(text, "1 1 1 90 0 0 0 0 -90", "1 1 1 9 0 0 0 0 -9"); // it begins there and goes on
    CHECK(parse_bvh(text, "arm.bvh").frames() == 3);
}

TEST_CASE("Every beginning of a BVH file that does not end with a frame is refused, never a crash",
          "[motion]") {
    for (std::size_t length = 0; length + 2 < arm.size(); ++length) {
        CAPTURE(length);
        const std::size_t first = arm.find("0 0 0 0 0 0 0 0 0") + 17;
        if (length == first || length == first + 1) continue; // one whole frame
        CHECK_FALSE(refusal(arm.substr(0, length)).empty());
    }
}

TEST_CASE("A written BVH puts every bone where the animation puts it", "[motion]") {
    const Rig rig = square_rig();
    BoneAnimation animation = swing();
    // An odd turn about all axes, and one that points a bone straight along y (where Euler angles are not
    // unique).
    animation.rotations[1][0] = normalised({0.3, -0.2, 0.5, 0.7});
    animation.rotations[2][1] = normalised({0.7071067811865476, 0, 0, 0.7071067811865476});
    const Motion motion = parse_bvh(to_bvh(rig, animation), "written.bvh");
    REQUIRE(motion.joints.size() == 4); // three bones and the tip of the last
    REQUIRE(motion.frames() == 2);
    CHECK(motion.frame_time == 0.5);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<Vec3> places = joint_positions(motion, i);
        std::vector<Vec3> expected;
        std::vector<Quaternion> turns;
        for (const Bone& bone : rig.bones) {
            const Vec3 head = to_world(bone.head, rig.width, rig.height);
            const Quaternion local = animation.rotations[turns.size()][i];
            if (bone.parent < 0) {
                expected.push_back(head + animation.root_translation[i]);
                turns.push_back(local);
                continue;
            }
            const auto parent = static_cast<std::size_t>(bone.parent);
            const Vec3 from = to_world(rig.bones[parent].head, rig.width, rig.height);
            expected.push_back(expected[parent] + matrix_of(turns[parent]) * (head - from));
            turns.push_back(turns[parent] * local);
        }
        for (std::size_t b = 0; b < expected.size(); ++b) check_near(places[b], 100 * expected[b]);
    }
}

TEST_CASE("Joints are known by the names of the common programs", "[motion]") {
    const std::vector<JointNames> conventions = {
        mixamo,
        {"Left", "Right", "Hips", "Neck", "Head", "<Arm", "<ForeArm", "<Hand", "<UpLeg", "<Leg",
         "<Foot"}, // CMU, Rokoko
        {"Left", "Right", "Hips", "Neck", "Head", "<Shoulder", "<Elbow", "<Wrist", "<Hip", "<Knee",
         "<Ankle"}, // Biovision
        {"l", "r", "hip", "neck", "head", "<Shldr", "<ForeArm", "<Hand", "<Thigh", "<Shin",
         "<Foot"}, // Poser, DAZ
        {"L", "R", "Pelvis", "Neck", "Head", "<_Shoulder", "<_Elbow", "<_Wrist", "<_Hip", "<_Knee",
         "<_Ankle"}, // SMPL
        {".L", ".R", "hips", "neck", "head", "upper_arm<", "forearm<", "hand<", "thigh<", "shin<",
         "foot<"}, // Blender
        {"_l", "_r", "pelvis", "neck_01", "head", "upperarm<", "lowerarm<", "hand<", "thigh<", "calf<",
         "foot<"}, // Unreal
        {"L", "R", "J_Bip_C_Hips", "J_Bip_C_Neck", "J_Bip_C_Head", "J_Bip_<_UpperArm", "J_Bip_<_LowerArm",
         "J_Bip_<_Hand", "J_Bip_<_UpperLeg", "J_Bip_<_LowerLeg", "J_Bip_<_Foot"}, // VRM
        {"L", "R", "Bip01", "Bip01_Neck", "Bip01_Head", "Bip01_<_UpperArm", "Bip01_<_Forearm", "Bip01_<_Hand",
         "Bip01_<_Thigh", "Bip01_<_Calf", "Bip01_<_Foot"}, // 3ds Max
    };
    for (const JointNames& names : conventions) {
        CAPTURE(names.upper_arm, names.hips);
        const Motion motion = parse_bvh(performer(names, walking, 2), "p.bvh");
        const MotionJoints joints = match_joints(motion, "p.bvh");
        CHECK(joints.hips == 0);
        CHECK(joints.left.thigh == 1);
        CHECK(joints.left.shin == 2);
        CHECK(joints.left.foot == 3);
        CHECK(joints.left.upper_arm == 5);
        CHECK(joints.left.forearm == 6);
        CHECK(joints.left.hand == 7);
        CHECK(joints.right.thigh == 9);
        CHECK(joints.right.hand == 15);
        CHECK(joints.neck == 17);
        CHECK(joints.head == 18);
        CHECK(joints.head_end == 19);
        CHECK(match_table(motion, joints).size() == 15);
    }
}

TEST_CASE("A motion without a human body is refused by the part that is missing", "[motion]") {
    const Motion motion = parse_bvh(arm, "arm.bvh");
    CHECK_THROWS_WITH(match_joints(motion, "arm.bvh"),
                      "arm.bvh: no joint plays the left upper arm (shoulder, elbow); --motion-map names the "
                      "joints by hand");
}
