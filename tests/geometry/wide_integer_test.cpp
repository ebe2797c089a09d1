// SPDX-License-Identifier: MIT
// The integers of 128 bits for processors that have none, against the compiler's.
#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "geometry/wide_integer.hpp"

#ifdef __SIZEOF_INT128__

namespace pantin {
namespace {

// Of every size, of both signs.
std::int64_t random_word(Random& random) {
    const auto bits = static_cast<std::uint64_t>(random.integer(0, 0x7fffffff)) << 32 |
                      static_cast<std::uint64_t>(random.integer(0, 0x7fffffff)) << 1;
    const auto value = static_cast<std::int64_t>(bits >> random.integer(1, 63));
    return random.chance(0.5) ? -value : value;
}

bool same(TwoWordInteger ours, __int128 theirs) {
    return ours == TwoWordInteger(static_cast<std::int64_t>(theirs >> 64)) *
                           TwoWordInteger(std::int64_t{1} << 32) * TwoWordInteger(std::int64_t{1} << 32) +
                       TwoWordInteger(static_cast<std::int64_t>(theirs >> 1 & 0x7fffffffffffffff)) *
                           TwoWordInteger(2) +
                       TwoWordInteger(static_cast<std::int64_t>(theirs & 1));
}

} // namespace

TEST_CASE("Integers of two words compute what the compiler's of 128 bits compute") {
    Random random(21);
    for (int round = 0; round < 20000; ++round) {
        const std::int64_t a = random_word(random), b = random_word(random), c = random_word(random),
                           d = random_word(random);
        const __int128 wide = static_cast<__int128>(a) * b + c,
                       other = static_cast<__int128>(d) * (c / 2) - a;
        const TwoWordInteger ours = TwoWordInteger(a) * TwoWordInteger(b) + TwoWordInteger(c);
        const TwoWordInteger ours_too = TwoWordInteger(d) * TwoWordInteger(c / 2) - TwoWordInteger(a);
        REQUIRE(same(ours, wide));
        REQUIRE(same(ours_too, other));
        CHECK(same(-ours, -wide));
        CHECK((ours < ours_too) == (wide < other));
        CHECK((ours == ours_too) == (wide == other));
        CHECK(static_cast<double>(ours) == static_cast<double>(wide));
        if (other != 0) {
            CHECK(same(ours / ours_too, wide / other));
            CHECK(same(ours % ours_too, wide % other));
        }
    }
}

TEST_CASE("Integers of two words become the nearest double, ties to even") {
    const auto power = [](int n) {
        TwoWordInteger value = 1;
        for (int i = 0; i < n; ++i) value = value + value;
        return value;
    };
    for (const int shift : {0, 11, 12, 47, 60}) {
        __int128 theirs = (static_cast<__int128>(1) << (53 + shift)) * 2;
        TwoWordInteger ours = power(54 + shift);
        for (const int extra : {0, 1, 2, 3, 5, 6, 7}) { // of quarters of the last place, and one more
            const __int128 plus = (static_cast<__int128>(1) << shift) * extra;
            const TwoWordInteger ours_plus = power(shift) * TwoWordInteger(extra);
            for (const int one : {-1, 0, 1})
                CHECK(static_cast<double>(ours + ours_plus + TwoWordInteger(one)) ==
                      static_cast<double>(theirs + plus + one));
        }
    }
}

} // namespace pantin

#endif
