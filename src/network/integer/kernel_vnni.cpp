// SPDX-License-Identifier: MIT
// The kernels for AVX-512 with VNNI: 16 lanes, 4 × 6 sums of 32 registers.
#include "network/integer/kernel.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#define PANTIN_TARGET __attribute__((target("avx512f,avx512bw,avx512vnni")))
#define PANTIN_INLINE __attribute__((target("avx512f,avx512bw,avx512vnni"), always_inline)) inline

namespace {
struct Lanes {
    static constexpr int width = 16;
    __m512i v;
    PANTIN_INLINE static Lanes zero() { return {_mm512_setzero_si512()}; }
    PANTIN_INLINE static Lanes load(const std::uint32_t* p) { return {_mm512_loadu_si512(p)}; }
    PANTIN_INLINE static Lanes broadcast(const std::uint32_t* p) {
        return {_mm512_set1_epi32(static_cast<int>(*p))};
    }
    PANTIN_INLINE static Lanes dot(Lanes sum, Lanes x, Lanes w) {
        return {_mm512_dpbusd_epi32(sum.v, x.v, w.v)};
    }
    PANTIN_INLINE void store(std::int32_t* p) const { _mm512_storeu_si512(p, v); }
    // (With masks because g++ 12 warns about its own header's plain forms.)
    template <int bits> PANTIN_INLINE Lanes right() const {
        return {_mm512_maskz_srli_epi32(0xffff, v, bits)};
    }
    template <int bits> PANTIN_INLINE Lanes left() const {
        return {_mm512_maskz_slli_epi32(0xffff, v, bits)};
    }
    PANTIN_INLINE Lanes byte() const { return {_mm512_and_si512(v, _mm512_set1_epi32(255))}; }
};
PANTIN_INLINE Lanes both(Lanes a, Lanes b) { return {_mm512_or_si512(a.v, b.v)}; }

// 2⁶² makes what is shifted positive, so that a logical shift serves, as in the other kernels.
struct Rescale {
    __m512i multiplier, offset, residual, bias;
    __m128i shift;
    PANTIN_INLINE Rescale(const pantin::network::integer::ByteTask& task, int r)
        : multiplier(_mm512_set1_epi32(task.multiplier[r])),
          offset(_mm512_set1_epi64(task.offset[r] + (std::int64_t{1} << 62))),
          residual(_mm512_set1_epi32(task.residual)),
          bias(_mm512_set1_epi32(static_cast<int>(std::uint64_t{1} << (62 - task.shift)))),
          shift(_mm_cvtsi32_si128(task.shift)) {}
    PANTIN_INLINE __m512i half(__m512i sums, __m512i bytes) const {
        const __m512i scaled = _mm512_add_epi64(_mm512_maskz_mul_epi32(0xff, sums, multiplier),
                                                _mm512_maskz_mul_epi32(0xff, bytes, residual));
        return _mm512_maskz_srl_epi64(0xff, _mm512_add_epi64(scaled, offset), shift);
    }
    PANTIN_INLINE Lanes operator()(Lanes sums, Lanes bytes) const {
        const __m512i even = half(sums.v, bytes.v);
        const __m512i odd =
            half(_mm512_maskz_srli_epi64(0xff, sums.v, 32), _mm512_maskz_srli_epi64(0xff, bytes.v, 32));
        const __m512i value = _mm512_sub_epi32(
            _mm512_mask_blend_epi32(0xaaaa, even, _mm512_maskz_slli_epi64(0xff, odd, 32)), bias);
        return {_mm512_maskz_min_epi32(0xffff, _mm512_maskz_max_epi32(0xffff, value, _mm512_setzero_si512()),
                                       _mm512_set1_epi32(255))};
    }
};
constexpr int group = 6;
} // namespace

#include "network/integer/kernel_template.hpp"

const pantin::network::integer::Kernel pantin::network::integer::kernel_vnni = {Lanes::width, sum, bytes};
#else
const pantin::network::integer::Kernel pantin::network::integer::kernel_vnni = {0, nullptr, nullptr};
#endif
