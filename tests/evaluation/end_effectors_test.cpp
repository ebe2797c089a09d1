// SPDX-License-Identifier: MIT
// Limbs are counted as they are drawn: legs that have grown together are still several.
#include <catch2/catch.hpp>

#include <cmath>

#include "core/random.hpp"
#include "evaluation/end_effectors.hpp"

namespace pantin::test {
namespace {

void fill(LabelMap& labels, const Box& box, Label label) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) labels(x, y) = static_cast<std::uint8_t>(label);
}

// A trunk with a head on the right and four legs, 8 wide and 30 long, at these places.
LabelMap animal(const std::array<int, 4>& legs) {
    LabelMap labels(120, 80, 0);
    fill(labels, {10, 20, 90, 20}, Label::body);
    fill(labels, {100, 10, 15, 20}, Label::head);
    for (const int x : legs) fill(labels, {x, 40, 8, 30}, Label::limb);
    return labels;
}

std::vector<SkeletonEnd> feet(const std::vector<int>& places) {
    std::vector<SkeletonEnd> ends = {{{112, 20}, Label::head}};
    for (const int x : places) ends.push_back({{static_cast<double>(x), 66}, Label::limb});
    return ends;
}

int reached(const LabelMap& labels, const std::vector<SkeletonEnd>& ends, int limbs) {
    return count_ends(labels, ends, limbs, 3).reached;
}

} // namespace

TEST_CASE("Legs merged in pairs are two pieces and four limbs") {
    const LabelMap pairs = animal({12, 20, 80, 88}), apart = animal({12, 35, 65, 88});
    const auto four = feet({16, 24, 84, 92}), two = feet({20, 88});
    // As pieces two ends are enough: the zebra of four legs that scores all of them.
    const EndCount pieces = count_ends(pairs, two, -1, 3);
    CHECK((pieces.parts == 3 && pieces.reached == 3 && !pieces.limbs_known && pieces.all()));
    const EndCount drawn = count_ends(pairs, two, 4, 3);
    CHECK((drawn.parts == 5 && drawn.reached == 3 && drawn.limbs_known && !drawn.all()));
    CHECK(reached(pairs, four, 4) == 5);
    CHECK(count_ends(apart, feet({16, 39, 69, 92}), 4, 3).all());
}

TEST_CASE("An end more in one leg is no end of another") {
    const LabelMap apart = animal({12, 35, 65, 88});
    CHECK(reached(apart, feet({14, 18, 39, 69}), 4) == 4); // a forked foot, and one leg without
    CHECK(reached(apart, feet({14, 16, 18, 39}), 4) == 3);
    // In merged legs it may be: three pieces for four limbs leave room for one.
    const LabelMap joined = animal({12, 20, 65, 88});
    CHECK(reached(joined, feet({16, 24, 69, 92}), 4) == 5);
    CHECK(reached(joined, feet({14, 16, 24, 69}), 4) == 4);
}

TEST_CASE("An end counts for the part that it is labelled as and close to, and for one limb alone") {
    const LabelMap apart = animal({12, 35, 65, 88});
    std::vector<SkeletonEnd> ends = feet({16, 39, 69, 92});
    ends[1].label = Label::body;
    CHECK(reached(apart, ends, 4) == 4);
    CHECK(reached(apart, feet({8, 39, 69, 92}), 4) == 4); // 4 pixels from the leg
    CHECK(reached(apart, feet({9, 39, 69, 92}), 4) == 5); // 3
    const LabelMap close = animal({12, 22, 65, 88});
    CHECK(reached(close, feet({20, 69, 92}), 4) == 4);  // between two legs: the left one's
    CHECK(reached(close, feet({20, 69, 92}), -1) == 5); // as pieces it did for both
    CHECK(reached(apart, {}, 4) == 0);
    CHECK(count_ends(apart, {}, 0, 3).parts == 5); // none counted but some there: pieces
}

TEST_CASE("There are never more limbs with an end than limbs or ends, and another end takes none away") {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        std::array<int, 4> legs{};
        for (int& leg : legs) leg = random.integer(10, 92);
        const LabelMap labels = animal(legs);
        const int limbs = random.integer(1, 6);
        std::vector<SkeletonEnd> ends;
        int before = 0;
        for (int i = 0; i < 8; ++i) {
            ends.push_back({{random.uniform(5, 105), random.uniform(38, 75)}, Label::limb});
            const EndCount count = count_ends(labels, ends, limbs, 3);
            CHECK(count.parts == limbs + 1);
            CHECK((count.reached <= limbs && count.reached <= i + 1));
            CHECK((count.reached == before || count.reached == before + 1));
            before = count.reached;
        }
    }
}

} // namespace pantin::test
