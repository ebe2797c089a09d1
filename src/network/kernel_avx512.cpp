// SPDX-License-Identifier: MIT
// The kernel for AVX-512F: 16 lanes, 6 × 4 accumulators of 32 registers.
#include "network/kernel.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#define PANTIN_TARGET __attribute__((target("avx512f")))
#define PANTIN_INLINE __attribute__((target("avx512f"), always_inline)) inline

namespace {
struct Vector {
    static constexpr int width = 16;
    __m512 v;
    PANTIN_INLINE static Vector load(const float* p) { return {_mm512_loadu_ps(p)}; }
    PANTIN_INLINE static Vector broadcast(const float* p) { return {_mm512_set1_ps(*p)}; }
    PANTIN_INLINE static Vector fma(Vector a, Vector b, Vector c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
    // (a > 0) ? a : +0, also for NaN: the instruction returns its second operand then. (With a
    // mask because g++ 12 warns about its own header's plain _mm512_max_ps.)
    PANTIN_INLINE static Vector positive_part(Vector a) {
        return {_mm512_maskz_max_ps(0xffff, a.v, _mm512_setzero_ps())};
    }
    PANTIN_INLINE void store(float* p) const { _mm512_storeu_ps(p, v); }
};
constexpr int group = 4;
} // namespace

#include "network/kernel_template.hpp"

const pantin::network::Kernel pantin::network::kernel_avx512 = {Vector::width, run};
#else
const pantin::network::Kernel pantin::network::kernel_avx512 = {0, nullptr};
#endif
