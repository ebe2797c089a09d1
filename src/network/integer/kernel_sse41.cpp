// SPDX-License-Identifier: MIT
// The kernels for SSE4.1: 4 lanes, 4 × 2 sums of 16 registers.
#include "network/integer/kernel.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#define PANTIN_TARGET __attribute__((target("sse4.1")))
#define PANTIN_INLINE __attribute__((target("sse4.1"), always_inline)) inline

namespace {
struct Lanes {
    static constexpr int width = 4;
    __m128i v;
    PANTIN_INLINE static Lanes zero() { return {_mm_setzero_si128()}; }
    PANTIN_INLINE static Lanes load(const std::uint32_t* p) {
        return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))};
    }
    PANTIN_INLINE static Lanes broadcast(const std::uint32_t* p) {
        return {_mm_set1_epi32(static_cast<int>(*p))};
    }
    PANTIN_INLINE static Lanes dot(Lanes sum, Lanes x, Lanes w) {
        return {_mm_add_epi32(sum.v, _mm_madd_epi16(_mm_maddubs_epi16(x.v, w.v), _mm_set1_epi16(1)))};
    }
    PANTIN_INLINE void store(std::int32_t* p) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v); }
    template <int bits> PANTIN_INLINE Lanes right() const { return {_mm_srli_epi32(v, bits)}; }
    template <int bits> PANTIN_INLINE Lanes left() const { return {_mm_slli_epi32(v, bits)}; }
    PANTIN_INLINE Lanes byte() const { return {_mm_and_si128(v, _mm_set1_epi32(255))}; }
};
PANTIN_INLINE Lanes both(Lanes a, Lanes b) { return {_mm_or_si128(a.v, b.v)}; }

// 2⁶² makes what is shifted positive: there is no arithmetic shift of 64 bits.
struct Rescale {
    __m128i multiplier, offset, residual, shift, bias;
    PANTIN_INLINE Rescale(const pantin::network::integer::ByteTask& task, int r)
        : multiplier(_mm_set1_epi32(task.multiplier[r])),
          offset(_mm_set1_epi64x(task.offset[r] + (std::int64_t{1} << 62))),
          residual(_mm_set1_epi32(task.residual)), shift(_mm_cvtsi32_si128(task.shift)),
          bias(_mm_set1_epi32(static_cast<int>(std::uint64_t{1} << (62 - task.shift)))) {}
    PANTIN_INLINE __m128i half(__m128i sums, __m128i bytes) const {
        const __m128i scaled = _mm_add_epi64(_mm_mul_epi32(sums, multiplier), _mm_mul_epi32(bytes, residual));
        return _mm_srl_epi64(_mm_add_epi64(scaled, offset), shift);
    }
    PANTIN_INLINE Lanes operator()(Lanes sums, Lanes bytes) const {
        const __m128i even = half(sums.v, bytes.v);
        const __m128i odd = half(_mm_srli_epi64(sums.v, 32), _mm_srli_epi64(bytes.v, 32));
        const __m128i value = _mm_sub_epi32(_mm_blend_epi16(even, _mm_slli_epi64(odd, 32), 0xcc), bias);
        return {_mm_min_epi32(_mm_max_epi32(value, _mm_setzero_si128()), _mm_set1_epi32(255))};
    }
};
constexpr int group = 2;
} // namespace

#include "network/integer/kernel_template.hpp"

const pantin::network::integer::Kernel pantin::network::integer::kernel_sse41 = {Lanes::width, sum, bytes};
#else
const pantin::network::integer::Kernel pantin::network::integer::kernel_sse41 = {0, nullptr, nullptr};
#endif
