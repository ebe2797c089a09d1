// SPDX-License-Identifier: MIT
// The kernels for AVX2: 8 lanes, 4 × 2 sums of 16 registers.
#include "network/integer/kernel.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#define PANTIN_TARGET __attribute__((target("avx2")))
#define PANTIN_INLINE __attribute__((target("avx2"), always_inline)) inline

namespace {
struct Lanes {
    static constexpr int width = 8;
    __m256i v;
    PANTIN_INLINE static Lanes zero() { return {_mm256_setzero_si256()}; }
    PANTIN_INLINE static Lanes load(const std::uint32_t* p) {
        return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))};
    }
    PANTIN_INLINE static Lanes broadcast(const std::uint32_t* p) {
        return {_mm256_set1_epi32(static_cast<int>(*p))};
    }
    PANTIN_INLINE static Lanes dot(Lanes sum, Lanes x, Lanes w) {
        return {
            _mm256_add_epi32(sum.v, _mm256_madd_epi16(_mm256_maddubs_epi16(x.v, w.v), _mm256_set1_epi16(1)))};
    }
    PANTIN_INLINE void store(std::int32_t* p) const { _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), v); }
    template <int bits> PANTIN_INLINE Lanes right() const { return {_mm256_srli_epi32(v, bits)}; }
    template <int bits> PANTIN_INLINE Lanes left() const { return {_mm256_slli_epi32(v, bits)}; }
    PANTIN_INLINE Lanes byte() const { return {_mm256_and_si256(v, _mm256_set1_epi32(255))}; }
};
PANTIN_INLINE Lanes both(Lanes a, Lanes b) { return {_mm256_or_si256(a.v, b.v)}; }

// 2⁶² makes what is shifted positive: there is no arithmetic shift of 64 bits.
struct Rescale {
    __m256i multiplier, offset, residual, bias;
    __m128i shift;
    PANTIN_INLINE Rescale(const pantin::network::integer::ByteTask& task, int r)
        : multiplier(_mm256_set1_epi32(task.multiplier[r])),
          offset(_mm256_set1_epi64x(task.offset[r] + (std::int64_t{1} << 62))),
          residual(_mm256_set1_epi32(task.residual)),
          bias(_mm256_set1_epi32(static_cast<int>(std::uint64_t{1} << (62 - task.shift)))),
          shift(_mm_cvtsi32_si128(task.shift)) {}
    PANTIN_INLINE __m256i half(__m256i sums, __m256i bytes) const {
        const __m256i scaled =
            _mm256_add_epi64(_mm256_mul_epi32(sums, multiplier), _mm256_mul_epi32(bytes, residual));
        return _mm256_srl_epi64(_mm256_add_epi64(scaled, offset), shift);
    }
    PANTIN_INLINE Lanes operator()(Lanes sums, Lanes bytes) const {
        const __m256i even = half(sums.v, bytes.v);
        const __m256i odd = half(_mm256_srli_epi64(sums.v, 32), _mm256_srli_epi64(bytes.v, 32));
        const __m256i value =
            _mm256_sub_epi32(_mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), 0xaa), bias);
        return {_mm256_min_epi32(_mm256_max_epi32(value, _mm256_setzero_si256()), _mm256_set1_epi32(255))};
    }
};
constexpr int group = 2;
} // namespace

#include "network/integer/kernel_template.hpp"

const pantin::network::integer::Kernel pantin::network::integer::kernel_avx2 = {Lanes::width, sum, bytes};
#else
const pantin::network::integer::Kernel pantin::network::integer::kernel_avx2 = {0, nullptr, nullptr};
#endif
