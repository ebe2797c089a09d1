// SPDX-License-Identifier: MIT
// What both NEON kernels share, included by them after arm_neon.h and the definition of PANTIN_INLINE, of
//   PANTIN_MOVES_INPUT where dot_product takes the input as x − 128 (kernel_template.hpp), and of
//   int32x4_t dot_product(int32x4_t sum, uint8x16_t x, int8x16_t w).
// (No include guard: once per file.)

namespace {

struct Lanes {
    static constexpr int width = 4;
    int32x4_t v;
    PANTIN_INLINE static Lanes zero() { return {vdupq_n_s32(0)}; }
    PANTIN_INLINE static Lanes load(const std::uint32_t* p) { return {vreinterpretq_s32_u32(vld1q_u32(p))}; }
    PANTIN_INLINE static Lanes broadcast(const std::uint32_t* p) {
        return {vreinterpretq_s32_u32(vdupq_n_u32(*p))};
    }
    PANTIN_INLINE static Lanes dot(Lanes sum, Lanes x, Lanes w) {
        return {dot_product(sum.v, vreinterpretq_u8_s32(x.v), vreinterpretq_s8_s32(w.v))};
    }
#ifdef PANTIN_MOVES_INPUT
    PANTIN_INLINE static Lanes plus_128_times(Lanes sum, Lanes w) {
        const int8x16_t half = vdupq_n_s8(64), weights = vreinterpretq_s8_s32(w.v);
        return {vdotq_s32(vdotq_s32(sum.v, half, weights), half, weights)};
    }
#endif
    PANTIN_INLINE void store(std::int32_t* p) const { vst1q_s32(p, v); }
    template <int bits> PANTIN_INLINE Lanes right() const {
        if constexpr (bits == 0)
            return *this;
        else
            return {vreinterpretq_s32_u32(vshrq_n_u32(vreinterpretq_u32_s32(v), bits))};
    }
    template <int bits> PANTIN_INLINE Lanes left() const { return {vshlq_n_s32(v, bits)}; }
    PANTIN_INLINE Lanes byte() const { return {vandq_s32(v, vdupq_n_s32(255))}; }
};
PANTIN_INLINE Lanes both(Lanes a, Lanes b) { return {vorrq_s32(a.v, b.v)}; }
#ifdef PANTIN_MOVES_INPUT
PANTIN_INLINE Lanes plus(Lanes a, Lanes b) { return {vaddq_s32(a.v, b.v)}; }
#endif

struct Rescale {
    int32x2_t multiplier, residual;
    int64x2_t offset, shift; // negative: to the right
    PANTIN_INLINE Rescale(const pantin::network::integer::ByteTask& task, int r)
        : multiplier(vdup_n_s32(task.multiplier[r])), residual(vdup_n_s32(task.residual)),
          offset(vdupq_n_s64(task.offset[r])), shift(vdupq_n_s64(-task.shift)) {}
    PANTIN_INLINE int32x2_t half(int32x2_t sums, int32x2_t bytes) const {
        const int64x2_t scaled = vmlal_s32(vmlal_s32(offset, sums, multiplier), bytes, residual);
        return vmovn_s64(vshlq_s64(scaled, shift));
    }
    PANTIN_INLINE Lanes operator()(Lanes sums, Lanes bytes) const {
        const int32x4_t value = vcombine_s32(half(vget_low_s32(sums.v), vget_low_s32(bytes.v)),
                                             half(vget_high_s32(sums.v), vget_high_s32(bytes.v)));
        return {vminq_s32(vmaxq_s32(value, vdupq_n_s32(0)), vdupq_n_s32(255))};
    }
};

} // namespace
