// SPDX-License-Identifier: MIT
// The kernels for any machine, in the vectors that gcc and clang make of whatever it has.
#include "network/integer/kernel.hpp"

#define PANTIN_TARGET

namespace {

using Words = std::int32_t __attribute__((vector_size(16)));
using Halves = std::int16_t __attribute__((vector_size(16)));

struct Lanes {
    static constexpr int width = 4;
    Words v;
    static Lanes zero() { return {Words{0, 0, 0, 0}}; }
    static Lanes load(const std::uint32_t* p) {
        Lanes lanes;
        __builtin_memcpy(&lanes.v, p, sizeof lanes.v);
        return lanes;
    }
    static Lanes broadcast(const std::uint32_t* p) {
        const auto word = static_cast<std::int32_t>(*p);
        return {Words{word, word, word, word}};
    }
    // Bytes 0 and 2, 1 and 3 in 16 bits; two products fit 16 bits.
    static Lanes dot(const Lanes& sum, const Lanes& x, const Lanes& w) {
        const auto in = reinterpret_cast<Halves>(x.v), weights = reinterpret_cast<Halves>(w.v);
        const Halves low = {255, 255, 255, 255, 255, 255, 255, 255};
        const Halves pairs = (in & low) * ((weights << 8) >> 8) + ((in >> 8) & low) * (weights >> 8);
        const auto both = reinterpret_cast<Words>(pairs);
        return {sum.v + (lower_half(both) + (both >> 16))};
    }
    void store(std::int32_t* p) const { __builtin_memcpy(p, &v, sizeof v); }
    template <int bits> Lanes right() const { return {v >> bits}; }
    template <int bits> Lanes left() const { return {v << bits}; }
    Lanes byte() const { return {v & 255}; }

private:
    static Words lower_half(Words v) { return (v << 16) >> 16; }
};
Lanes both(const Lanes& a, const Lanes& b) { return {a.v | b.v}; }

struct Rescale {
    std::int64_t multiplier, offset, residual;
    int shift;
    Rescale(const pantin::network::integer::ByteTask& task, int r)
        : multiplier(task.multiplier[r]), offset(task.offset[r]), residual(task.residual), shift(task.shift) {
    }
    Lanes operator()(const Lanes& sums, const Lanes& bytes) const {
        Lanes out;
        for (int i = 0; i < Lanes::width; ++i) {
            const std::int64_t value = (sums.v[i] * multiplier + bytes.v[i] * residual + offset) >> shift;
            out.v[i] = static_cast<std::int32_t>(value < 0 ? 0 : value > 255 ? 255 : value);
        }
        return out;
    }
};
constexpr int group = 2;

} // namespace

#include "network/integer/kernel_template.hpp"

const pantin::network::integer::Kernel pantin::network::integer::kernel_baseline = {Lanes::width, sum, bytes};
