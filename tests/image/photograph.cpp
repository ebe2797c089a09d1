// SPDX-License-Identifier: MIT
// What is a photograph: light that falls off over the paper, whatever is drawn and however grainy it is.
#include <catch2/catch.hpp>

#include <cmath>

#include "core/random.hpp"
#include "pantin/image.hpp"

using namespace pantin;

namespace {

// A figure of lines and a dark area on paper of that brightness under `light(x, y)`, with noise of so many
// grey levels to either side.
template <class Light> RgbImage drawn(int noise, Light light, double paper = 240) {
    Random random(5);
    RgbImage page(320, 240);
    for (int y = 0; y < page.height(); ++y)
        for (int x = 0; x < page.width(); ++x) {
            const bool ink = std::abs(std::hypot(x - 160.0, y - 120.0) - 70) < 2 || std::abs(x - 160) < 2 ||
                             (x > 140 && x < 180 && y > 90 && y < 150);
            const double value =
                (ink ? 30 : paper) * light(x, y) + (noise ? random.integer(-noise, noise) : 0);
            const auto level = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
            page(x, y) = {level, level, level};
        }
    return page;
}

double even(int, int) { return 1; }

} // namespace

TEST_CASE("Light that falls off makes a photograph, grain and a filled area do not", "[image]") {
    CHECK_FALSE(is_photograph(drawn(0, even)));
    CHECK_FALSE(is_photograph(drawn(6, even)));      // a scan
    CHECK_FALSE(is_photograph(drawn(3, even, 150))); // on grey paper
    const auto from_the_left = [](int x, int) { return 1 - 0.25 * x / 320; };
    const auto spot = [](int x, int y) { return 1 - 0.3 * std::hypot(x - 100.0, y - 60.0) / 270; };
    for (const int noise : {0, 3, 6}) {
        CHECK(is_photograph(drawn(noise, from_the_left)));
        CHECK(is_photograph(drawn(noise, spot)));
    }
    RgbImage board = drawn(2, from_the_left);
    for (Rgb8& p : board) p = {static_cast<std::uint8_t>(255 - p.r), p.g, p.b}, p.g = p.b = p.r;
    (void)is_photograph(board); // chalk on a board: no crash, whatever it is
    CHECK_FALSE(is_photograph(RgbImage()));
}

TEST_CASE("The fall of the light and the grain are measured on the bare paper", "[image]") {
    const PaperLight flat = paper_light(drawn(0, even));
    CHECK(flat.fall == 0);
    CHECK(flat.grain == 0);
    const PaperLight lit = paper_light(drawn(0, [](int x, int) { return 1 - 0.2 * x / 320; }));
    CHECK(lit.fall == Approx(0.18).margin(0.02)); // between the 5th and the 95th percentile
    // Two neighbours, each uniform in -n … n, differ by (2n+1 - 1/(2n+1))/3 on average.
    CHECK(paper_light(drawn(4, even)).grain == Approx((9 - 1.0 / 9) / 3).margin(0.15));
}
