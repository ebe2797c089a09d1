// SPDX-License-Identifier: MIT
// The emulated fused multiply-add against the C library's.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "network/fused.hpp"

namespace pantin::network {
namespace {

bool same(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

} // namespace

TEST_CASE("The emulated fused multiply-add equals the C library's on any bits") {
    Random random(1);
    long different = 0;
    for (int i = 0; i < 2'000'000; ++i) {
        const std::uint64_t bits = random.next(), more = random.next();
        const float a = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        const float b = std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32));
        float c = std::bit_cast<float>(static_cast<std::uint32_t>(more));
        // Half of the time an addend near the product, so that digits cancel or just stick out.
        if (more >> 63 && std::isfinite(a * b)) {
            const double factor = random.uniform(-2, 2);
            c = a * b * static_cast<float>(std::ldexp(factor, random.integer(-30, 30)));
        }
        different += !same(fused_emulated(a, b, c), std::fma(a, b, c));
    }
    CHECK(different == 0);
}

TEST_CASE("The emulated fused multiply-add is right where double rounding would be wrong") {
    const float tiny = std::numeric_limits<float>::denorm_min(), least = std::numeric_limits<float>::min();
    const float edges[] = {0.0f,
                           -0.0f,
                           1.0f,
                           -1.0f,
                           1.0f + 0x1p-23f,
                           1.0f - 0x1p-24f,
                           0x1p-24f,
                           -0x1p-24f,
                           tiny,
                           -tiny,
                           least,
                           -least,
                           least - tiny,
                           0x1p-75f,
                           0x1p-76f,
                           0x1.8p-75f,
                           0x1p127f,
                           std::numeric_limits<float>::max(),
                           -std::numeric_limits<float>::max(),
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN(),
                           3.0f,
                           0x1.000002p-64f,
                           0x1.fffffep-70f};
    for (const float a : edges)
        for (const float b : edges)
            for (const float c : edges) {
                INFO(a << " · " << b << " + " << c);
                CHECK(same(fused_emulated(a, b, c), std::fma(a, b, c)));
            }
    // 1 + 2^-24 + 2^-54: the sum in double drops the last term and then ties to even, downwards.
    const float a = 1 + 0x1p-12f, b = 0x1p-24f;
    CHECK(same(fused_emulated(a, b, 1.0f), std::fma(a, b, 1.0f)));
    const float p = 0x1.000002p-27f, q = 0x1.000002p-27f;
    CHECK(same(fused_emulated(p, q, 1 + 0x1p-23f), std::fma(p, q, 1 + 0x1p-23f)));
}

} // namespace pantin::network
