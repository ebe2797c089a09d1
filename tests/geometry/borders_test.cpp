// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <string>

#include "core/random.hpp"
#include "pantin/geometry.hpp"

using namespace pantin;

namespace {

Mask picture(const std::vector<std::string>& rows) {
    Mask mask(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) mask(x, y) = rows[y][x] == '#';
    return mask;
}

Mask random_mask(Random& random) {
    const int width = random.integer(1, 24), height = random.integer(1, 24);
    const double density = random.uniform(0.2, 0.95);
    Mask mask(width, height);
    for (auto& pixel : mask) pixel = random.chance(density);
    return mask;
}

using Pixels = std::set<std::pair<int, int>>;

// By definition: pixels with a 4-connected background neighbour.
Pixels border_pixels(const Mask& mask) {
    Pixels pixels;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (mask(x, y) && !(mask.value_or(x - 1, y, 0) && mask.value_or(x + 1, y, 0) &&
                                mask.value_or(x, y - 1, 0) && mask.value_or(x, y + 1, 0)))
                pixels.insert({x, y});
    return pixels;
}

// Labels 4-connected background (`eight` false) or 8-connected foreground regions by flooding; returns their
// number.
int count_regions(const Mask& mask, bool foreground) {
    Grid<int> seen(mask.width() + 2, mask.height() + 2);
    int regions = 0;
    for (int y0 = 0; y0 < seen.height(); ++y0)
        for (int x0 = 0; x0 < seen.width(); ++x0) {
            const auto wanted = [&](int x, int y) {
                return (mask.value_or(x - 1, y - 1, 0) != 0) == foreground;
            };
            if (seen(x0, y0) || !wanted(x0, y0)) continue;
            ++regions;
            std::vector<Point2i> stack = {{x0, y0}};
            seen(x0, y0) = 1;
            while (!stack.empty()) {
                const Point2i p = stack.back();
                stack.pop_back();
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int x = p.x + dx, y = p.y + dy;
                        if (!foreground && dx != 0 && dy != 0) continue;
                        if (!seen.contains(x, y) || seen(x, y) || !wanted(x, y)) continue;
                        seen(x, y) = 1;
                        stack.push_back({x, y});
                    }
            }
        }
    return regions;
}

} // namespace

TEST_CASE("border following: one pixel, a line, the full image") {
    CHECK(follow_borders(Mask(0, 0)).empty());
    CHECK(follow_borders(Mask(5, 4)).empty());
    const auto one = follow_borders(picture({"...", ".#.", "..."}));
    REQUIRE(one.size() == 1);
    CHECK(one[0].points == std::vector<Point2i>{{1, 1}});
    CHECK(closed_length(one[0].points) == 0);
    const auto line = follow_borders(picture({"####"}));
    REQUIRE(line.size() == 1);
    CHECK(line[0].points == std::vector<Point2i>{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 0}, {1, 0}});
    CHECK(closed_length(line[0].points) == 6);
    const auto full = follow_borders(picture({"###", "###", "###"}));
    REQUIRE(full.size() == 1);
    CHECK(full[0].points ==
          std::vector<Point2i>{{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}});
}

TEST_CASE("border following: counterclockwise outside, holes from the pixel to their left") {
    const auto borders = follow_borders(picture({"####", "#..#", "####"}));
    REQUIRE(borders.size() == 2);
    CHECK(borders[0].outer);
    CHECK(borders[0].points.size() == 10);
    CHECK_FALSE(borders[1].outer);
    CHECK(borders[1].parent == 0);
    CHECK(borders[1].points == std::vector<Point2i>{{0, 1}, {1, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 2}});
    CHECK(closed_length(borders[1].points) == Approx(2 + 4 * std::sqrt(2.0)));
}

TEST_CASE("border following: hierarchy of nested rings and their neighbours") {
    // Suzuki & Abe, Figure 3, in kind: ring, ring in its hole, dot in that one's hole, and a dot outside.
    const auto borders = follow_borders(picture({
        "#########...",
        "#.......#...",
        "#.#####.#.#.",
        "#.#...#.#...",
        "#.#.#.#.#...",
        "#.#...#.#...",
        "#.#####.#...",
        "#.......#...",
        "#########...",
    }));
    REQUIRE(borders.size() == 6);
    const std::vector<bool> outer = {true, false, true, true, false, true};
    const std::vector<int> parent = {-1, 0, 1, -1, 2, 4};
    for (int i = 0; i < 6; ++i) {
        CHECK(borders[i].outer == outer[i]);
        CHECK(borders[i].parent == parent[i]);
    }
    CHECK(borders[5].points == std::vector<Point2i>{{4, 4}});
}

TEST_CASE("border following: a one-pixel neck is visited on both sides") {
    const auto borders = follow_borders(picture({"##..##", "######", "##..##"}));
    REQUIRE(borders.size() == 1);
    int visits = 0;
    for (const Point2i p : borders[0].points) visits += p == Point2i{2, 1};
    CHECK(visits == 2);
}

TEST_CASE("border following finds exactly the border pixels, once per region") {
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        const Mask mask = random_mask(random);
        const auto borders = follow_borders(mask);
        Pixels found;
        int outer = 0, holes = 0;
        for (std::size_t b = 0; b < borders.size(); ++b) {
            (borders[b].outer ? outer : holes) += 1;
            const auto& points = borders[b].points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                found.insert({points[i].x, points[i].y});
                const Point2i next = points[(i + 1) % points.size()];
                REQUIRE(std::max(std::abs(next.x - points[i].x), std::abs(next.y - points[i].y)) <= 1);
            }
            REQUIRE(borders[b].parent < static_cast<int>(b));
            if (borders[b].parent >= 0)
                REQUIRE(borders[borders[b].parent].outer != borders[b].outer);
            else
                REQUIRE(borders[b].outer);
        }
        REQUIRE(found == border_pixels(mask));
        REQUIRE(outer == count_regions(mask, true));
        REQUIRE(holes + 1 == count_regions(mask, false));
    }
}

TEST_CASE("border following moves with the picture") {
    Random random(4);
    const Mask mask = random_mask(random);
    Mask moved(mask.width() + 7, mask.height() + 5);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) moved(x + 4, y + 3) = mask(x, y);
    const auto a = follow_borders(mask), b = follow_borders(moved);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].outer == b[i].outer);
        CHECK(a[i].parent == b[i].parent);
        REQUIRE(a[i].points.size() == b[i].points.size());
        for (std::size_t k = 0; k < a[i].points.size(); ++k)
            REQUIRE(b[i].points[k] == Point2i{a[i].points[k].x + 4, a[i].points[k].y + 3});
    }
}
