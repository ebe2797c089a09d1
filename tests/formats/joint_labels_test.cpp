// SPDX-License-Identifier: MIT
// Joints of figures of any body: which part each belongs to, and which pixels.
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "formats/animated_drawings.hpp"
#include "formats/joint_labels.hpp"
#include "formats/joint_places.hpp"
#include "formats/joint_words.hpp"

using namespace pantin;

namespace {

constexpr Label head = Label::head, body = Label::body, limb = Label::limb, tail = Label::tail,
                wing = Label::wing, none = Label::background;

// Joints by name, place and parent's name; parents first.
struct Row {
    std::string name;
    Point2d place;
    std::string parent;
};
std::vector<FigureJoint> figure(const std::vector<Row>& rows) {
    std::vector<FigureJoint> joints;
    for (const Row& row : rows) {
        const auto found = std::find_if(joints.begin(), joints.end(),
                                        [&](const FigureJoint& j) { return j.name == row.parent; });
        joints.push_back(
            {row.name, row.place, found == joints.end() ? -1 : static_cast<int>(found - joints.begin())});
    }
    return joints;
}

const std::vector<Row> four_legged = {{"root", {100, 60}, ""},
                                      {"spine", {60, 60}, "root"},
                                      {"neck", {30, 40}, "spine"},
                                      {"nose", {10, 40}, "neck"},
                                      {"front_left_shoulder", {55, 75}, "spine"},
                                      {"front_left_knee", {55, 95}, "front_left_shoulder"},
                                      {"front_left_paw", {55, 115}, "front_left_knee"},
                                      {"hip_b_1", {105, 75}, "root"},
                                      {"knee_b_1", {105, 95}, "hip_b_1"},
                                      {"hoof_b_1", {105, 115}, "knee_b_1"},
                                      {"tail_base", {120, 55}, "root"},
                                      {"joint_17", {135, 45}, "tail_base"},
                                      {"joint_18", {150, 40}, "joint_17"}};

std::vector<FigureJoint> human() {
    const std::vector<Point2d> places = {{100, 120}, {100, 120}, {100, 60},  {100, 30}, {85, 62},  {60, 70},
                                         {35, 80},   {115, 62},  {140, 70},  {165, 80}, {92, 122}, {88, 150},
                                         {86, 180},  {108, 122}, {112, 150}, {114, 180}};
    std::vector<FigureJoint> joints;
    for (std::size_t i = 0; i < places.size(); ++i)
        joints.push_back({animated_drawings_joints[i].name, places[i], -1});
    return joints;
}

} // namespace

TEST_CASE("The name of a joint says its part", "[animated-drawings]") {
    const std::vector<std::pair<std::string, Label>> names = {{"front_left_knee", limb},
                                                              {"arm3_elbow", limb},
                                                              {"tail_tip", tail},
                                                              {"beak", head},
                                                              {"left_paw", limb},
                                                              {"hoof", limb},
                                                              {"right_wing", wing},
                                                              {"leftWingElbow", wing},
                                                              {"root", body},
                                                              {"hip", body},
                                                              {"hips", body},
                                                              {"pelvis", body},
                                                              {"hip_center", body},
                                                              {"torso", body},
                                                              {"spine2", body},
                                                              {"right_hip_f", limb},
                                                              {"left_hip", limb},
                                                              {"hip1", limb},
                                                              {"LeftHip", limb},
                                                              {"right_shoulder2", limb},
                                                              {"leg_root", limb},
                                                              {"tail_root", tail},
                                                              {"ears", head},
                                                              {"left_antenna", head},
                                                              {"tentacle_4", limb},
                                                              {"neck", body},
                                                              {"head2", head},
                                                              {"joint_3", none},
                                                              {"", none},
                                                              {"17", none},
                                                              {"leg1_hip", limb},
                                                              {"left_limb", limb},
                                                              {"dorsal_fin", body},
                                                              {"fin_up", body},
                                                              {"Fins", body},
                                                              {"leftfin", body},
                                                              {"tail_fin", tail},
                                                              {"caudalFin", tail},
                                                              {"finger", limb},
                                                              {"flipper", limb}};
    for (const auto& [name, label] : names) {
        CAPTURE(name);
        CHECK(label_of_joint_name(name) == label);
    }
}

