// SPDX-License-Identifier: MIT
// Pixel operations against plain definitions: morphology, components, distances, sizes.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "pantin/image.hpp"

using namespace pantin;

namespace {

Mask from_rows(const std::vector<std::string>& rows) {
    Mask mask(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) mask(x, y) = rows[y][x] == '#';
    return mask;
}

Mask random_mask(std::mt19937& random, int width, int height, int percent) {
    Mask mask(width, height);
    for (auto& value : mask) value = random() % 100 < static_cast<unsigned>(percent);
    return mask;
}

struct RandomMasks {
    std::mt19937 random{7};
    template <class Check> void run(Check check) {
        for (int trial = 0; trial < 150; ++trial) {
            const int w = 1 + static_cast<int>(random() % 43), h = 1 + static_cast<int>(random() % 19);
            const int percents[] = {0, 1, 3, 20, 50, 90, 99, 100};
            check(random_mask(random, w, h, percents[trial % 8]));
        }
    }
};

// 1 when any pixel of `mask` with `value` satisfies near(dx, dy) as seen from (x, y); outside pixels are 0.
template <class Near>
bool any_near(const Mask& mask, int x, int y, int reach, std::uint8_t value, Near near) {
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            if (near(dx, dy) && mask.value_or(x + dx, y + dy, 0) == value) return true;
    return false;
}

// The smallest box around the pixels with that number.
Box box_of(const Grid<int>& ids, int id) {
    int left = ids.width(), top = ids.height(), right = -1, bottom = -1;
    for (int y = 0; y < ids.height(); ++y)
        for (int x = 0; x < ids.width(); ++x)
            if (ids(x, y) == id)
                left = std::min(left, x), top = std::min(top, y), right = std::max(right, x), bottom = y;
    return {left, top, right - left + 1, bottom - top + 1};
}

} // namespace

TEST_CASE("Morphology equals its definition on random masks") {
    RandomMasks masks;
    masks.run([&](const Mask& mask) {
        const int r = static_cast<int>(masks.random() % 5);
        const double radius = (masks.random() % 9) / 2.0;
        const auto square = [&](int dx, int dy) { return std::abs(dx) <= r && std::abs(dy) <= r; };
        const auto disc = [&](int dx, int dy) { return dx * dx + dy * dy <= radius * radius; };
        const Mask ds = dilate_square(mask, r), es = erode_square(mask, r);
        const Mask dd = dilate_disc(mask, radius), ed = erode_disc(mask, radius);
        const Mask cs = close_square(mask, r), cd = close_disc(mask, radius), od = open_disc(mask, radius);
        bool same = true, extensive = true;
        for (int y = 0; y < mask.height(); ++y) {
            for (int x = 0; x < mask.width(); ++x) {
                same = same && ds(x, y) == any_near(mask, x, y, 5, 1, square);
                same = same && es(x, y) == !any_near(mask, x, y, 5, 0, square);
                same = same && dd(x, y) == any_near(mask, x, y, 5, 1, disc);
                same = same && ed(x, y) == !any_near(mask, x, y, 5, 0, disc);
                extensive =
                    extensive && cs(x, y) >= mask(x, y) && cd(x, y) >= mask(x, y) && od(x, y) <= mask(x, y);
            }
        }
        CHECK(same);
        CHECK(extensive);
        CHECK(close_square(cs, r) == cs); // idempotent
        CHECK(close_disc(cd, radius) == cd);
    });
}

// Distances up to 255 lie in bytes.
TEST_CASE("A dilation by a disc of any size covers what is so near") {
    std::mt19937 random{11};
    const Mask mask = random_mask(random, 601, 3, 1);
    const Grid<int> seeds = nearest_seed(mask);
    const auto holds = [&](double radius) {
        const Mask near = dilate_disc(mask, radius);
        bool same = true;
        for (int y = 0; y < mask.height(); ++y)
            for (int x = 0; x < mask.width(); ++x) {
                const int nearest = seeds(x, y);
                const double dx = nearest % mask.width() - x, dy = nearest / mask.width() - y;
                same = same && near(x, y) == (dx * dx + dy * dy <= radius * radius);
            }
        return same;
    };
    for (const double radius : {0.0, 0.5, 1.5, 7.0, 40.5, 253.9, 254.0, 255.0, 256.5, 700.0})
        CHECK(holds(radius));
}

