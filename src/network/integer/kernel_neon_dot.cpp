// SPDX-License-Identifier: MIT
// The kernels for aarch64 with the dot product of Armv8.2: 4 lanes, 4 × 4 sums of 32 registers.
#include "network/integer/kernel.hpp"

#if defined(__aarch64__)
#include <arm_neon.h>

#define PANTIN_TARGET __attribute__((target("arch=armv8.2-a+dotprod")))
#define PANTIN_INLINE __attribute__((target("arch=armv8.2-a+dotprod"), always_inline)) inline

namespace {
// The instruction multiplies signed bytes.
PANTIN_INLINE int32x4_t dot_product(int32x4_t sum, uint8x16_t x, int8x16_t w) {
    return vdotq_s32(sum, vreinterpretq_s8_u8(veorq_u8(x, vdupq_n_u8(128))), w);
}
constexpr int group = 4;
} // namespace

#define PANTIN_MOVES_INPUT
#include "network/integer/neon_lanes.hpp"

#include "network/integer/kernel_template.hpp"

const pantin::network::integer::Kernel pantin::network::integer::kernel_neon_dot = {Lanes::width, sum, bytes};
#else
const pantin::network::integer::Kernel pantin::network::integer::kernel_neon_dot = {0, nullptr, nullptr};
#endif
