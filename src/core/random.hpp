// SPDX-License-Identifier: MIT
// Pseudo-random numbers that are the same on every compiler and machine: a generator and distributions of our
// own, because the results of std::*_distribution and std::shuffle are left to each standard library.
//
// Generator: xoshiro256** 1.0, its state filled by SplitMix64 (Blackman & Vigna 2021, "Scrambled linear
// pseudorandom number generators"; reference code in the public domain).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pantin {

class Random {
public:
    explicit Random(std::uint64_t seed);

    // A generator for part `stream` of the work with `seed`: independent of how much the other streams draw.
    static Random stream(std::uint64_t seed, std::uint64_t stream);

    // 64 uniform bits.
    std::uint64_t next();
    // Uniform in [0, 1): a multiple of 2⁻⁵³.
    double uniform();
    // Uniform in [low, high), or low where the two are equal.
    double uniform(double low, double high);
    // Uniform in low…high, both included, without bias (rejection). Needs low ≤ high.
    int integer(int low, int high);
    // Standard normal (Marsaglia's polar method with the portable logarithm).
    double normal();
    // True with probability p.
    bool chance(double p);
    // Index drawn with probability proportional to weights[index] ≥ 0; needs a positive sum.
    std::size_t weighted(const std::vector<double>& weights);

    template <class T> const T& pick(const std::vector<T>& items) {
        return items[static_cast<std::size_t>(integer(0, static_cast<int>(items.size()) - 1))];
    }
    // Fisher–Yates, from the back.
    template <class T> void shuffle(std::vector<T>& items) {
        for (std::size_t i = items.size(); i > 1; --i)
            std::swap(items[i - 1], items[static_cast<std::size_t>(integer(0, static_cast<int>(i) - 1))]);
    }

private:
    std::array<std::uint64_t, 4> state_;
    double spare_normal_ = 0.0;
    bool has_spare_ = false;
};

} // namespace pantin
