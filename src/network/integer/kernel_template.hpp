// SPDX-License-Identifier: MIT
// The kernels' source, included by every kernel_*.cpp after it has defined, in an unnamed namespace,
//   PANTIN_TARGET  the function attribute that switches the instruction set on,
//   Lanes          width lanes of 32 bits: zero, load, broadcast (a word), dot, store, both, right, left,
//   byte, Rescale        of one channel; (sums, bytes) → bytes, one a lane, group          the most vectors
//   that are computed at once.
// As in network/kernel_template.hpp nothing of the standard library is used. (No include guard: once per
// file.)

#if defined(__clang__)
#define PANTIN_UNROLL _Pragma("unroll")
#else
#define PANTIN_UNROLL _Pragma("GCC unroll 16")
#endif

namespace {

using pantin::network::integer::ByteTask;
using pantin::network::integer::rows;
using pantin::network::integer::SumTask;

// An instruction that multiplies signed bytes takes the input's x as x − 128; then 128·Σ weights of the
// channel, the same at all places, is added once.
template <class L>
concept MovesInput = requires(L lanes) {
    L::plus_128_times(lanes, lanes);
};

// The sums of four channels at VECTORS places, in registers; a word of weights is used for every vector.
template <int VECTORS, class L = Lanes>
PANTIN_TARGET void sum_tile(const SumTask& task, const std::ptrdiff_t* bases, std::int32_t* out) {
    L sum[rows][VECTORS];
    [[maybe_unused]] L moved[rows];
    const std::uint32_t* input[VECTORS];
    PANTIN_UNROLL
    for (int v = 0; v < VECTORS; ++v) input[v] = task.input + bases[v];
    PANTIN_UNROLL
    for (int r = 0; r < rows; ++r) {
        moved[r] = L::zero();
        PANTIN_UNROLL
        for (int v = 0; v < VECTORS; ++v) sum[r][v] = L::zero();
    }
    const std::uint32_t* weights = task.weights;
    for (int word = 0; word < task.words; ++word) {
        for (int t = 0; t < task.tap_count; ++t) {
            const std::ptrdiff_t tap = task.taps[t];
            L x[VECTORS];
            PANTIN_UNROLL
            for (int v = 0; v < VECTORS; ++v) x[v] = L::load(input[v] + tap);
            PANTIN_UNROLL
            for (int r = 0; r < rows; ++r) {
                const L w = L::broadcast(weights + r);
                if constexpr (MovesInput<L>) moved[r] = L::plus_128_times(moved[r], w);
                PANTIN_UNROLL
                for (int v = 0; v < VECTORS; ++v) sum[r][v] = L::dot(sum[r][v], x[v], w);
            }
            weights += rows;
        }
        PANTIN_UNROLL
        for (int v = 0; v < VECTORS; ++v) input[v] += task.plane;
    }
    PANTIN_UNROLL
    for (int r = 0; r < rows; ++r) {
        PANTIN_UNROLL
        for (int v = 0; v < VECTORS; ++v) {
            if constexpr (MovesInput<L>) sum[r][v] = plus(sum[r][v], moved[r]);
            sum[r][v].store(out + r * task.out_stride + v * L::width);
        }
    }
}

PANTIN_TARGET void sum(const SumTask& task) {
    for (int done = 0; done < task.vectors;) {
        const int left = task.vectors - done;
        const std::ptrdiff_t* bases = task.bases + done;
        std::int32_t* out = task.out + static_cast<std::size_t>(done) * Lanes::width;
        if (left >= group) {
            sum_tile<group>(task, bases, out);
            done += group;
        } else if (group > 4 && left >= 4) {
            sum_tile<4>(task, bases, out);
            done += 4;
        } else if (group > 2 && left >= 2) {
            sum_tile<2>(task, bases, out);
            done += 2;
        } else {
            sum_tile<1>(task, bases, out);
            done += 1;
        }
    }
}

// The bytes of channel r at their place in the words.
template <int r> PANTIN_TARGET Lanes byte_of(const ByteTask& task, int i, const Lanes& added) {
    const Rescale rescale(task, r);
    const Lanes sums =
        Lanes::load(reinterpret_cast<const std::uint32_t*>(task.sums + r * task.sum_stride + i));
    return rescale(sums, added.right<8 * r>().byte()).template left<8 * r>();
}

PANTIN_TARGET void bytes(const ByteTask& task) {
    for (int i = 0; i < task.count; i += Lanes::width) {
        const Lanes added = task.added ? Lanes::load(task.added + i) : Lanes::zero();
        const Lanes low = both(byte_of<0>(task, i, added), byte_of<1>(task, i, added));
        const Lanes high = both(byte_of<2>(task, i, added), byte_of<3>(task, i, added));
        both(low, high).store(reinterpret_cast<std::int32_t*>(task.out + i));
    }
}

} // namespace
