// SPDX-License-Identifier: MIT
// Random numbers: the published sequence, ranges, moments, independent streams.
#include "core/random.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using pantin::Random;

TEST_CASE("xoshiro256** seeded by SplitMix64 gives the published sequence") {
    // First outputs of the reference code of Blackman and Vigna, its state filled by SplitMix64 from 42.
    Random random(42);
    CHECK(random.next() == 1546998764402558742u);
    CHECK(random.next() == 6990951692964543102u);
    CHECK(random.next() == 12544586762248559009u);
}

TEST_CASE("two generators of one seed agree and streams of one seed differ") {
    Random a(7), b(7);
    for (int i = 0; i < 100; ++i) REQUIRE(a.next() == b.next());
    CHECK(Random::stream(7, 0).next() != Random::stream(7, 1).next());
    CHECK(Random::stream(7, 1).next() == Random::stream(7, 1).next());
    CHECK(Random::stream(7, 1).next() != Random::stream(8, 1).next());
}

TEST_CASE("uniform numbers stay in their range and fill it") {
    Random random(1);
    double sum = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double value = random.uniform(-2.0, 3.0);
        REQUIRE(value >= -2.0);
        REQUIRE(value < 3.0);
        sum += value;
    }
    CHECK(sum / 20000 == Approx(0.5).margin(0.05));
    CHECK(random.uniform(4.0, 4.0) == 4.0);
}

TEST_CASE("integers cover both ends of their range evenly") {
    Random random(2);
    std::vector<int> counts(7, 0);
    for (int i = 0; i < 14000; ++i) ++counts[static_cast<std::size_t>(random.integer(-3, 3) + 3)];
    for (int count : counts) CHECK(count == Approx(2000).margin(200));
    CHECK(random.integer(5, 5) == 5);
    int negative = 0;
    for (int i = 0; i < 1000; ++i) negative += random.integer(-2147483647 - 1, 2147483647) < 0;
    CHECK(negative == Approx(500).margin(80)); // the whole range of int does not overflow
}

TEST_CASE("normal numbers have mean 0, variance 1 and tails") {
    Random random(3);
    double sum = 0.0, squares = 0.0;
    int beyond_two = 0;
    const int count = 40000;
    for (int i = 0; i < count; ++i) {
        const double value = random.normal();
        sum += value;
        squares += value * value;
        beyond_two += std::abs(value) > 2.0;
    }
    CHECK(sum / count == Approx(0.0).margin(0.02));
    CHECK(squares / count == Approx(1.0).margin(0.03));
    CHECK(static_cast<double>(beyond_two) / count == Approx(0.0455).margin(0.005));
}

TEST_CASE("weighted choice follows its weights and never takes a zero") {
    Random random(4);
    std::vector<int> counts(4, 0);
    for (int i = 0; i < 10000; ++i) ++counts[random.weighted({1.0, 0.0, 3.0, 0.0})];
    CHECK(counts[0] == Approx(2500).margin(200));
    CHECK(counts[1] == 0);
    CHECK(counts[2] == Approx(7500).margin(200));
    CHECK(counts[3] == 0);
}

TEST_CASE("a shuffle is a permutation that depends on the seed alone") {
    std::vector<int> items = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, again = items;
    Random a(9), b(9);
    a.shuffle(items);
    b.shuffle(again);
    CHECK(items == again);
    std::vector<int> seen(10, 0);
    for (int item : items) ++seen[static_cast<std::size_t>(item)];
    CHECK(seen == std::vector<int>(10, 1));
}
