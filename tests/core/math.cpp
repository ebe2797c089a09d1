// SPDX-License-Identifier: MIT
// Elementary functions against those of long double: below one ulp; exact and special values.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A small generator of its own, so that this test depends on nothing but the functions under test.
struct Lcg {
    std::uint64_t state;
    double uniform(double a, double b) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return a + (b - a) * (static_cast<double>(state >> 11) * 0x1p-53);
    }
};

// Distance to the long double result in units of its last place as a double.
double ulps(double value, long double expected) {
    const double nearest = static_cast<double>(expected);
    const double ulp = std::nextafter(std::fabs(nearest), infinity) - std::fabs(nearest);
    return static_cast<double>(std::fabs(static_cast<long double>(value) - expected) / ulp);
}

} // namespace

TEST_CASE("exp, log, sin, cos, atan2 and pow stay below one ulp of the long double functions") {
    Lcg random{1};
    double e = 0, l = 0, s = 0, c = 0, a = 0, p = 0;
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(-700, 700), y = random.uniform(-10, 10),
                     z = random.uniform(-1e6, 1e6);
        e = std::fmax(e, ulps(pantin::math::exp(x), std::exp(static_cast<long double>(x))));
        const double positive = std::fabs(i % 2 ? x : y / 9.9) + 1e-300;
        l = std::fmax(l, ulps(pantin::math::log(positive), std::log(static_cast<long double>(positive))));
        const double angle = i % 3 ? y : z;
        s = std::fmax(s, ulps(pantin::math::sin(angle), std::sin(static_cast<long double>(angle))));
        c = std::fmax(c, ulps(pantin::math::cos(angle), std::cos(static_cast<long double>(angle))));
        a = std::fmax(
            a, ulps(pantin::math::atan2(y, i % 2 ? x : y * 1.3),
                    std::atan2(static_cast<long double>(y), static_cast<long double>(i % 2 ? x : y * 1.3))));
        const double base = std::fabs(x) + 1e-3;
        p = std::fmax(p, ulps(pantin::math::pow(base, y * 3),
                              std::pow(static_cast<long double>(base), static_cast<long double>(y * 3))));
    }
    CHECK(e < 1.0);
    CHECK(l < 1.0);
    CHECK(s < 1.0);
    CHECK(c < 1.0);
    CHECK(a < 1.5); // the quotient of atan2's arguments is rounded once more
    CHECK(p < 1.0);
}

TEST_CASE("multiples of pi/2 are reduced without losing the result") {
    for (int k = -2000; k <= 2000; ++k) {
        const double x = k * (pantin::math::pi / 2);
        CHECK(ulps(pantin::math::sin(x), std::sin(static_cast<long double>(x))) < 1.0);
        CHECK(ulps(pantin::math::cos(x), std::cos(static_cast<long double>(x))) < 1.0);
    }
}

TEST_CASE("exact values of the elementary functions are exact") {
    CHECK(pantin::math::exp(0) == 1);
    CHECK(pantin::math::log(1) == 0);
    CHECK(pantin::math::sin(0) == 0);
    CHECK(pantin::math::cos(0) == 1);
    CHECK(pantin::math::atan2(0, 1) == 0);
    CHECK(pantin::math::atan2(1, 1) == pantin::math::pi / 4);
    CHECK(pantin::math::atan2(0, -1) == pantin::math::pi);
    CHECK(pantin::math::atan2(-1, 0) == -pantin::math::pi / 2);
    CHECK(pantin::math::pow(2, 10) == 1024);
    CHECK(pantin::math::pow(-3, 3) == -27);
    CHECK(pantin::math::pow(4, 0.5) == 2);
    CHECK(pantin::math::pow(10, -2) == 0.01);
}

TEST_CASE("special values follow the C standard") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double values[] = {0.0, -0.0, 1,        -1,        2,   -2,    0.5,    -0.5,
                             3,   -3,   infinity, -infinity, nan, 1e300, -1e300, 1e-320};
    const auto same = [](double a, double b) {
        return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
    };
    for (double x : values) {
        if (x == 0 || !std::isfinite(x) || std::fabs(x) > 1e3) CHECK(same(pantin::math::exp(x), std::exp(x)));
        if (x <= 0 || !std::isfinite(x)) CHECK(same(pantin::math::log(x), std::log(x)));
        for (double y : values) {
            CAPTURE(x, y);
            const double ours = pantin::math::pow(x, y), theirs = std::pow(x, y);
            CHECK((same(ours, theirs) || std::fabs(ours - theirs) <= std::fabs(theirs) * 3e-16));
            const double angle = pantin::math::atan2(x, y), their_angle = std::atan2(x, y);
            CHECK((same(angle, their_angle) ||
                   std::fabs(angle - their_angle) <= std::fabs(their_angle) * 3e-16));
        }
    }
    CHECK(pantin::math::exp(800) == infinity);
    CHECK(pantin::math::exp(-800) == 0);
    CHECK(pantin::math::exp(-745) == std::exp(-745.0));
    CHECK(std::isnan(pantin::math::sin(infinity)));
    CHECK(std::isnan(pantin::math::cos(nan)));
}
