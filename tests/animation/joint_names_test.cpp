// SPDX-License-Identifier: MIT
// Which joint plays which part of a body: by the names that motion programs give, by shape, by hand.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "pantin/error.hpp"
#include "pantin/motion.hpp"
#include "support/skeletons.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// left, right, hips, spine, chest, neck, head, collar, upper arm, forearm, hand, thigh, shin, foot, toe,
// twist
const std::vector<std::pair<const char*, SkeletonNames>> schemes = {
    {"Mixamo",
     {"Left", "Right", "mixamorig:Hips", "mixamorig:Spine", "mixamorig:Spine2", "mixamorig:Neck",
      "mixamorig:Head", "mixamorig:<Shoulder", "mixamorig:<Arm", "mixamorig:<ForeArm", "mixamorig:<Hand",
      "mixamorig:<UpLeg", "mixamorig:<Leg", "mixamorig:<Foot", "mixamorig:<ToeBase", ""}},
    {"CMU",
     {"Left", "Right", "Hips", "LowerBack", "Spine1", "Neck", "Head", "<Shoulder", "<Arm", "<ForeArm",
      "<Hand", "<UpLeg", "<Leg", "<Foot", "<ToeBase", ""}},
    {"Bandai",
     {"L", "R", "Hips", "Spine", "Chest", "Neck", "Head", "Shoulder_<", "UpperArm_<", "LowerArm_<", "Hand_<",
      "UpperLeg_<", "LowerLeg_<", "Foot_<", "Toes_<", ""}},
    {"Xsens",
     {"Left", "Right", "Hips", "Chest", "Chest4", "Neck", "Head", "<Collar", "<Shoulder", "<Elbow", "<Wrist",
      "<Hip", "<Knee", "<Ankle", "<Toe", ""}},
    {"Kinect",
     {"Left", "Right", "HipCenter", "Spine", "ShoulderCenter", "", "Head", "", "Shoulder<", "Elbow<",
      "Wrist<", "Hip<", "Knee<", "Ankle<", "Foot<", ""}},
    {"Unreal",
     {"l", "r", "pelvis", "spine_01", "spine_03", "neck_01", "head", "clavicle_<", "upperarm_<", "lowerarm_<",
      "hand_<", "thigh_<", "calf_<", "foot_<", "ball_<", "upperarm_twist_01_<"}},
    {"Rigify",
     {"L", "R", "DEF-spine", "DEF-spine.001", "DEF-spine.003", "DEF-spine.004", "DEF-spine.006",
      "DEF-shoulder.<", "DEF-upper_arm.<", "DEF-forearm.<", "DEF-hand.<", "DEF-thigh.<", "DEF-shin.<",
      "DEF-foot.<", "DEF-toe.<", ""}},
    {"mocopi",
     {"l", "r", "root", "torso_1", "torso_7", "neck_1", "head", "<_shoulder", "<_up_arm", "<_low_arm",
      "<_hand", "<_up_leg", "<_low_leg", "<_foot", "<_toes", ""}},
    {"DeepMotion",
     {"l", "r", "hips_JNT", "spine_JNT", "spine2_JNT", "neck_JNT", "head_JNT", "<_shoulder_JNT", "<_arm_JNT",
      "<_forearm_JNT", "<_hand_JNT", "<_upleg_JNT", "<_leg_JNT", "<_foot_JNT", "<_toebase_JNT", ""}},
    {"FreeMoCap",
     {"L", "R", "pelvis", "spine", "spine.001", "neck", "face", "shoulder.<", "upper_arm.<", "forearm.<",
      "hand.<", "thigh.<", "shin.<", "foot.<", "toe.<", ""}},
    {"3ds Max",
     {"L", "R", "Bip01", "Bip01 Spine", "Bip01 Spine1", "Bip01 Neck", "Bip01 Head", "Bip01 < Clavicle",
      "Bip01 < UpperArm", "Bip01 < Forearm", "Bip01 < Hand", "Bip01 < Thigh", "Bip01 < Calf", "Bip01 < Foot",
      "Bip01 < Toe0", ""}},
    {"HumanIK",
     {"Left", "Right", "Character1_Hips", "Character1_Spine", "Character1_Spine2", "Character1_Neck",
      "Character1_Head", "Character1_<Shoulder", "Character1_<Arm", "Character1_<ForeArm", "Character1_<Hand",
      "Character1_<UpLeg", "Character1_<Leg", "Character1_<Foot", "Character1_<ToeBase", ""}},
    {"Character Creator",
     {"L", "R", "CC_Base_Hip", "CC_Base_Waist", "CC_Base_Spine02", "CC_Base_NeckTwist01", "CC_Base_Head",
      "CC_Base_<_Clavicle", "CC_Base_<_Upperarm", "CC_Base_<_Forearm", "CC_Base_<_Hand", "CC_Base_<_Thigh",
      "CC_Base_<_Calf", "CC_Base_<_Foot", "CC_Base_<_ToeBase", "CC_Base_<_UpperarmTwist01"}},
    {"Daz",
     {"l", "r", "hip", "abdomenLower", "chestUpper", "neckLower", "head", "<Collar", "<ShldrBend",
      "<ForearmBend", "<Hand", "<ThighBend", "<Shin", "<Foot", "<Toe", "<ShldrTwist"}},
    {"OptiTrack",
     {"L", "R", "Hip", "Ab", "Chest", "Neck", "Head", "<Shoulder", "<UArm", "<FArm", "<Hand", "<Thigh",
      "<Shin", "<Foot", "<Toe", ""}},
    {"Valve",
     {"L", "R", "ValveBiped.Bip01_Pelvis", "ValveBiped.Bip01_Spine", "ValveBiped.Bip01_Spine4",
      "ValveBiped.Bip01_Neck1", "ValveBiped.Bip01_Head1", "ValveBiped.Bip01_<_Clavicle",
      "ValveBiped.Bip01_<_UpperArm", "ValveBiped.Bip01_<_Forearm", "ValveBiped.Bip01_<_Hand",
      "ValveBiped.Bip01_<_Thigh", "ValveBiped.Bip01_<_Calf", "ValveBiped.Bip01_<_Foot",
      "ValveBiped.Bip01_<_Toe0", ""}},
    {"SMPL",
     {"L", "R", "m_avg_Pelvis", "m_avg_Spine1", "m_avg_Spine3", "m_avg_Neck", "m_avg_Head", "m_avg_<_Collar",
      "m_avg_<_Shoulder", "m_avg_<_Elbow", "m_avg_<_Wrist", "m_avg_<_Hip", "m_avg_<_Knee", "m_avg_<_Ankle",
      "m_avg_<_Foot", ""}},
    // Relatives: capitals, small letters without a mark between the words, a glued prefix, the side last.
    {"capitals",
     {"LEFT", "RIGHT", "PELVIS", "SPINE", "CHEST", "NECK", "HEAD", "CLAVICLE_<", "SHOULDER_<", "ELBOW_<",
      "WRIST_<", "HIP_<", "KNEE_<", "ANKLE_<", "FOOT_<", ""}},
    {"small letters",
     {"left", "right", "hips", "spine", "chest", "neck", "head", "<shoulder", "<upperarm", "<forearm",
      "<hand", "<upleg", "<leg", "<foot", "<toe", ""}},
    {"glued prefix",
     {"left", "right", "robothips", "robotspine", "robotchest", "robotneck", "robothead", "robot<shoulder",
      "robot<arm", "robot<forearm", "robot<hand", "robot<upleg", "robot<leg", "robot<foot", "robot<toe", ""}},
    {"VRM",
     {"L", "R", "J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_Chest", "J_Bip_C_Neck", "J_Bip_C_Head",
      "J_Bip_<_Shoulder", "J_Bip_<_UpperArm", "J_Bip_<_LowerArm", "J_Bip_<_Hand", "J_Bip_<_UpperLeg",
      "J_Bip_<_LowerLeg", "J_Bip_<_Foot", "J_Bip_<_ToeBase", ""}},
    {"MakeHuman",
     {"L", "R", "root", "spine05", "spine01", "neck01", "head", "clavicle.<", "upperarm01.<", "lowerarm01.<",
      "wrist.<", "upperleg01.<", "lowerleg01.<", "foot.<", "toe1-1.<", ""}},
};

