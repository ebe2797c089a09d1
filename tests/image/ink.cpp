// SPDX-License-Identifier: MIT
// What is drawn and what is paper: colours on light, dark, tinted and ruled ground, without a ground, and
// filled areas that are hardly darker than the paper.
#include <catch2/catch.hpp>

#include <random>

#include "pantin/image.hpp"

using namespace pantin;

namespace {

constexpr int width = 360, height = 280;

bool on_stroke(int x, int y) { // the outline of a box, five pixels thick
    const bool within = x >= 80 && x < 280 && y >= 60 && y < 220;
    return within && (x < 85 || x >= 275 || y < 65 || y >= 215);
}
bool in_fill(int x, int y) { return x >= 120 && x < 240 && y >= 100 && y < 180; }

RgbImage page_of(Rgb8 ground, Rgb8 stroke, Rgb8 fill, int noise = 0) {
    std::mt19937 random{3};
    RgbImage page(width, height);
    const auto shake = [&](std::uint8_t v) {
        const int n = noise == 0 ? 0 : static_cast<int>(random() % (2 * noise + 1)) - noise;
        return static_cast<std::uint8_t>(std::clamp(v + n, 0, 255));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb8 c = on_stroke(x, y) ? stroke : in_fill(x, y) ? fill : ground;
            page(x, y) = {shake(c.r), shake(c.g), shake(c.b)};
        }
    return page;
}

// Shares of the pixels that are what they should be.
struct Shares {
    double strokes = 0, fills = 0, paper = 0;
};
Shares shares_of(const PageInk& ink) {
    long strokes = 0, stroke_pixels = 0, fills = 0, fill_pixels = 0, paper = 0, paper_pixels = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (on_stroke(x, y))
                ++stroke_pixels, strokes += ink.darkness(x, y) >= 0.5f;
            else if (in_fill(x, y))
                ++fill_pixels, fills += ink.fills(x, y) == 1;
            else
                ++paper_pixels, paper += ink.darkness(x, y) < 0.2f && !ink.fills(x, y);
        }
    const auto share = [](long a, long b) { return static_cast<double>(a) / static_cast<double>(b); };
    return {share(strokes, stroke_pixels), share(fills, fill_pixels), share(paper, paper_pixels)};
}

} // namespace

TEST_CASE("Pale fills are drawn, whatever ground they are on") {
    struct Case {
        const char* name;
        Rgb8 ground, stroke, fill;
        bool light_on_dark;
    };
    const std::vector<Case> cases = {
        {"pale yellow on white", {255, 255, 255}, {30, 30, 30}, {255, 250, 190}, false},
        {"light skin on white", {255, 255, 255}, {90, 60, 40}, {255, 224, 196}, false},
        {"pale blue on cream", {250, 244, 225}, {40, 40, 90}, {205, 225, 245}, false},
        {"red on blue of the same brightness", {90, 120, 200}, {40, 20, 20}, {200, 90, 70}, false},
        {"chalk on a green board", {35, 80, 60}, {235, 235, 225}, {150, 190, 170}, true},
        {"white on black", {12, 12, 14}, {250, 250, 250}, {120, 120, 130}, true},
        {"white and black on kraft", {176, 136, 92}, {25, 20, 15}, {245, 240, 232}, true},
    };
    for (const Case& c : cases)
        for (const int noise : {0, 3}) {
            INFO(c.name << ", noise " << noise);
            const PageInk ink = find_page_ink(page_of(c.ground, c.stroke, c.fill, noise));
            const Shares shares = shares_of(ink);
            CHECK(ink.light_on_dark == c.light_on_dark);
            CHECK(shares.strokes > 0.97);
            CHECK(shares.fills > 0.9); // but for a rim beside a stroke
            CHECK(shares.paper > 0.99);
            CHECK(ink.bare_border > 0.95);
        }
}

