// SPDX-License-Identifier: MIT
// Packed filters over one image of bytes: phase planes, sums by the kernel, bytes or real numbers of the
// sums.
#include "network/integer/chains.hpp"

#include <cmath>

#include "network/variant.hpp"

namespace pantin::network::integer {
namespace {

using Word = std::uint32_t;
constexpr std::size_t chunk_lanes = std::size_t{vectors_per_task} * max_vector_width;
constexpr float unit = 1.0f / 65536; // of real results

// One pass of one image, as the tasks see it.
struct Run {
    const Kernel& kernel;
    const PackedFilters& filters;
    const Rescaling& rescaling;
    const Pass& pass;
    const Target& target;
    int n, plane_width, out_width;
    const Lanes& lanes;
    bool in_order; // lanes follow one another as the outputs do

    void block(int b, const Window<Word>& window, int first, int count) const;

private:
    template <class Visit> void visit_vectors(int first, int count, Visit visit) const;
    void to_bytes(int b, const std::int32_t* sums, int first, int count) const;
    void to_real(int b, const std::int32_t* sums, int first, int count) const;
};

void Run::block(int b, const Window<Word>& window, int first, int count) const {
    std::int32_t sums[rows * chunk_lanes];
    const std::size_t per_block = static_cast<std::size_t>(filters.words) * filters.taps * rows;
    kernel.sum({window.data, window.plane, filters.words, window.taps, filters.taps,
                filters.weights.data() + per_block * b, window.bases, count, sums, chunk_lanes});
    if (target.real)
        to_real(b, sums, first, count);
    else
        to_bytes(b, sums, first, count);
}

// visit(lane of the chunk, count, place in the plane)
template <class Visit> void Run::visit_vectors(int first, int count, Visit visit) const {
    for (int v = 0; v < count; ++v)
        visit_runs(lanes.base[first + v], kernel.width, lanes.by_row, plane_width, pass, out_width,
                   [&](int lane, int lanes_of_run, std::size_t place) {
                       visit(v * kernel.width + lane, lanes_of_run, place);
                   });
}

void Run::to_bytes(int b, const std::int32_t* sums, int first, int count) const {
    Word* plane = target.bytes->words.plane(n, b);
    const Word* added = target.added ? target.added->words.plane(n, b) : nullptr;
    const auto task = [&](const Word* residual, Word* out) {
        kernel.bytes({sums, chunk_lanes, rescaling.multiplier.data() + rows * b,
                      rescaling.offset.data() + rows * b, rescaling.shift, rescaling.residual, residual,
                      count * kernel.width, out});
    };
    const std::ptrdiff_t begin = lanes.base[first], end = lanes.base[first + count - 1] + kernel.width;
    if (in_order && end <= static_cast<std::ptrdiff_t>(target.bytes->plane_size()))
        return task(added ? added + begin : nullptr, plane + begin);
    Word gathered[chunk_lanes], results[chunk_lanes];
    if (added) {
        std::fill_n(gathered, count * kernel.width, Word{0});
        visit_vectors(first, count, [&](int lane, int run, std::size_t place) {
            for (int i = 0; i < run; ++i)
                gathered[lane + i] = added[place + static_cast<std::size_t>(i) * pass.step];
        });
    }
    task(added ? gathered : nullptr, results);
    visit_vectors(first, count, [&](int lane, int run, std::size_t place) {
        spread(results + lane, run, pass.step, plane + place);
    });
}

void Run::to_real(int b, const std::int32_t* sums, int first, int count) const {
    for (int r = 0; r < rows && rows * b + r < filters.out; ++r) {
        const std::int64_t multiplier = rescaling.multiplier[static_cast<std::size_t>(rows * b + r)],
                           offset = rescaling.offset[static_cast<std::size_t>(rows * b + r)];
        float* plane = target.real->plane(n, rows * b + r);
        const std::int32_t* own = sums + chunk_lanes * r;
        visit_vectors(first, count, [&](int lane, int run, std::size_t place) {
            for (int i = 0; i < run; ++i) {
                const std::int64_t value = (own[lane + i] * multiplier + offset) >> rescaling.shift;
                plane[place + static_cast<std::size_t>(i) * pass.step] = static_cast<float>(value) * unit;
            }
        });
    }
}

} // namespace

Rescaling padded(Rescaling rescaling) {
    const std::size_t whole = (rescaling.multiplier.size() + rows - 1) / rows * rows;
    rescaling.multiplier.resize(whole);
    rescaling.offset.resize(whole);
    return rescaling;
}

void run_pass(const BasicTensor<Word>& words, int n, const PackedFilters& filters, const Rescaling& rescaling,
              std::uint8_t zero, const Pass& pass, const Runtime& runtime, const Target& target) {
    if (pass.out_height <= 0 || pass.out_width <= 0) return;
    const Kernel& kernel = integer_kernel_of(runtime.simd());
    const PhasePlanes<Word> planes = split_phases(words, n, pass, zero * Word{0x01010101}, runtime);
    const Lanes lanes = place_vectors(pass, planes.width, kernel.width);
    const std::vector<std::ptrdiff_t> taps = tap_offsets(pass, planes.height, planes.width);
    const int out_width = target.real ? target.real->width() : target.bytes->width();
    const Run run{
        kernel, filters,      rescaling, pass,  target,
        n,      planes.width, out_width, lanes, !lanes.by_row && pass.step == 1 && planes.width == out_width};

    const int vectors = static_cast<int>(lanes.base.size());
    const int per_task = chunk_size(filters.words, kernel.width);
    const int chunks = (vectors + per_task - 1) / per_task;
    const int blocks = (filters.out + rows - 1) / rows;
    // Small images have few chunks: then the filters are shared out as well.
    const int slices = std::clamp(tasks_per_thread * runtime.threads() / chunks, 1, blocks);
    runtime.parallel_for(chunks * slices, [&](int task) {
        const int first = task / slices * per_task, slice = task % slices;
        const int count = std::min(per_task, vectors - first);
        Gathered<Word> gathered;
        const Window<Word> window =
            gathered.window(planes, taps, lanes.base.data() + first, count, kernel.width, filters.words);
        for (int b = slice * blocks / slices; b < (slice + 1) * blocks / slices; ++b)
            run.block(b, window, first, count);
    });
}

} // namespace pantin::network::integer
