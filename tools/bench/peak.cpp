// SPDX-License-Identifier: MIT
// How many fused multiply-adds, and how many products of bytes, a second one thread of this machine can do at
// most: independent chains in registers, no memory. What the convolutions are measured against.
#include <chrono>
#include <cstdint>

#include "bench.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace pantin::bench {

#if defined(__x86_64__)

namespace {

constexpr int chains = 12; // latency 4, two units: eight would do
constexpr std::int64_t steps = 2'000'000;

// One function an instruction set: a vector type may not cross into code of another target.
[[gnu::target("avx2,fma")]] float chains_avx2() {
    const __m256 factor = _mm256_set1_ps(0.5f), term = _mm256_set1_ps(0.25f);
    __m256 sums[chains];
    for (__m256& sum : sums) sum = term;
    for (std::int64_t i = 0; i < steps; ++i)
#pragma GCC unroll 12
        for (__m256& sum : sums) sum = _mm256_fmadd_ps(sum, factor, term);
    for (int i = 1; i < chains; ++i) sums[0] = _mm256_add_ps(sums[0], sums[i]);
    return _mm256_cvtss_f32(sums[0]);
}
[[gnu::target("avx512f")]] float chains_avx512() {
    const __m512 factor = _mm512_set1_ps(0.5f), term = _mm512_set1_ps(0.25f);
    __m512 sums[chains];
    for (__m512& sum : sums) sum = term;
    for (std::int64_t i = 0; i < steps; ++i)
#pragma GCC unroll 12
        for (__m512& sum : sums) sum = _mm512_fmadd_ps(sum, factor, term);
    for (int i = 1; i < chains; ++i) sums[0] = _mm512_add_ps(sums[0], sums[i]);
    return _mm512_cvtss_f32(sums[0]);
}

// Products of bytes, added up in 32 bits: three instructions, or one of VNNI.
[[gnu::target("avx2")]] int dot_products_avx2() {
    const __m256i bytes = _mm256_set1_epi8(3), ones = _mm256_set1_epi16(1);
    __m256i sums[chains];
    for (__m256i& sum : sums) sum = _mm256_setzero_si256();
    for (std::int64_t i = 0; i < steps; ++i)
#pragma GCC unroll 12
        for (__m256i& sum : sums) // the sum takes part, so that nothing can be computed once
            sum = _mm256_add_epi32(sum, _mm256_madd_epi16(_mm256_maddubs_epi16(sum, bytes), ones));
    for (int i = 1; i < chains; ++i) sums[0] = _mm256_add_epi32(sums[0], sums[i]);
    return _mm256_cvtsi256_si32(sums[0]);
}
[[gnu::target("avx512f,avx512vnni")]] int dot_products_vnni() {
    const __m512i bytes = _mm512_set1_epi32(0x03030303), other = _mm512_set1_epi32(0x05050505);
    __m512i sums[chains];
    for (__m512i& sum : sums) sum = _mm512_setzero_si512();
    for (std::int64_t i = 0; i < steps; ++i)
#pragma GCC unroll 12
        for (__m512i& sum : sums) sum = _mm512_dpbusd_epi32(sum, bytes, other);
    for (int i = 1; i < chains; ++i) sums[0] = _mm512_add_epi32(sums[0], sums[i]);
    return _mm512_cvtsi512_si32(sums[0]);
}

} // namespace

double dot_product_peak(network::Simd simd) {
    const bool vnni = simd == network::Simd::vnni;
    if (simd != network::Simd::avx2 && !vnni) return 0;
    volatile int keep = 0;
    const double time = least_time([&] { keep = vnni ? dot_products_vnni() : dot_products_avx2(); }, 10);
    return 1.0 * chains * (vnni ? 64 : 32) * static_cast<double>(steps) / (time * 1e6);
}

double fma_peak(network::Simd simd) {
    if (simd != network::Simd::avx2 && simd != network::Simd::avx512) return 0;
    const int lanes = simd == network::Simd::avx512 ? 16 : 8;
    volatile float keep = 0;
    const double time =
        least_time([&] { keep = simd == network::Simd::avx512 ? chains_avx512() : chains_avx2(); }, 10);
    return 2.0 * chains * lanes * static_cast<double>(steps) / (time * 1e6);
}

#else

double fma_peak(network::Simd) { return 0; }
double dot_product_peak(network::Simd) { return 0; }

#endif

} // namespace pantin::bench
