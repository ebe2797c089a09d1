// SPDX-License-Identifier: MIT
// The kernels for aarch64 without the dot product: 4 lanes, 4 × 4 sums of 32 registers.
#include "network/integer/kernel.hpp"

#if defined(__aarch64__)
#include <arm_neon.h>

#define PANTIN_TARGET
#define PANTIN_INLINE __attribute__((always_inline)) inline

namespace {
// Products of two fit 16 bits, and so do sums of two.
PANTIN_INLINE int32x4_t dot_product(int32x4_t sum, uint8x16_t x, int8x16_t w) {
    const int16x8_t low =
        vmulq_s16(vreinterpretq_s16_u16(vmovl_u8(vget_low_u8(x))), vmovl_s8(vget_low_s8(w)));
    const int16x8_t high = vmulq_s16(vreinterpretq_s16_u16(vmovl_high_u8(x)), vmovl_high_s8(w));
    return vpadalq_s16(sum, vpaddq_s16(low, high));
}
constexpr int group = 4;
} // namespace

#include "network/integer/neon_lanes.hpp"

#include "network/integer/kernel_template.hpp"

const pantin::network::integer::Kernel pantin::network::integer::kernel_neon = {Lanes::width, sum, bytes};
#else
const pantin::network::integer::Kernel pantin::network::integer::kernel_neon = {0, nullptr, nullptr};
#endif
