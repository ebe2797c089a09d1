// SPDX-License-Identifier: MIT
// The inner loop that convolution, transposed convolution and linear layers share, compiled once per
// instruction set (kernel_*.cpp) and chosen at run time.
#pragma once

#include <cstddef>

#include "network/fused.hpp"
#include "network/vector_width.hpp"

namespace pantin::network {

// At most this many output channels are computed at once: rows × vectors accumulators stay in registers.
inline constexpr int max_rows = 6;

// Chains of `rows` output channels at `vectors` places:
//     acc[r][v][lane] = bias[r];
//     for (c) for (t)  acc[r][v][lane] = fma(weights[c][t][r], input[c·plane + taps[t] + bases[v] + lane],
//     acc)
// The result is written to out[r·out_stride + v·width + lane]. Without a bias the chains start with what
// `out` holds. With `relu`, results that are not above zero become +0.
struct KernelTask {
    const float* input;
    std::size_t plane;          // floats from one input channel to the next
    int channels;               // input channels of the chain
    const std::ptrdiff_t* taps; // [tap_count] offsets of the kernel's taps
    int tap_count;
    const float* weights;        // [channels][tap_count][rows]
    const float* bias;           // [rows] or null
    int rows;                    // 1 … max_rows
    const std::ptrdiff_t* bases; // [vectors] offset of the first lane
    int vectors;
    float* out; // [rows][out_stride]
    std::size_t out_stride;
    bool relu;
};

struct Kernel {
    int width; // lanes of a vector
    void (*run)(const KernelTask&);
};

// One per kernel_*.cpp; width 0 where the compiler's target has no such instructions.
extern const Kernel kernel_baseline, kernel_avx2, kernel_avx512, kernel_neon;

} // namespace pantin::network