TEST_CASE("A closing bridges gaps of twice its radius") {
    const Mask line = from_rows(
        {"...............", "...............", "####....#######", "...............", "..............."});
    CHECK(close_square(line, 2)(5, 2) == 1);
    CHECK(connected_components(close_square(line, 2)).list.size() == 1);
    CHECK(connected_components(close_square(line, 1)).list.size() == 2);
}

TEST_CASE("The distance transform is exact on random masks") {
    RandomMasks masks;
    masks.run([&](const Mask& mask) {
        const Grid<int> squared = squared_distance_transform(mask);
        const Grid<int> nearest = nearest_seed(mask);
        const int w = mask.width(), h = mask.height();
        bool exact = true, tied_low = true;
        for (int y = 0; y < h; ++y) {
            for (int x = 0; x < w; ++x) {
                int best = std::numeric_limits<int>::max(), seed = -1, seed_distance = best;
                for (int v = -1; v <= h; ++v) {
                    for (int u = -1; u <= w; ++u) {
                        const int d = (u - x) * (u - x) + (v - y) * (v - y);
                        if (mask.value_or(u, v, 0) == 0)
                            best = std::min(best, d);
                        else if (d < seed_distance)
                            seed_distance = d, seed = v * w + u; // ties: raster order
                    }
                }
                exact = exact && squared(x, y) == best;
                tied_low = tied_low && nearest(x, y) == seed;
            }
        }
        CHECK(exact);
        CHECK(tied_low);
    });
    CHECK(distance_transform(Mask(5, 5, 1))(2, 2) == 3.0f);
    CHECK(squared_distance_transform(Mask(0, 0)).empty());
}

TEST_CASE("The distance transform does not overflow on the longest page") {
    Mask strip(max_image_side, 3, 1);
    CHECK(squared_distance_transform(strip)(8000, 1) == 4);
    Mask seeds(max_image_side, 3);
    seeds(0, 2) = 1;
    CHECK(nearest_seed(seeds)(max_image_side - 1, 0) == 2 * max_image_side);
    CHECK(dilate_disc(seeds, max_image_side - 2)(max_image_side - 2, 2) == 1);
    CHECK(dilate_disc(seeds, max_image_side - 2)(max_image_side - 1, 2) == 0);
    CHECK(dilate_disc(Mask(9, 9), 100) == Mask(9, 9)); // nothing to dilate
}

TEST_CASE("Components are 8-connected and numbered in raster order") {
    const Mask mask = from_rows({".#...#", "#.....", "..##.#", "#...#.", "#....."});
    const Components found = connected_components(mask);
    REQUIRE(found.list.size() == 4);
    CHECK(found.ids(1, 0) == 1);
    CHECK(found.ids(0, 1) == 1); // diagonal
    CHECK(found.ids(5, 0) == 2);
    CHECK(found.ids(2, 2) == 3);
    CHECK(found.ids(5, 2) == 3); // through (4, 3)
    CHECK(found.ids(0, 4) == 4);
    CHECK(found.list[2].area == 4);
    CHECK(found.list[2].box == Box{2, 2, 4, 2});
    CHECK(largest_component(mask) == component_mask(found, 3));
    CHECK(largest_component(Mask(3, 3)) == Mask(3, 3));
}

TEST_CASE("Components equal a flood fill on random masks") {
    RandomMasks masks;
    masks.run([&](const Mask& mask) {
        const Components found = connected_components(mask);
        Grid<int> expected(mask.width(), mask.height(), 0);
        int count = 0;
        std::vector<int> areas;
        for (int y = 0; y < mask.height(); ++y) {
            for (int x = 0; x < mask.width(); ++x) {
                if (!mask(x, y) || expected(x, y)) continue;
                std::vector<Point2i> stack{{x, y}};
                expected(x, y) = ++count;
                areas.push_back(0);
                while (!stack.empty()) {
                    const Point2i p = stack.back();
                    stack.pop_back();
                    ++areas.back();
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx)
                            if (mask.value_or(p.x + dx, p.y + dy, 0) && !expected(p.x + dx, p.y + dy)) {
                                expected(p.x + dx, p.y + dy) = count;
                                stack.push_back({p.x + dx, p.y + dy});
                            }
                }
            }
        }
        CHECK(found.ids == expected);
        REQUIRE(found.list.size() == static_cast<std::size_t>(count));
        for (const Component& c : found.list) {
            CHECK(c.area == areas[c.id - 1]);
            CHECK(c.box == box_of(expected, c.id));
            Mask own(mask.width(), mask.height());
            std::transform(expected.begin(), expected.end(), own.begin(), [&](int id) { return id == c.id; });
            CHECK(component_mask(found, c.id) == own);
        }
    });
}

