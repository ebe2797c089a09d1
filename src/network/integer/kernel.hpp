// SPDX-License-Identifier: MIT
// The two inner loops of the integer networks: sums of products of bytes, and what makes bytes of the sums.
// Compiled once per instruction set (kernel_*.cpp) and chosen at run time. Sums of integers are the same in
// any order, so all instruction sets give the same bits whatever their order of work.
#pragma once

#include <cstddef>
#include <cstdint>

#include "network/vector_width.hpp"

namespace pantin::network::integer {

// Output channels that are computed at once: their bytes are one word of the result.
inline constexpr int rows = 4;

// Sums of four output channels at `vectors` places:
//     sum[r][v][lane] = Σ_(w, t) dot(weights[w][t][r], input[w·plane + taps[t] + bases[v] + lane])
// where dot is the product of four unsigned bytes of the input with four signed ones of the weights, and sum
// goes to out[r·out_stride + v·width + lane]. The weights lie in −63 … 63: sums of two products fit 16 bits.
struct SumTask {
    const std::uint32_t* input;
    std::size_t plane;          // words from one group of four input channels to the next
    int words;                  // groups of four input channels
    const std::ptrdiff_t* taps; // [tap_count] offsets of the kernel's taps
    int tap_count;
    const std::uint32_t* weights; // [words][tap_count][rows], four signed bytes each
    const std::ptrdiff_t* bases;  // [vectors] offset of the first lane
    int vectors;
    std::int32_t* out; // [rows][out_stride]
    std::size_t out_stride;
};

// Bytes of the sums (tools/train/quantize.py; Jacob et al. 2018, 2.2):
//     byte r of out[i] = clamp((sums[r·sum_stride + i]·multiplier[r] + residual·q + offset[r]) >> shift, 0,
//     255)
// with q = byte r of added[i], or 0 where `added` is null. 1 ≤ shift ≤ 62; what is shifted lies between −2⁶²
// and 2⁶², the shifted number fits 32 bits (fault_of in layers.hpp proves both for a layer).
struct ByteTask {
    const std::int32_t* sums; // [rows][sum_stride]
    std::size_t sum_stride;
    const std::int32_t* multiplier; // [rows], not negative
    const std::int64_t* offset;     // [rows]
    int shift;
    std::int32_t residual;      // not negative
    const std::uint32_t* added; // [count] or null
    int count;                  // a multiple of the kernel's width
    std::uint32_t* out;         // [count]
};

struct Kernel {
    int width; // lanes of a vector
    void (*sum)(const SumTask&);
    void (*bytes)(const ByteTask&);
};

// One per kernel_*.cpp; width 0 where the compiler's target has no such instructions.
extern const Kernel kernel_baseline, kernel_sse41, kernel_avx2, kernel_vnni, kernel_neon, kernel_neon_dot;

} // namespace pantin::network::integer
