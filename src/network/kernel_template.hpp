// SPDX-License-Identifier: MIT
// The kernel's source, included by every kernel_*.cpp after it has defined, in an unnamed namespace,
//   PANTIN_TARGET  the function attribute that switches the instruction set on,
//   Vector         with width, load, broadcast, fma, positive_part, store,
//   group          vectors that are computed at once with max_rows rows.
// Everything here has internal linkage and nothing of the standard library is used: no code made for a newer
// processor can be shared with the rest of the program by the linker. (No include guard: once per file.)

#if defined(__clang__)
#define PANTIN_UNROLL _Pragma("unroll")
#else
#define PANTIN_UNROLL _Pragma("GCC unroll 16")
#endif

namespace {

using pantin::network::KernelTask;

// ROWS × VECTORS chains, the accumulators in registers; the weight is broadcast and used for every vector.
template <int ROWS, int VECTORS>
PANTIN_TARGET void run_tile(const KernelTask& task, const std::ptrdiff_t* bases, float* out) {
    Vector acc[ROWS][VECTORS];
    PANTIN_UNROLL
    for (int r = 0; r < ROWS; ++r) {
        PANTIN_UNROLL
        for (int v = 0; v < VECTORS; ++v)
            acc[r][v] = task.bias ? Vector::broadcast(task.bias + r)
                                  : Vector::load(out + r * task.out_stride + v * Vector::width);
    }
    const float* input[VECTORS];
    PANTIN_UNROLL
    for (int v = 0; v < VECTORS; ++v) input[v] = task.input + bases[v];
    const float* weights = task.weights;
    for (int c = 0; c < task.channels; ++c) {
        for (int t = 0; t < task.tap_count; ++t) {
            const std::ptrdiff_t tap = task.taps[t];
            Vector x[VECTORS];
            PANTIN_UNROLL
            for (int v = 0; v < VECTORS; ++v) x[v] = Vector::load(input[v] + tap);
            PANTIN_UNROLL
            for (int r = 0; r < ROWS; ++r) {
                const Vector w = Vector::broadcast(weights + r);
                PANTIN_UNROLL
                for (int v = 0; v < VECTORS; ++v) acc[r][v] = Vector::fma(w, x[v], acc[r][v]);
            }
            weights += ROWS;
        }
        PANTIN_UNROLL
        for (int v = 0; v < VECTORS; ++v) input[v] += task.plane;
    }
    PANTIN_UNROLL
    for (int r = 0; r < ROWS; ++r) {
        PANTIN_UNROLL
        for (int v = 0; v < VECTORS; ++v) {
            if (task.relu) acc[r][v] = Vector::positive_part(acc[r][v]);
            acc[r][v].store(out + r * task.out_stride + v * Vector::width);
        }
    }
}

template <int ROWS> PANTIN_TARGET void run_rows(const KernelTask& task) {
    for (int done = 0; done < task.vectors;) {
        const int left = task.vectors - done;
        float* out = task.out + static_cast<std::size_t>(done) * Vector::width;
        if (left >= group) {
            run_tile<ROWS, group>(task, task.bases + done, out);
            done += group;
        } else if (left >= 2) {
            run_tile<ROWS, 2>(task, task.bases + done, out);
            done += 2;
        } else {
            run_tile<ROWS, 1>(task, task.bases + done, out);
            done += 1;
        }
    }
}

PANTIN_TARGET void run(const KernelTask& task) {
    switch (task.rows) {
    case 1:
        return run_rows<1>(task);
    case 2:
        return run_rows<2>(task);
    case 3:
        return run_rows<3>(task);
    case 4:
        return run_rows<4>(task);
    case 5:
        return run_rows<5>(task);
    default:
        return run_rows<6>(task);
    }
}

} // namespace
