// SPDX-License-Identifier: MIT
// What convolution and transposed convolution share: filters packed for the kernel, and one pass of the
// kernel over a padded image.
#pragma once

#include <cstddef>
#include <vector>

#include "network/pass.hpp"

namespace pantin::network {

// The rows (output channels) of a block share the loads of the input.
struct FilterBlock {
    int group = 0, first = 0, rows = 0; // output channels first … first + rows − 1
    std::size_t begin = 0;              // in PackedFilters::weights, [in / groups][tap][rows]
};
struct PackedFilters {
    int in_per_group = 0, taps = 0;
    std::vector<FilterBlock> blocks;
    std::vector<float> weights;
};
// Blocks of nearly equal height, without weights.
PackedFilters block_layout(int out, int in_per_group, int groups, int taps);
// weight(o, i, t): of output channel o, input channel i of its group, tap t.
template <class Weight> PackedFilters pack(int out, int in_per_group, int groups, int taps, Weight weight) {
    PackedFilters packed = block_layout(out, in_per_group, groups, taps);
    packed.weights.reserve(static_cast<std::size_t>(out) * in_per_group * taps);
    for (FilterBlock& block : packed.blocks) {
        block.begin = packed.weights.size();
        for (int i = 0; i < in_per_group; ++i)
            for (int t = 0; t < taps; ++t)
                for (int r = 0; r < block.rows; ++r) packed.weights.push_back(weight(block.first + r, i, t));
    }
    return packed;
}

void run_pass(const Tensor& input, int n, const PackedFilters& filters, const std::vector<float>& bias,
              const Pass& pass, const Runtime& runtime, Tensor& output);

} // namespace pantin::network
