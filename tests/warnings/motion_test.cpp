// SPDX-License-Identifier: MIT
// Warnings about the motion: rigs made by hand that hang their heads, keep their limbs still, or are small.
#include <catch2/catch.hpp>

#include "pantin/warnings.hpp"
#include "warnings/figures.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// A body with a head above it, and a bone for each; the head turns about the middle of the neck (20, 13).
struct Nodding {
    LabelMap labels{40, 40};
    Rig rig;
    Nodding() {
        fill(labels, 14, 2, 26, 14, Label::head);
        fill(labels, 10, 14, 30, 38, Label::body);
        rig = rig_on(labels, {{"body", -1, {20, 26}, {20, 14}}, {"head", 0, {20, 13}, {20, 2}}},
                     [](int, int y) { return y < 14 ? 1 : 0; });
    }
    // `sines`, `cosines`: of half the head's angle.
    double hanging(const std::vector<double>& cosines, const std::vector<double>& sines,
                   int samples = 4) const {
        const BoneAnimation animation = turning("nod", {std::vector<double>(cosines.size(), 1), cosines},
                                                {std::vector<double>(cosines.size(), 0), sines});
        return hanging_head(rig, labels, posed(rig, animation, samples));
    }
};

// A body with two limbs below it, a bone for each of the three.
struct Walking {
    LabelMap labels{60, 60};
    Rig rig;
    Walking() {
        fill(labels, 10, 10, 50, 30, Label::body);
        fill(labels, 12, 30, 20, 56, Label::limb);
        fill(labels, 40, 30, 48, 56, Label::limb);
        rig = rig_on(labels,
                     {{"hips", -1, {30, 20}, {30, 12}},
                      {"left", 0, {16, 30}, {16, 55}},
                      {"right", 0, {44, 30}, {44, 55}}},
                     [](int x, int y) { return y < 30   ? 0
                                               : x < 30 ? 1
                                                        : 2; });
    }
    // Which bones swing.
    double still(bool hips, bool left, bool right) const {
        const auto cosines = [](bool swings) { return std::vector<double>{1, swings ? 0.96 : 1, 1}; };
        const auto sines = [](bool swings) { return std::vector<double>{0, swings ? 0.28 : 0, 0}; };
        const BoneAnimation walk = turning("walk", {cosines(hips), cosines(left), cosines(right)},
                                           {sines(hips), sines(left), sines(right)});
        return still_limbs(rig, labels, posed(rig, walk));
    }
};

} // namespace

TEST_CASE("A head that is turned over through the clip hangs, one that nods does not", "[warnings]") {
    const Nodding figure;
    CHECK(figure.hanging({1, 1}, {0, 0}) == 0);
    CHECK(figure.hanging({0.8, 0.8}, {0.6, 0.6}) == 0); // by 74 degrees
    CHECK(figure.hanging({0, 0}, {1, 1}) == 1);         // by 180
    CHECK(is_marked(WarningKind::hanging_head, figure.hanging({0, 0}, {1, 1})));
    // Upright at first, over from the second key on: of the four poses the last two hang.
    CHECK(figure.hanging({1, 1, 0, 0, 0}, {0, 0, 1, 1, 1}) == Approx(0.5));
    CHECK_FALSE(is_marked(WarningKind::hanging_head, 0.5));
}

TEST_CASE("A head that is drawn below the body may hang, and without a head nothing does", "[warnings]") {
    LabelMap labels(40, 40);
    fill(labels, 10, 2, 30, 26, Label::body);
    Rig rig = rig_on(labels, {{"body", -1, {20, 14}, {20, 2}}}, [](int, int) { return 0; });
    const BoneAnimation over = turning("over", {{0, 0}}, {{1, 1}});
    CHECK(hanging_head(rig, labels, posed(rig, over)) == 0);
    fill(labels, 14, 26, 26, 38, Label::head);
    rig = rig_on(labels, {{"body", -1, {20, 14}, {20, 2}}}, [](int, int) { return 0; });
    CHECK(hanging_head(rig, labels, posed(rig, over)) == 0);
}

TEST_CASE("Limbs that the body takes along are still, those that swing are not", "[warnings]") {
    const Walking figure;
    CHECK(figure.still(false, true, true) == 0);
    CHECK(figure.still(true, true, true) == 0);
    CHECK(figure.still(false, false, true) == Approx(0.5));
    CHECK(is_marked(WarningKind::still_limbs, 0.5));
    CHECK(figure.still(false, false, false) == 1);
    CHECK(figure.still(true, false, false) == 1); // the whole figure turns, stiff
}

TEST_CASE("Specks of a limb do not count, and without limbs none is still", "[warnings]") {
    Walking figure;
    fill(figure.labels, 54, 2, 57, 5, Label::limb); // 9 of about 1200 pixels
    figure.rig = rig_on(figure.labels, figure.rig.bones, [](int x, int y) {
        return y < 30 ? 0 : x < 30 ? 1 : 2;
    });
    CHECK(figure.still(false, true, true) == 0);
    fill(figure.labels, 54, 2, 59, 8, Label::limb); // 30
    figure.rig = rig_on(figure.labels, figure.rig.bones, [](int x, int y) {
        return y < 30 ? 0 : x < 30 ? 1 : 2;
    });
    CHECK(figure.still(false, true, true) == Approx(1.0 / 3));
    const Nodding other;
    CHECK(still_limbs(other.rig, other.labels,
                      posed(other.rig, turning("walk", {{1, 1}, {1, 1}}, {{0, 0}, {0, 0}}))) == 0);
}

TEST_CASE("A figure is measured by its longer side against the frame's, in the mean of the poses",
          "[warnings]") {
    const PosedClip clip{"walk", {{{0, 0, 0}, {1, 2, 0}}, {{3, 0, 5}, {4, 1, 0}}}}; // 2 and 1 long
    CHECK(figure_size(clip, {0, 0, 10, 4}) == Approx(0.15));
    CHECK(is_marked(WarningKind::small_figure, figure_size(clip, {0, 0, 10, 4})));
    CHECK(figure_size(clip, {0, 0, 4, 3}) == Approx(0.375));
    CHECK_FALSE(is_marked(WarningKind::small_figure, figure_size(clip, {0, 0, 4, 3})));
    CHECK(figure_size({"walk", {{}}}, {0, 0, 10, 4}) == 1);
}
