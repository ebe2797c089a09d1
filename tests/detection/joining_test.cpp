// SPDX-License-Identifier: MIT
// Parts of a figure that were found as figures of their own.
#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "detection/joining.hpp"
#include "pantin/image.hpp"

namespace pantin {
namespace {

// Filled boxes as groups 1, 2, …; scores .1, .2, …, of the detections 0, 1, …
Grouping boxes_on(int width, int height, const std::vector<Box>& boxes) {
    Grouping grouping{Grid<int>(width, height, 0), boxes, {}, {}};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box& box = boxes[i];
        for (int y = box.y; y < box.y + box.height; ++y)
            for (int x = box.x; x < box.x + box.width; ++x) grouping.groups(x, y) = static_cast<int>(i) + 1;
        grouping.scores.push_back(0.1 * static_cast<double>(i + 1));
        grouping.detections.push_back(static_cast<int>(i));
    }
    return grouping;
}

} // namespace

TEST_CASE("What touches a larger group within its reach and has a low score joins it") {
    // A ball (group 1) that touches a figure (2) at a corner and lies beside its box by half; a flower (3) a
    // pixel away.
    Grouping page = boxes_on(40, 30, {{4, 10, 4, 4}, {8, 14, 10, 10}, {19, 20, 3, 3}});
    page.boxes[1] = {6, 6, 12, 18}; // the figure has an arm above the ball
    page.scores = {0.7, 0.6, 0.5};
    const Grouping joined = join_pieces(page, {});
    REQUIRE(joined.boxes.size() == 2);
    CHECK((joined.boxes[0] == Box{4, 6, 14, 18}));
    CHECK((joined.boxes[1] == Box{19, 20, 3, 3}));
    CHECK((joined.scores == std::vector<double>{0.6, 0.5}));
    CHECK((joined.detections == std::vector<int>{1, 2}));
    CHECK(joined.groups(4, 10) == 1);
    CHECK(joined.groups(10, 15) == 1);
    CHECK(joined.groups(20, 21) == 2);
    CHECK(joined.groups(0, 0) == 0);

    const auto kept = [&](auto change) {
        Grouping changed = page;
        change(changed);
        return join_pieces(changed, {}).boxes.size() == 3;
    };
    CHECK_FALSE(kept([](Grouping&) {}));
    CHECK(kept([](Grouping& g) { g.scores[0] = 0.85; }));           // the network is sure of it
    CHECK(kept([](Grouping& g) { g.boxes[1] = {8, 14, 10, 10}; })); // beside it: a tree on the same grass
    CHECK(kept([](Grouping& g) { g.scores.clear(); }));             // the contour detector has none
    DetectionOptions never;
    never.part_score = 0;
    CHECK(join_pieces(page, never).boxes.size() == 3);
}

TEST_CASE("A part of a part belongs to the whole, and to the one that it touches most") {
    Grouping chain = boxes_on(60, 20, {{0, 0, 2, 2}, {2, 0, 5, 5}, {7, 0, 20, 10}});
    chain.boxes = {{0, 0, 2, 2}, {0, 0, 7, 7}, {0, 0, 27, 10}};
    const Grouping whole = join_pieces(chain, {});
    REQUIRE(whole.boxes.size() == 1);
    CHECK((whole.boxes[0] == Box{0, 0, 27, 10}));
    CHECK(whole.scores == std::vector<double>{chain.scores[2]});

    // Between two figures: with one it has a side in common, with the other a corner.
    Grouping between = boxes_on(60, 40, {{20, 10, 4, 4}, {0, 0, 20, 30}, {24, 14, 20, 20}});
    between.boxes[1].width = between.boxes[2].width = 30;
    between.boxes[2].x = 14;
    between.scores = {0.5, 0.9, 0.9};
    const Grouping given = join_pieces(between, {});
    REQUIRE(given.boxes.size() == 2);
    CHECK(given.groups(21, 11) == given.groups(1, 1));
}

TEST_CASE("Joining keeps the ink: every pixel of it is in one group, inside that group's box") {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<Box> boxes;
        for (int k = random.integer(0, 7); k > 0; --k)
            boxes.push_back(
                {random.integer(0, 30), random.integer(0, 30), random.integer(1, 9), random.integer(1, 9)});
        const Grouping page = boxes_on(40, 40, boxes);
        DetectionOptions options;
        options.part_score = 0.1 * random.integer(0, 9);
        options.part_overlap = 0;
        const Grouping joined = join_pieces(page, options);
        CHECK(joined.scores.size() == joined.boxes.size());
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                REQUIRE((joined.groups(x, y) > 0) == (page.groups(x, y) > 0));
                if (joined.groups(x, y) == 0) continue;
                REQUIRE(joined.groups(x, y) <= static_cast<int>(joined.boxes.size()));
                const Box& box = joined.boxes[static_cast<std::size_t>(joined.groups(x, y)) - 1];
                REQUIRE((x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height));
            }
    }
}

} // namespace pantin
