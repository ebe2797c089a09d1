// SPDX-License-Identifier: MIT
// Packed filters over one image: the padded image as phase planes, then groups of output vectors through the
// kernel on all threads (pass.hpp says how). Ours.
#include "network/chains.hpp"

#include <algorithm>

#include "network/variant.hpp"

namespace pantin::network {

PackedFilters block_layout(int out, int in_per_group, int groups, int taps) {
    PackedFilters packed;
    packed.in_per_group = in_per_group;
    packed.taps = taps;
    const int per_group = out / groups;
    const int blocks = (per_group + max_rows - 1) / max_rows;
    for (int group = 0; group < groups; ++group)
        for (int b = 0; b < blocks; ++b) {
            FilterBlock block;
            block.group = group;
            block.first = group * per_group + b * per_group / blocks;
            block.rows = group * per_group + (b + 1) * per_group / blocks - block.first;
            packed.blocks.push_back(block);
        }
    return packed;
}

void run_pass(const Tensor& input, int n, const PackedFilters& filters, const std::vector<float>& bias,
              const Pass& pass, const Runtime& runtime, Tensor& output) {
    if (pass.out_height <= 0 || pass.out_width <= 0) return;
    const Kernel& kernel = kernel_of(runtime.simd());
    const PhasePlanes<float> planes = split_phases(input, n, pass, 0.0f, runtime);
    const Lanes lanes = place_vectors(pass, planes.width, kernel.width);
    const std::vector<std::ptrdiff_t> taps = tap_offsets(pass, planes.height, planes.width);

    const int vectors = static_cast<int>(lanes.base.size());
    const int per_task = chunk_size(input.channels(), kernel.width);
    const int chunks = (vectors + per_task - 1) / per_task;
    const int blocks = static_cast<int>(filters.blocks.size());
    // Small images have few chunks: then the filters are shared out as well.
    const int slices = std::clamp(tasks_per_thread * runtime.threads() / chunks, 1, blocks);
    // Where the lanes follow one another as the outputs do, whole chunks are written in place.
    const bool in_order = !lanes.by_row && pass.step == 1 && planes.width == output.width();
    const auto run_block = [&](const FilterBlock& block, const Window<float>& window, int first, int count) {
        float results[max_rows * vectors_per_task * max_vector_width];
        const std::ptrdiff_t begin = lanes.base[first], end = lanes.base[first + count - 1] + kernel.width;
        const bool in_place = in_order && end <= static_cast<std::ptrdiff_t>(output.plane_size());
        const std::size_t stride =
            in_place ? output.plane_size() : static_cast<std::size_t>(vectors_per_task) * kernel.width;
        kernel.run({window.data + window.plane * block.group * filters.in_per_group, window.plane,
                    filters.in_per_group, window.taps, filters.taps, filters.weights.data() + block.begin,
                    bias.data() + block.first, block.rows, window.bases, count,
                    in_place ? output.plane(n, block.first) + begin : results, stride, pass.relu});
        if (in_place) return;
        for (int r = 0; r < block.rows; ++r)
            for (int v = 0; v < count; ++v) {
                const float* values = results + r * stride + static_cast<std::size_t>(v) * kernel.width;
                float* plane = output.plane(n, block.first + r);
                visit_runs(lanes.base[first + v], kernel.width, lanes.by_row, planes.width, pass,
                           output.width(), [&](int lane, int lanes_of_run, std::size_t place) {
                               spread(values + lane, lanes_of_run, pass.step, plane + place);
                           });
            }
    };
    runtime.parallel_for(chunks * slices, [&](int task) {
        const int first = task / slices * per_task, slice = task % slices;
        const int count = std::min(per_task, vectors - first);
        Gathered<float> gathered;
        const Window<float> window =
            gathered.window(planes, taps, lanes.base.data() + first, count, kernel.width, input.channels());
        for (int b = slice * blocks / slices; b < (slice + 1) * blocks / slices; ++b)
            run_block(filters.blocks[b], window, first, count);
    });
}

} // namespace pantin::network
