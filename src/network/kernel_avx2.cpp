// SPDX-License-Identifier: MIT
// The kernel for AVX2 with FMA: 8 lanes, 6 × 2 accumulators of 16 registers.
#include "network/kernel.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#define PANTIN_TARGET __attribute__((target("avx2,fma")))
#define PANTIN_INLINE __attribute__((target("avx2,fma"), always_inline)) inline

namespace {
struct Vector {
    static constexpr int width = 8;
    __m256 v;
    PANTIN_INLINE static Vector load(const float* p) { return {_mm256_loadu_ps(p)}; }
    PANTIN_INLINE static Vector broadcast(const float* p) { return {_mm256_broadcast_ss(p)}; }
    PANTIN_INLINE static Vector fma(Vector a, Vector b, Vector c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
    // (a > 0) ? a : +0, also for NaN: the instruction returns its second operand then.
    PANTIN_INLINE static Vector positive_part(Vector a) { return {_mm256_max_ps(a.v, _mm256_setzero_ps())}; }
    PANTIN_INLINE void store(float* p) const { _mm256_storeu_ps(p, v); }
};
constexpr int group = 2;
} // namespace

#include "network/kernel_template.hpp"

const pantin::network::Kernel pantin::network::kernel_avx2 = {Vector::width, run};
#else
const pantin::network::Kernel pantin::network::kernel_avx2 = {0, nullptr};
#endif
