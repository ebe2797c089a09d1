// SPDX-License-Identifier: MIT
// Holes that are filled with the colours around them.
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "pantin/image.hpp"

using namespace pantin;

namespace {

RgbImage shaded(int width, int height) {
    RgbImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image(x, y) = {static_cast<std::uint8_t>(100 + x), static_cast<std::uint8_t>(220 - y), 90};
    return image;
}

} // namespace

TEST_CASE("A filled hole continues a slope of colour; other pixels stay", "[image]") {
    const RgbImage image = shaded(61, 47);
    RgbImage damaged = image;
    Mask hole(61, 47);
    for (int y = 12; y < 34; ++y)
        for (int x = 20; x < 45; ++x) {
            hole(x, y) = 1;
            damaged(x, y) = {0, 0, 0};
        }
    const RgbImage filled = fill_in(damaged, hole);
    for (int y = 0; y < 47; ++y)
        for (int x = 0; x < 61; ++x) {
            if (!hole(x, y)) CHECK(filled(x, y) == image(x, y));
            CHECK(std::abs(filled(x, y).r - image(x, y).r) <= 6);
            CHECK(std::abs(filled(x, y).g - image(x, y).g) <= 6);
            CHECK(filled(x, y).b == 90);
        }
}

TEST_CASE("A filled hole keeps within the colours around it, whatever its shape", "[image]") {
    std::mt19937 random{3};
    for (int round = 0; round < 20; ++round) {
        const int width = 1 + static_cast<int>(random() % 40), height = 1 + static_cast<int>(random() % 40);
        RgbImage image(width, height);
        Mask hole(width, height);
        for (std::size_t i = 0; i < image.size(); ++i) {
            const auto grey = static_cast<std::uint8_t>(60 + random() % 100);
            hole.data()[i] = random() % 3 == 0;
            image.data()[i] = hole.data()[i] ? Rgb8{255, 0, 0} : Rgb8{grey, grey, grey};
        }
        if (std::count(hole.begin(), hole.end(), 0) == 0) continue;
        const RgbImage filled = fill_in(image, hole);
        for (const Rgb8& p : filled) {
            CHECK(p.r >= 59);
            CHECK(p.r <= 160);
            CHECK(p.r == p.g);
        }
    }
}

TEST_CASE("A picture that is all hole turns black and nothing else happens", "[image]") {
    const RgbImage filled = fill_in(shaded(5, 4), Mask(5, 4, 1));
    for (const Rgb8& p : filled) CHECK(p == Rgb8{0, 0, 0});
}
