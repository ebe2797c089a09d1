// SPDX-License-Identifier: MIT
// The kernel for aarch64, whose baseline has fused multiply-add: 4 lanes, 6 × 4 accumulators of 32 registers.
#include "network/kernel.hpp"

#if defined(__aarch64__)
#include <arm_neon.h>

#define PANTIN_TARGET
#define PANTIN_INLINE __attribute__((always_inline)) inline

namespace {
struct Vector {
    static constexpr int width = 4;
    float32x4_t v;
    PANTIN_INLINE static Vector load(const float* p) { return {vld1q_f32(p)}; }
    PANTIN_INLINE static Vector broadcast(const float* p) { return {vdupq_n_f32(*p)}; }
    PANTIN_INLINE static Vector fma(Vector a, Vector b, Vector c) { return {vfmaq_f32(c.v, a.v, b.v)}; }
    PANTIN_INLINE static Vector positive_part(Vector a) {
        const float32x4_t zero = vdupq_n_f32(0);
        return {vbslq_f32(vcgtq_f32(a.v, zero), a.v, zero)};
    }
    PANTIN_INLINE void store(float* p) const { vst1q_f32(p, v); }
};
constexpr int group = 4;
} // namespace

#include "network/kernel_template.hpp"

const pantin::network::Kernel pantin::network::kernel_neon = {Vector::width, run};
#else
const pantin::network::Kernel pantin::network::kernel_neon = {0, nullptr};
#endif
