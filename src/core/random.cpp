// SPDX-License-Identifier: MIT
// A seed in, pseudo-random numbers out: xoshiro256** and SplitMix64 (Blackman & Vigna 2021), distributions of
// our own.
#include "core/random.hpp"

#include <bit>
#include <cassert>
#include <cmath>

#include "core/math.hpp"

namespace pantin {
namespace {

// SplitMix64: advances `state` and returns the next value.
std::uint64_t split_mix(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

} // namespace

Random::Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) word = split_mix(seed);
}

Random Random::stream(std::uint64_t seed, std::uint64_t stream) {
    const std::uint64_t mixed_seed = split_mix(seed);
    return Random(mixed_seed ^ split_mix(stream));
}

std::uint64_t Random::next() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
}

double Random::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

double Random::uniform(double low, double high) {
    const double value = low + (high - low) * uniform();
    return value < high || low == high ? value : low; // rounding may reach high
}

int Random::integer(int low, int high) {
    assert(low <= high);
    const std::uint64_t range = static_cast<std::uint64_t>(std::int64_t{high} - low) + 1;
    const std::uint64_t rejected = (0 - range) % range; // 2⁶⁴ mod range
    std::uint64_t bits = next();
    while (bits < rejected) bits = next();
    return static_cast<int>(low + static_cast<std::int64_t>(bits % range));
}

double Random::normal() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_normal_;
    }
    for (;;) {
        const double u = uniform(-1.0, 1.0);
        const double v = uniform(-1.0, 1.0);
        const double s = u * u + v * v;
        if (s >= 1.0 || s == 0.0) continue;
        const double scale = std::sqrt(-2.0 * math::log(s) / s);
        spare_normal_ = v * scale;
        has_spare_ = true;
        return u * scale;
    }
}

bool Random::chance(double p) { return uniform() < p; }

std::size_t Random::weighted(const std::vector<double>& weights) {
    double sum = 0.0;
    for (double weight : weights) sum += weight;
    assert(sum > 0.0);
    double rest = sum * uniform();
    std::size_t last = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] <= 0.0) continue;
        last = i;
        rest -= weights[i];
        if (rest < 0.0) return i;
    }
    return last; // rounding left a crumb
}

} // namespace pantin
