// SPDX-License-Identifier: MIT
// Ink and darkness of pictures with shadows, tints and filled areas.
#include <catch2/catch.hpp>

#include <random>

#include "pantin/image.hpp"

using namespace pantin;

namespace {

// Darkness of a page: ink lines every 40 px, too short for ruled ones, and a filled rectangle, under
// `light(x, y)` in [0, 1].
template <class Light> RgbImage photographed(int width, int height, Rgb8 paper, Light light) {
    std::mt19937 random{11};
    RgbImage page(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool ink = (x % 40 < 3 && y > 50 && y < height - 50) ||
                             (x > width / 3 && x < width / 2 && y > height / 3 && y < height * 2 / 3);
            const double reflected = (ink ? 0.2 : 1.0) * light(x, y);
            const int noise = static_cast<int>(random() % 5) - 2;
            const auto shade = [&](int v) {
                return static_cast<std::uint8_t>(std::clamp(static_cast<int>(v * reflected) + noise, 0, 255));
            };
            page(x, y) = {shade(paper.r), shade(paper.g), shade(paper.b)};
        }
    }
    return page;
}

} // namespace

TEST_CASE("Greyscale has integer weights") {
    RgbImage image(3, 1);
    image(0, 0) = {255, 255, 255};
    image(1, 0) = {255, 0, 0};
    image(2, 0) = {10, 20, 30};
    const GreyImage grey = greyscale(image);
    CHECK(grey(0, 0) == 255);
    CHECK(grey(1, 0) == 76);
    CHECK(grey(2, 0) == 18); // 2.99 + 11.74 + 3.42 = 18.15
}

TEST_CASE("The adaptive threshold equals its definition") {
    std::mt19937 random{5};
    GreyImage image(17, 13);
    for (auto& v : image) v = static_cast<std::uint8_t>(random() % 256);
    for (int radius : {0, 1, 3, 30}) {
        const Mask ink = adaptive_threshold(image, radius, 7);
        bool same = true;
        for (int y = 0; y < 13; ++y) {
            for (int x = 0; x < 17; ++x) {
                double sum = 0;
                int count = 0;
                for (int v = std::max(0, y - radius); v <= std::min(12, y + radius); ++v)
                    for (int u = std::max(0, x - radius); u <= std::min(16, x + radius); ++u, ++count)
                        sum += image(u, v);
                same = same && ink(x, y) == (image(x, y) < sum / count - 7);
            }
        }
        CHECK(same);
    }
}

TEST_CASE("A digital drawing's ink is 1 and its paper 0") {
    RgbImage page(200, 150, Rgb8{255, 255, 255});
    for (int y = 20; y < 120; ++y)
        for (int x = 30; x < 170; ++x)
            if (x < 34 || y < 24 || (x > 60 && x < 160 && y > 40 && y < 110)) page(x, y) = {0, 0, 0};
    const Grid<float> darkness = ink_darkness(page);
    bool exact = true;
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x) exact = exact && darkness(x, y) == (page(x, y).r == 0 ? 1.0f : 0.0f);
    CHECK(exact);
}

TEST_CASE("Shadow gradients and yellow paper are no ink, filled areas are") {
    const auto gradient = [](int x, int y) { return 1.0 - 0.3 * x / 480 - 0.15 * y / 360; };
    const auto vignette = [](int x, int y) {
        const double u = (x - 240) / 300.0, v = (y - 180) / 300.0;
        return 1.0 - 0.35 * (u * u + v * v);
    };
    const std::vector<RgbImage> pages = {photographed(480, 360, {240, 225, 150}, gradient),
                                         photographed(480, 360, {250, 250, 250}, vignette)};
    for (const RgbImage& page : pages) {
        const Grid<float> darkness = ink_darkness(page);
        int paper_as_ink = 0, ink_as_paper = 0, ink_count = 0;
        for (int y = 0; y < 360; ++y) {
            for (int x = 0; x < 480; ++x) {
                const bool ink =
                    (x % 40 < 3 && y > 50 && y < 310) || (x > 160 && x < 240 && y > 120 && y < 240);
                ink_count += ink;
                if (ink)
                    ink_as_paper += darkness(x, y) < 0.6f;
                else
                    paper_as_ink += darkness(x, y) > 0.3f;
            }
        }
        CHECK(paper_as_ink < 0.002 * 480 * 360);
        CHECK(ink_as_paper < 0.01 * ink_count);
    }
}

TEST_CASE("A filled body that covers most of its crop stays ink") {
    RgbImage crop_of_body(300, 200, Rgb8{250, 240, 230});
    for (int y = 8; y < 192; ++y)
        for (int x = 8; x < 292; ++x) crop_of_body(x, y) = {180, 40, 60};
    const Grid<float> darkness = ink_darkness(crop_of_body);
    CHECK(darkness(150, 100) > 0.9f);
    CHECK(darkness(20, 20) > 0.9f);
    CHECK(darkness(2, 2) < 0.05f);
}

TEST_CASE("Blank pages have no ink, whatever their colour") {
    for (float d : ink_darkness(RgbImage(64, 48, Rgb8{230, 220, 200}))) REQUIRE(d == 0.0f);
    for (float d : ink_darkness(RgbImage(64, 48, Rgb8{0, 0, 0}))) REQUIRE(d == 0.0f);
    CHECK(ink_darkness(RgbImage()).empty());
}