std::string name_of(const Motion& motion, int joint) {
    return joint < 0 ? "none" : motion.joints[static_cast<std::size_t>(joint)].name;
}

std::string named(const SkeletonNames& names, const std::string& name, bool left) {
    const std::size_t at = name.find('<');
    return at == std::string::npos
               ? name
               : name.substr(0, at) + (left ? names.left : names.right) + name.substr(at + 1);
}

void check_joints(const Motion& motion, const MotionJoints& joints, const SkeletonNames& names) {
    CHECK(joints.plan == BodyPlan::humanoid);
    CHECK(name_of(motion, joints.hips) == names.hips);
    CHECK(name_of(motion, joints.head) == names.head);
    for (const bool left : {true, false}) {
        const MotionJoints::Side& s = left ? joints.left : joints.right;
        CHECK(name_of(motion, s.upper_arm) == named(names, names.upper_arm, left));
        CHECK(name_of(motion, s.forearm) == named(names, names.forearm, left));
        CHECK(name_of(motion, s.hand) == named(names, names.hand, left));
        CHECK(name_of(motion, s.thigh) == named(names, names.thigh, left));
        CHECK(name_of(motion, s.shin) == named(names, names.shin, left));
        CHECK(name_of(motion, s.foot) == named(names, names.foot, left));
    }
}