TEST_CASE("What a joint hangs on, and what hangs on it, says the rest", "[animated-drawings]") {
    const std::vector<Label> labels = labels_of_joints(figure(four_legged));
    CHECK(labels ==
          std::vector<Label>{body, body, body, head, limb, limb, limb, limb, limb, limb, tail, tail, tail});
    // A neck without a head is the head; an unnamed chain is a limb; what lies between the trunk's is trunk.
    CHECK(labels_of_joints(figure({{"root", {}, ""},
                                   {"a", {}, "root"},
                                   {"torso", {}, "a"},
                                   {"neck", {}, "torso"},
                                   {"b", {}, "torso"},
                                   {"c", {}, "b"},
                                   {"d", {}, "torso"},
                                   {"left_wing", {}, "d"},
                                   {"left_elbow", {}, "left_wing"}})) ==
          std::vector<Label>{body, body, body, head, limb, limb, wing, wing, wing});
    // Several heads; a neck from which arms hang is trunk.
    CHECK(labels_of_joints(figure({{"hip", {}, ""},
                                   {"neck", {}, "hip"},
                                   {"left_arm", {}, "neck"},
                                   {"head1", {}, "neck"},
                                   {"head2", {}, "neck"}})) ==
          std::vector<Label>{body, body, limb, head, head});
    CHECK(labels_of_joints(figure({{"a", {}, ""}, {"b", {}, "a"}, {"c", {}, "a"}})).empty());
    CHECK(labels_of_joints({}).empty());
}

TEST_CASE("Pixels get the part of the nearest bone", "[animated-drawings]") {
    const Mask all(200, 200, 1);
    const LabelMap labels = labels_from_joints(all, figure(four_legged));
    REQUIRE_FALSE(labels.empty());
    const auto at = [&](int x, int y) { return static_cast<Label>(labels(x, y)); };
    CHECK(at(80, 60) == body);
    CHECK(at(80, 72) == body); // between the roots of the legs
    CHECK(at(55, 100) == limb);
    CHECK(at(105, 112) == limb);
    CHECK(at(12, 40) == head);
    CHECK(at(145, 42) == tail);
    CHECK(at(112, 58) == body);
    // In any order of the joints.
    std::vector<FigureJoint> reversed = figure(four_legged);
    std::reverse(reversed.begin(), reversed.end());
    for (FigureJoint& joint : reversed)
        if (joint.parent >= 0) joint.parent = static_cast<int>(reversed.size()) - 1 - joint.parent;
    const LabelMap again = labels_from_joints(all, reversed);
    long differ = 0; // at the borders of parts a tie may fall either way
    for (std::size_t i = 0; i < labels.size(); ++i) differ += labels.data()[i] != again.data()[i];
    CHECK(differ < 40);
    const Mask nothing(200, 200, 0);
    const LabelMap empty = labels_from_joints(nothing, figure(four_legged));
    CHECK(std::count(empty.begin(), empty.end(), 0) == std::ssize(empty));
}

TEST_CASE("Joints that do not say what is trunk and what is not give no labels", "[animated-drawings]") {
    const Mask all(50, 50, 1);
    CHECK(labels_from_joints(all, {}).empty());
    CHECK(labels_from_joints(all, figure({{"root", {5, 5}, ""}, {"torso", {9, 9}, "root"}})).empty());
    CHECK(labels_from_joints(all, figure({{"j1", {5, 5}, ""}, {"j2", {9, 9}, "j1"}, {"j3", {30, 9}, "j2"}}))
              .empty());
    // All names are known, but nothing hangs on anything.
    CHECK(labels_from_joints(all, figure({{"hip", {5, 5}, ""}, {"head", {9, 9}, ""}, {"knee", {20, 9}, ""}}))
              .empty());
}

TEST_CASE("A human figure's joints have their own bones; what is more is added to them",
          "[animated-drawings]") {
    const Mask all(200, 200, 1);
    const LabelMap labels = labels_from_joints(all, human());
    const auto share = [&](const LabelMap& map, Label label) {
        return std::count(map.begin(), map.end(), static_cast<std::uint8_t>(label));
    };
    // The neck is the middle of the head: the bone goes on beyond it.
    CHECK(labels(100, 14) == static_cast<std::uint8_t>(head));
    CHECK(labels(100, 52) == static_cast<std::uint8_t>(body)); // the head begins at six tenths
    CHECK(labels(100, 40) == static_cast<std::uint8_t>(head));
    CHECK(labels(83, 63) == static_cast<std::uint8_t>(body)); // a fifth of the arm is the trunk's
    CHECK(labels(76, 66) == static_cast<std::uint8_t>(limb));
    CHECK(share(labels, tail) == 0);
    std::vector<FigureJoint> tailed = human();
    tailed.push_back({"tail", {150, 125}, 1});
    const LabelMap more = labels_from_joints(all, tailed);
    CHECK(share(more, tail) > 100);
    CHECK(more(145, 125) == static_cast<std::uint8_t>(tail));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (more.data()[i] == static_cast<std::uint8_t>(tail)) continue;
        if (more.data()[i] != labels.data()[i]) CHECK(more.data()[i] == static_cast<std::uint8_t>(body));
    }
}