TEST_CASE("Light ink alone on a dull ground is ink, on white paper a glare is none") {
    const PageInk kraft = find_page_ink(page_of({170, 130, 90}, {250, 248, 240}, {170, 130, 90}, 2));
    const Shares shares = shares_of(kraft);
    CHECK(shares.strokes > 0.97);
    RgbImage dim = page_of({150, 150, 148}, {40, 40, 40}, {150, 150, 148}, 2);
    for (int y = 20; y < 50; ++y)
        for (int x = 300; x < 340; ++x) dim(x, y) = {175, 175, 173}; // a reflection
    const PageInk glare = find_page_ink(dim);
    CHECK_FALSE(glare.light_on_dark);
    CHECK(shares_of(glare).strokes > 0.97);
    float most = 0;
    for (int y = 24; y < 46; ++y)
        for (int x = 304; x < 336; ++x) most = std::max(most, glare.darkness(x, y));
    CHECK(most < 0.2f);
}

TEST_CASE("Ruled paper and grids of any darkness are paper, and strokes across them stay") {
    for (const int step : {18, 29, 40})
        for (const std::uint8_t level : {235, 180, 90, 20})
            for (const bool squared : {false, true}) {
                INFO("step " << step << ", level " << int{level} << ", squared " << squared);
                const RgbImage plain = page_of({255, 255, 255}, {20, 20, 20}, {255, 255, 255});
                RgbImage ruled = plain;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x)
                        if ((y % step < 2 || (squared && x % step < 2)) && ruled(x, y).r == 255)
                            ruled(x, y) = {level, level, level};
                const Grid<float> with = find_page_ink(ruled).darkness,
                                  without = find_page_ink(plain).darkness;
                int left = 0, lost = 0, strokes = 0;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        strokes += without(x, y) >= 0.5f;
                        left += with(x, y) >= 0.2f && without(x, y) < 0.2f;
                        lost += with(x, y) < 0.5f && without(x, y) >= 0.5f;
                    }
                CHECK(left < 0.01 * width * height);
                CHECK(lost < 0.12 * strokes); // where a line runs along a stroke
            }
}

TEST_CASE("Figures in rows are no ruled paper") {
    RgbImage page(640, 480, Rgb8{255, 255, 255});
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 8; ++column)
            for (int y = 0; y < 12; ++y)
                for (int x = 0; x < 60; ++x) page(12 + 79 * column + x, 60 + 110 * row + y) = {30, 60, 160};
    const Grid<float> darkness = ink_darkness(page);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 8; ++column) CHECK(darkness(40 + 79 * column, 66 + 110 * row) > 0.9f);
}

TEST_CASE("Three fence posts are no ruled paper") {
    RgbImage page(width, height, Rgb8{255, 255, 255});
    for (int y = 60; y < 180; ++y)
        for (const int x : {100, 140, 180})
            for (int k = 0; k < 4; ++k) page(x + k, y) = {0, 0, 0};
    const Grid<float> darkness = ink_darkness(page);
    CHECK(darkness(101, 120) == 1);
    CHECK(darkness(141, 120) == 1);
    CHECK(darkness(181, 120) == 1);
}

TEST_CASE("Of a cut-out everything opaque is drawn, white, too, and its colours tell the strokes") {
    RgbaImage page(60, 40, Rgba8{255, 255, 255, 0});
    for (int y = 5; y < 35; ++y)
        for (int x = 10; x < 50; ++x) page(x, y) = {255, 255, 255, 255};
    for (int x = 10; x < 50; ++x) page(x, 20) = {10, 10, 10, 255};
    page(0, 0) = {0, 0, 0, 100}; // more transparent than not
    const PageInk ink = find_cut_out_ink(page);
    CHECK(ink.cut_out);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) {
            const bool inside = x >= 10 && x < 50 && y >= 5 && y < 35;
            REQUIRE(ink.fills(x, y) == inside);
            REQUIRE((ink.darkness(x, y) > 0) == inside);
        }
    CHECK(ink.darkness(20, 20) > 2 * ink.darkness(20, 10));
}

TEST_CASE("A character's ink is as dark as it gets, and comes back from its picture") {
    Grid<float> darkness(20, 20, 0.0f);
    for (int x = 0; x < 20; ++x) darkness(x, 10) = 0.5f;
    const GreyImage ink = ink_of_crop(darkness);
    CHECK(ink(3, 10) == 255);
    CHECK(ink(3, 11) == 0);
    CHECK(darkness_of(ink)(3, 10) == 1);
}