Motion motion_of(const SkeletonJoint& root) { return parse_bvh(still_motion(root), "p.bvh"); }

std::string refusal(const Motion& motion, const JointMap& map = {}) {
    try {
        match_joints(motion, "p.bvh", map);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "";
}

// Sixteen names that say nothing.
SkeletonNames meaningless() {
    return {"a", "b", "qx", "vk", "ze", "wo", "ry", "<1", "<2", "<3", "<4", "<5", "<6", "<7", "<8", ""};
}

void turn_round(SkeletonJoint& joint) { // by half a circle about y
    joint.x = -joint.x, joint.z = -joint.z;
    for (SkeletonJoint& child : joint.children) turn_round(child);
}

} // namespace

TEST_CASE("Joints are found by the names of seventeen motion programs and their relatives", "[motion]") {
    for (const auto& [program, names] : schemes) {
        CAPTURE(program);
        const Motion motion = motion_of(person(names));
        check_joints(motion, match_joints(motion, "p.bvh"), names);
    }
}

TEST_CASE("Joints whose names say nothing are found by the skeleton's shape", "[motion]") {
    const SkeletonNames names = meaningless();
    const Motion motion = motion_of(person(names));
    check_joints(motion, match_joints(motion, "p.bvh"), names);
}

TEST_CASE("Without names the toes say where the front is, and so what is left", "[motion]") {
    SkeletonNames names = meaningless();
    SkeletonJoint body = person(names);
    turn_round(body);
    const Motion motion = motion_of(body);
    check_joints(motion, match_joints(motion, "p.bvh"), names); // its left is at −x now, and still "a"
}

TEST_CASE("Twists inside a limb, fingers and a prop beside the body do not mislead the shape", "[motion]") {
    const SkeletonNames names = meaningless();
    SkeletonJoint body = person(names);
    // Three fingers on each hand, and a twist in the middle of each thigh.
    const auto visit = [&](const auto& self, SkeletonJoint& joint) -> void {
        if (joint.name == "a4" || joint.name == "b4") {
            const double s = joint.name == "a4" ? 1 : -1;
            for (const double z : {-2.0, 0.0, 2.0})
                joint.children.push_back(
                    {joint.name + std::to_string(static_cast<int>(z)), 8 * s, 0, z, {{"", 7 * s, 0, 0, {}}}});
        }
        if (joint.name == "a5" || joint.name == "b5") {
            SkeletonJoint shin = joint.children[0];
            shin.y = -21;
            joint.children = {{joint.name + "t", 0, -21, 0, {shin}}};
        }
        for (SkeletonJoint& child : joint.children) self(self, child);
    };
    visit(visit, body);
    Motion motion = motion_of(body);
    // The knees bend, so that twist and knee differ.
    const auto bend = [&](const std::string& name) {
        for (const MotionJoint& joint : motion.joints)
            if (joint.name == name) motion.values[motion.channels + joint.first_channel + 1] = 60;
    };
    bend("a6"), bend("b6");
    check_joints(motion, match_joints(motion, "p.bvh"), names);
}

