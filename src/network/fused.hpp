// SPDX-License-Identifier: MIT
// fmaf with correct rounding on machines without the instruction. Follows Boldo & Melquiond, "Emulation of a
// FMA and correctly rounded sums: proved algorithms using rounding to odd", IEEE Transactions on Computers
// 2008.
#pragma once

#include <bit>
#include <cstdint>

namespace pantin::network {

// The product of two floats is exact in double. Their sum with the third is rounded to odd (truncated, then
// the last bit set if anything was lost); double has more than 2·24 + 2 bits, so that rounding it to float is
// the one rounding of the exact value, subnormal results included.
inline float fused_emulated(float a, float b, float c) {
    const double product = static_cast<double>(a) * b, addend = c;
    const double sum = product + addend;
    // Knuth's TwoSum: sum + error is exact. Infinite and NaN sums give a NaN error, which is left alone
    // below.
    const double rest = sum - product;
    const double error = (product - (sum - rest)) + (addend - rest);
    // One step towards the error where the sum is even; without branches, half of them would be mispredicted.
    const auto bits = std::bit_cast<std::int64_t>(sum);
    const std::int64_t outwards = (bits ^ std::bit_cast<std::int64_t>(error)) < 0 ? -1 : 1;
    const bool step = ((error < 0) | (error > 0)) & ((bits & 1) == 0);
    return static_cast<float>(std::bit_cast<double>(bits + outwards * step));
}

inline float fused(float a, float b, float c) {
#ifdef __FP_FAST_FMAF
    return __builtin_fmaf(a, b, c);
#else
    return fused_emulated(a, b, c);
#endif
}

} // namespace pantin::network
