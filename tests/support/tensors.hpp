// SPDX-License-Identifier: MIT
// Tensors for the tests: random ones, the same on every machine, and their comparison.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/random.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

inline std::vector<float> random_floats(Random& random, std::size_t count) {
    std::vector<float> values(count);
    for (float& value : values) value = static_cast<float>(random.uniform(-1, 1));
    return values;
}

inline Tensor random_tensor(Random& random, int batch, int channels, int height, int width) {
    Tensor tensor(batch, channels, height, width);
    for (float& value : tensor) value = random.chance(0.1) ? 0.0f : static_cast<float>(random.uniform(-1, 1));
    return tensor;
}

// Equal to the bit: NaN equals the same NaN, +0 does not equal −0. Empty tensors (no data) compare by shape.
inline bool same_bits(const Tensor& a, const Tensor& b) {
    return a.same_shape(b) && std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
               return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
           });
}

// Relative, but of values below 0.01 the hundredfold absolute difference; infinite for different shapes.
inline double largest_difference(const Tensor& a, const Tensor& b) {
    if (!a.same_shape(b)) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = a.data()[i], y = b.data()[i];
        largest = std::max(largest, std::abs(x - y) / std::max(0.01, std::abs(y)));
    }
    return largest;
}

// `weights` per filter pair: out·in/groups·height·width in all, in either layout.
inline Filters random_filters(Random& random, int out, int in, int height, int width, int groups) {
    Filters filters;
    filters.out = out;
    filters.in = in;
    filters.height = height;
    filters.width = width;
    filters.weights = random_floats(random, static_cast<std::size_t>(out) * in / groups * height * width);
    filters.bias = random_floats(random, static_cast<std::size_t>(out));
    return filters;
}

} // namespace pantin::network