TEST_CASE("Controls beside the limbs, each as long as a leg, are no limbs", "[motion]") {
    const SkeletonNames names = meaningless();
    SkeletonJoint body = person(names);
    for (const double s : {1.0, -1.0})
        body.children.push_back({s > 0 ? "a9" : "b9", 9 * s, -90, 0, {{"", 0, 0, 8, {}}}});
    const Motion motion = motion_of(body);
    check_joints(motion, match_joints(motion, "p.bvh"), names);
}

TEST_CASE("Hair is no arm, strips of a skirt are no legs and no tail", "[motion]") {
    const SkeletonNames names = meaningless();
    SkeletonJoint body = person(names);
    const auto visit = [&](const auto& self, SkeletonJoint& joint) -> void {
        for (SkeletonJoint& child : joint.children) self(self, child);
        if (joint.name != names.head) return;
        for (const double s : {1.0, -1.0}) {
            const std::string side = s > 0 ? "a" : "b";
            joint.children.push_back(
                {side + "h1",
                 10 * s,
                 10,
                 -5,
                 {{side + "h2", 5 * s, -40, 0, {{side + "h3", 0, -40, 0, {{"", 0, -20, 0, {}}}}}}}});
        }
    };
    visit(visit, body);
    for (int i = 0; i < 8; ++i) {
        const double angle = 0.785 * i, x = 15 * std::cos(angle), z = 15 * std::sin(angle);
        const std::string name = "s" + std::to_string(i);
        body.children.push_back(
            {name, x, 0, z, {{name + "m", 0, -25, 0, {{name + "n", 0, -25, 0, {{"", 0, -5, 0, {}}}}}}}});
    }
    const Motion motion = motion_of(body);
    const MotionJoints joints = match_joints(motion, "p.bvh");
    check_joints(motion, joints, names);
    CHECK(joints.tail.empty());
}

TEST_CASE("The hips carry the legs, whatever stands on the ground above them", "[motion]") {
    SkeletonNames names = schemes[1].second; // CMU
    names.hips = "center";
    SkeletonJoint body = person(names);
    body.y = 90;
    const SkeletonJoint root{"all", 0, 0, 0, {body, {"ik", 20, 0, 0, {{"", 0, 5, 0, {}}}}}};
    const Motion motion = motion_of(root);
    check_joints(motion, match_joints(motion, "p.bvh"), names);
}

TEST_CASE("Japanese names of MikuMikuDance are known", "[motion]") {
    const SkeletonNames names = {"左",  "右",    "センター", "上半身", "上半身2", "首",    "頭",      "<肩",
                                 "<腕", "<ひじ", "<手首",    "<足",    "<ひざ",   "<足首", "<つま先", ""};
    const Motion motion = motion_of(person(names));
    check_joints(motion, match_joints(motion, "p.bvh"), names);
}

TEST_CASE("A person with wings is a person, a body can be named by hand, and so can a face", "[motion]") {
    const SkeletonNames names = schemes[1].second;
    SkeletonJoint body = person(names);
    SkeletonJoint& chest = body.children.back().children[0];
    for (const double s : {1.0, -1.0}) {
        const std::string side = s > 0 ? "Left" : "Right";
        chest.children.push_back(
            {side + "Wing1",
             5 * s,
             10,
             -8,
             {{side + "Wing2", 40 * s, 20, 0, {{side + "Wing3", 50 * s, 0, 0, {{"", 20 * s, 0, 0, {}}}}}}}});
    }
    SkeletonJoint& head = chest.children[2].children[0];
    REQUIRE(head.name == "Head");
    head.children.push_back({"Jaw", 0, -2, 30, {{"", 0, 0, 5, {}}}});
    const Motion motion = motion_of(body);
    check_joints(motion, match_joints(motion, "p.bvh"), names);
    const JointMap bird = parse_motion_map(R"({"body": "bird"})", "map.json");
    CHECK(match_joints(motion, "p.bvh", bird).plan == BodyPlan::bird);
    CHECK_THROWS_WITH(parse_motion_map(R"({"body": "fish"})", "map.json"),
                      Catch::Contains("must be humanoid, quadruped or bird"));
}

