// SPDX-License-Identifier: MIT
// Several drawn legs in one limb: outlines drawn by the test, counted by hand.
#include <catch2/catch.hpp>

#include "pantin/warnings.hpp"
#include "warnings/figures.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

int joint_of(const ReferenceSkeleton& reference, const std::string& name) {
    for (std::size_t j = 0; j < reference.joints.size(); ++j)
        if (reference.joints[j].name == name) return static_cast<int>(j);
    return -1;
}

// A body, and below it one limb 40 pixels wide and 40 high with vertical strokes in it.
struct Block {
    ReferenceSkeleton reference = find_reference(load_references(), "quadruped");
    LabelMap labels{80, 80};
    Grid<float> ink{80, 80};
    Rig rig;
    Block(const std::vector<int>& strokes, int from, const std::vector<std::string>& legs) {
        fill(labels, 10, 10, 70, 30, Label::body);
        fill(labels, 20, 30, 60, 70, Label::limb);
        for (const int x : strokes)
            for (int y = from; y < 70; ++y) ink(x, y) = ink(x + 1, y) = 1;
        rig.width = rig.height = 80;
        rig.bones = {{"hips", -1, {40, 20}, {40, 10}, Label::body, joint_of(reference, "hips")}};
        for (const std::string& leg : legs) {
            const int parent = static_cast<int>(rig.bones.size());
            rig.bones.push_back({leg, 0, {40, 30}, {40, 50}, Label::limb, joint_of(reference, leg), 0});
            rig.bones.push_back(
                {leg + ".1", parent, {40, 50}, {40, 69}, Label::limb, joint_of(reference, leg), 1});
        }
    }
    double joined() const { return joined_limbs(ink, labels, rig, reference); }
};

} // namespace

TEST_CASE("Outlines of two legs in a limb with one leg are joined limbs", "[warnings]") {
    CHECK(Block({20, 32, 44, 58}, 30, {"leg_front_left"}).joined() == 1);
    CHECK(Block({20, 32, 44, 58}, 40, {"leg_front_left"}).joined() == Approx(0.75)); // from row 40 of 30 … 69
    CHECK(is_marked(WarningKind::joined_limbs, 0.75));
    CHECK(Block({20, 32, 44, 58}, 50, {"leg_front_left"}).joined() == Approx(0.5));
    CHECK_FALSE(is_marked(WarningKind::joined_limbs, 0.5));
}

TEST_CASE("A leg's own outline, outlines of as many legs as the limb has, and other limbs are not",
          "[warnings]") {
    CHECK(Block({20, 58}, 30, {"leg_front_left"}).joined() == 0);
    CHECK(Block({20, 32, 44}, 30, {"leg_front_left"}).joined() == 0); // a crease
    CHECK(Block({20, 32, 44, 58}, 30, {"leg_front_left", "leg_front_right"}).joined() == 0);
    CHECK(Block({20, 32, 44, 58}, 30, {}).joined() == 0);
    CHECK(Block({20, 32, 44, 58}, 30, {"tail"}).joined() == 0); // it does not step
}
