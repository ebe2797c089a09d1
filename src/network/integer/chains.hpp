// SPDX-License-Identifier: MIT
// One pass of the integer kernel over an image (pass.hpp says how a pass goes).
#pragma once

#include "network/integer/layers.hpp"
#include "network/pass.hpp"

namespace pantin::network::integer {

// weight(o, c, t): of output channel o, input channel c, tap t. The channels of the last words that are none
// have weights of 0.
template <class Weight> PackedFilters pack(int out, int in, int taps, Weight weight) {
    PackedFilters packed{out, (in + 3) / 4, taps, {}};
    for (int first = 0; first < out; first += 4)
        for (int w = 0; w < packed.words; ++w)
            for (int t = 0; t < taps; ++t)
                for (int o = first; o < first + 4; ++o) {
                    std::uint32_t word = 0;
                    for (int k = 0; k < 4; ++k)
                        if (o < out && 4 * w + k < in)
                            word |=
                                static_cast<std::uint32_t>(static_cast<std::uint8_t>(weight(o, 4 * w + k, t)))
                                << (8 * k);
                    packed.weights.push_back(word);
                }
    return packed;
}

// The rescaling with entries for whole blocks of four output channels.
Rescaling padded(Rescaling rescaling);

// Results are bytes, with `added` where it is not null, or real numbers.
struct Target {
    ByteTensor* bytes = nullptr;
    const ByteTensor* added = nullptr;
    Tensor* real = nullptr;
};
// `words`: the input, with words().channels() = filters.words. zero: padding. n: batch entry of input and
// result.
void run_pass(const BasicTensor<std::uint32_t>& words, int n, const PackedFilters& filters,
              const Rescaling& rescaling, std::uint8_t zero, const Pass& pass, const Runtime& runtime,
              const Target& target);

} // namespace pantin::network::integer