TEST_CASE("A limb of two joints begins at the first, a limb of one joint in the trunk",
          "[animated-drawings]") {
    const Mask all(200, 200, 1);
    std::vector<Row> bird = {{"root", {100, 60}, ""},           {"head", {40, 20}, "root"},
                             {"left_leg", {90, 110}, "root"},   {"left_foot", {90, 160}, "left_leg"},
                             {"right_leg", {120, 110}, "root"}, {"right_foot", {120, 160}, "right_leg"}};
    const LabelMap two = labels_from_joints(all, figure(bird));
    REQUIRE_FALSE(two.empty());
    const auto at = [](const LabelMap& map, int x, int y) { return static_cast<Label>(map(x, y)); };
    for (int y = 70; y <= 109; y += 3)
        for (int x = 92; x <= 118; ++x) CHECK(at(two, x, y) == body); // the belly, all of it
    CHECK(at(two, 105, 112) == body);
    for (const int x : {90, 120}) {
        CHECK(at(two, x, 125) == limb);
        CHECK(at(two, x, 158) == limb);
    }
    // Without its foot a leg's end is the leg's, and its beginning the trunk's.
    bird = {bird[0], bird[1], {"leg", {100, 160}, "root"}};
    const LabelMap one = labels_from_joints(all, figure(bird));
    CHECK(at(one, 100, 75) == body);
    CHECK(at(one, 100, 110) == limb);
    CHECK(at(one, 100, 158) == limb);
    // The 16 joints of a human figure have bones of their own, of arms and legs of any length.
    CHECK(labels_from_joints(all, human())(76, 66) == static_cast<std::uint8_t>(limb));
}

TEST_CASE("A fin is body, or of the tail, wing, limb or head that it hangs on", "[animated-drawings]") {
    const std::vector<Row> fish = {{"body", {100, 100}, ""},
                                   {"head", {30, 100}, "body"},
                                   {"tail", {150, 100}, "body"},
                                   {"fin_up", {180, 70}, "tail"},
                                   {"fin_low", {180, 130}, "tail"},
                                   {"dorsal_fin", {100, 40}, "body"},
                                   {"joint_7", {110, 20}, "dorsal_fin"},
                                   {"joint_8", {115, 10}, "joint_7"}};
    CHECK(labels_of_joints(figure(fish)) ==
          std::vector<Label>{body, head, tail, tail, tail, body, body, body});
    const LabelMap labels = labels_from_joints(Mask(200, 200, 1), figure(fish));
    REQUIRE_FALSE(labels.empty());
    CHECK(std::count(labels.begin(), labels.end(), static_cast<std::uint8_t>(limb)) == 0);
    CHECK(labels(100, 45) == static_cast<std::uint8_t>(body));
    CHECK(labels(178, 72) == static_cast<std::uint8_t>(tail));
    // A fish is no four-legged animal, but one with feet keeps them.
    CHECK(labels_of_joints(
              figure({{"body", {}, ""}, {"fin", {}, "body"}, {"leg", {}, "body"}, {"fins", {}, "leg"}})) ==
          std::vector<Label>{body, body, limb, limb});
}

TEST_CASE("Joints far from the silhouette are counted", "[animated-drawings]") {
    Mask mask(400, 400, 0); // its box is 60 by 80: a joint may be 5 away
    for (int y = 100; y < 180; ++y)
        for (int x = 100; x < 160; ++x) mask(x, y) = 1;
    const auto outside = [&](Point2d p) { return joints_outside(mask, {{"a", p, -1}}); };
    CHECK(outside({130, 140}) == 0);
    CHECK(outside({164, 140}) == 0);
    CHECK(outside({165, 140}) == 1);
    CHECK(outside({163, 183}) == 1); // by the diagonal
    CHECK(outside({95.5, 140}) == 0);
    CHECK(outside({-800, 800}) == 1);
    CHECK(joints_outside(mask, {{"a", {130, 140}, -1}, {"b", {0, 0}, 0}, {"c", {399.5, 1}, 0}}) == 2);
    CHECK(joints_outside(Mask(9, 9, 0), {{"a", {5, 5}, -1}}) == 1);
    CHECK(joints_outside(mask, {}) == 0);
}