TEST_CASE("A file of two skeletons gives the one that is a body", "[motion]") {
    const SkeletonNames& names = schemes[1].second;
    std::string text = still_motion(person(names));
    const std::string prop = "ROOT Stick\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nEnd "
                             "Site\n{\nOFFSET 0 10 0\n}\n}\n";
    text.insert(text.find("ROOT"), prop);
    for (std::size_t at = text.find("0 90 0"); at != std::string::npos; at = text.find("0 90 0", at + 12))
        text.insert(at, "1 2 3 ");
    const Motion motion = parse_bvh(text, "p.bvh");
    check_joints(motion, match_joints(motion, "p.bvh"), names);
}

TEST_CASE("Joints named by hand overrule what was found", "[motion]") {
    const SkeletonNames names = meaningless();
    const Motion motion = motion_of(person(names));
    const JointMap map = parse_motion_map(R"({"left hand": "b4", "left upper arm": "b2", "left forearm": "b3",
        "right hand": "a4", "right upper arm": "a2", "right forearm": "a3"})",
                                          "map.json");
    const MotionJoints joints = match_joints(motion, "p.bvh", map);
    CHECK(name_of(motion, joints.left.hand) == "b4");
    CHECK(name_of(motion, joints.right.forearm) == "a3");
    CHECK(name_of(motion, joints.left.thigh) == "a5"); // found as before
}

TEST_CASE("A map of joints is refused by its key or the joint that is not there", "[motion]") {
    CHECK_THROWS_WITH(parse_motion_map(R"({"left wrist": "x"})", "map.json"),
                      Catch::StartsWith("map.json: 'left wrist' is no part of a body"));
    CHECK_THROWS_WITH(parse_motion_map("[1]", "map.json"), "map.json: is no object of parts and joints");
    CHECK_THROWS_WITH(parse_motion_map(R"({"hips": 3})", "map.json"), Catch::Contains("hips"));
    const Motion motion = motion_of(person(meaningless()));
    CHECK(refusal(motion, {{"hips", "Pelvis"}}) == "p.bvh: has no joint 'Pelvis', which is to play the hips");
    CHECK(refusal(motion, {{"left thigh", "a7"}}) ==
          "p.bvh: the left shin, 'a6', does not hang from the left thigh, 'a7'");
    CHECK(refusal(motion, {{"hips", "vk"}}) ==
          "p.bvh: the left thigh, 'a5', does not hang from the hips, 'vk'");
}

TEST_CASE("A skeleton without arms is refused by name and shape", "[motion]") {
    SkeletonJoint body = person(schemes[1].second);
    SkeletonJoint& chest = body.children.back().children[0];
    chest.children = {chest.children.back()};
    const std::string text = refusal(motion_of(body));
    CHECK(text.starts_with("p.bvh: no joint plays the left upper arm (Hips, "));
    CHECK(text.ends_with("--motion-map names the joints by hand"));
}

TEST_CASE("A map of the arms does not ask for the hips, which the legs show", "[motion]") {
    // What is called "Pelvis" hangs beside the legs.
    SkeletonNames names = meaningless();
    SkeletonJoint body = person(names);
    body.children.push_back({"Pelvis", 0, -2, 0, {}});
    const Motion motion = motion_of(body);
    const MotionJoints joints = match_joints(
        motion, "p.bvh", {{"left upper arm", "a2"}, {"left forearm", "a3"}, {"left hand", "a4"}});
    CHECK(name_of(motion, joints.hips) == names.hips);
}