TEST_CASE("Holes are 4-connected, bounded in area and never open to the border") {
    const Mask ring = from_rows({"......", ".####.", ".#..#.", ".#..#.", ".####.", "......"});
    CHECK(fill_holes(ring)(2, 2) == 1);
    CHECK(fill_holes(ring, 3) == ring);
    const Mask diagonal = from_rows({".....", "..#..", ".#.#.", "..#..", "....."});
    CHECK(fill_holes(diagonal)(2, 2) == 1); // an 8-connected ring holds a 4-connected hole
    const Mask open = from_rows({".###.", ".#.#.", ".#.#."});
    CHECK(fill_holes(open) == open);
}

TEST_CASE("Holes are what no background beside the border leads to") {
    RandomMasks masks;
    masks.run([&](const Mask& mask) {
        Mask open(mask.width() + 2, mask.height() + 2);
        open(0, 0) = 1;
        for (bool grown = true; grown;) {
            grown = false;
            for (int y = 0; y < open.height(); ++y)
                for (int x = 0; x < open.width(); ++x) {
                    if (open(x, y) || mask.value_or(x - 1, y - 1, 0)) continue;
                    open(x, y) = open.value_or(x - 1, y, 0) || open.value_or(x + 1, y, 0) ||
                                 open.value_or(x, y - 1, 0) || open.value_or(x, y + 1, 0);
                    grown = grown || open(x, y);
                }
        }
        Mask filled = unpad(open, 1);
        for (std::uint8_t& pixel : filled) pixel = !pixel;
        CHECK(fill_holes(mask) == filled);
    });
}

TEST_CASE("Resizing keeps constants, means and identity") {
    std::mt19937 random{3};
    Grid<float> image(12, 8);
    for (float& v : image) v = static_cast<float>(random() % 1000) / 1000.0f;
    CHECK(resize(image, 12, 8) == image);
    const Grid<float> half = resize(image, 6, 4);
    CHECK(half(2, 1) == Approx((image(4, 2) + image(5, 2) + image(4, 3) + image(5, 3)) / 4));
    CHECK(resize(Grid<float>(7, 5, 0.3f), 3, 4) == Grid<float>(3, 4, 0.3f));
    CHECK(resize(Grid<float>(7, 5, 0.3f), 20, 31) == Grid<float>(20, 31, 0.3f));
    double mean = 0, small_mean = 0;
    for (float v : image) mean += v / 96;
    for (float v : resize(image, 5, 3)) small_mean += v / 15;
    CHECK(small_mean == Approx(mean)); // area average
    Grid<float> two(2, 1);
    two(1, 0) = 1;
    const Grid<float> four = resize(two, 4, 1); // half-pixel centres: 0, ¼, ¾, 1
    CHECK(four(0, 0) == 0.0f);
    CHECK(four(1, 0) == 0.25f);
    CHECK(four(2, 0) == 0.75f);
    CHECK(four(3, 0) == 1.0f);
    CHECK_THROWS_AS(resize(two, 0, 4), Error);
    CHECK(resize(RgbImage(4, 4, Rgb8{1, 2, 3}), 2, 9) == RgbImage(2, 9, Rgb8{1, 2, 3}));
}

TEST_CASE("A mask shrinks by majority and grows by nearest pixel") {
    const Mask mask = from_rows({"##..", "#...", "....", "...#"});
    CHECK(resize_mask(mask, 2, 2) == from_rows({"#.", ".."}));
    CHECK(resize_mask(from_rows({"#.", ".."}), 4, 4) == from_rows({"##..", "##..", "....", "...."}));
    CHECK(resize_mask(mask, 4, 4) == mask);
    CHECK(resize_mask(from_rows({"##.", "##.", "..."}), 2, 2)(0, 0) == 1);
    LabelMap labels(2, 1);
    labels(0, 0) = 3, labels(1, 0) = 5;
    const LabelMap wide = resize_nearest(labels, 5, 2);
    CHECK(wide(1, 1) == 3);
    CHECK(wide(2, 0) == 5); // centre 2.5 / 5 · 2 = 1
    CHECK(wide(3, 0) == 5);
}
