// SPDX-License-Identifier: MIT
// Packed filters over one image: the padded image as phase planes, then groups of output vectors through the
// kernel on all threads (chains.hpp says how). Ours.
#include "network/chains.hpp"

#include <algorithm>

#include "network/variant.hpp"

namespace pantin::network {
namespace {

// Vectors of one task: enough to reuse the weights, few enough that the input stays in the first cache
// levels.
constexpr int vectors_per_task = 16;
constexpr std::ptrdiff_t cached_floats = 256 * 1024; // half of a second-level cache
constexpr int tasks_per_thread = 4;                  // so that no thread waits long for the last task

// The padded input as phase planes: channel c, phase (py, px) at ((c·stride + py)·stride + px)·size, of which
// row r, column q is the padded image's pixel (r·stride + py, q·stride + px).
struct PhasePlanes {
    int height = 0, width = 0;   // of one phase plane
    std::size_t channel = 0;     // floats from one input channel to the next
    const float* data = nullptr; // in the runtime's scratch memory, or the image itself
};

// One row of a phase plane: zeros, every stride-th pixel of the image's row, zeros.
void fill_row(const float* in, int width, const Pass& pass, int px, int count, float* row) {
    const int shift = px - pass.left; // column q shows in[q·stride + shift]
    const int first = std::min(count, shift < 0 ? (-shift + pass.stride - 1) / pass.stride : 0);
    const int last = width > shift ? std::min(count, (width - 1 - shift) / pass.stride + 1) : first;
    std::fill(row, row + first, 0.0f);
    if (pass.stride == 1 && last > first)
        std::copy(in + (first + shift), in + (last + shift), row + first);
    else
        for (int q = first; q < last; ++q) row[q] = in[q * pass.stride + shift];
    std::fill(row + std::max(first, last), row + count, 0.0f);
}

void fill_phase(const float* image, int height, int width, const Pass& pass, int py, int px,
                const PhasePlanes& planes, float* out) {
    for (int r = 0; r < planes.height; ++r, out += planes.width) {
        const int y = r * pass.stride + py - pass.top;
        if (y < 0 || y >= height)
            std::fill(out, out + planes.width, 0.0f);
        else
            fill_row(image + static_cast<std::size_t>(y) * width, width, pass, px, planes.width, out);
    }
}

PhasePlanes split_phases(const Tensor& input, int n, const Pass& pass, const Runtime& runtime) {
    PhasePlanes planes;
    if (pass.taps.size() == 1 && pass.taps[0].dy == 0 && pass.taps[0].dx == 0 && pass.stride == 1 &&
        pass.top == 0 && pass.left == 0 && pass.out_height == input.height() &&
        pass.out_width == input.width())
        return {input.height(), input.width(), input.plane_size(), input.plane(n, 0)}; // nothing to do
    int reach_y = 0, reach_x = 0;
    for (const Tap& tap : pass.taps) {
        reach_y = std::max(reach_y, tap.dy / pass.stride);
        reach_x = std::max(reach_x, tap.dx / pass.stride);
    }
    planes.height = pass.out_height + reach_y;
    planes.width = pass.out_width + reach_x;
    const std::size_t size = static_cast<std::size_t>(planes.height) * planes.width;
    planes.channel = size * pass.stride * pass.stride;
    const std::size_t total = planes.channel * input.channels();
    float* const data = runtime.scratch(total + max_vector_width);
    planes.data = data;
    std::fill(data + total, data + total + max_vector_width, 0.0f);
    runtime.parallel_for(input.channels(), [&](int c) {
        float* out = data + planes.channel * c;
        for (int py = 0; py < pass.stride; ++py)
            for (int px = 0; px < pass.stride; ++px, out += size)
                fill_phase(input.plane(n, c), input.height(), input.width(), pass, py, px, planes, out);
    });
    return planes;
}

// Where the lanes of each vector lie in a phase plane.
struct Lanes {
    bool by_row = true;               // a vector stays in its row; else it runs on into the next one
    std::vector<std::ptrdiff_t> base; // per vector, of its first lane
};

Lanes place_vectors(const Pass& pass, int plane_width, int width) {
    Lanes lanes;
    const long per_row = (pass.out_width + width - 1) / width;
    const long line = static_cast<long>(pass.out_height - 1) * plane_width + pass.out_width;
    const long on_line = (line + width - 1) / width;
    lanes.by_row = plane_width != pass.out_width && per_row * pass.out_height <= on_line;
    if (lanes.by_row) {
        for (int y = 0; y < pass.out_height; ++y)
            for (int k = 0; k < per_row; ++k)
                lanes.base.push_back(static_cast<std::ptrdiff_t>(y) * plane_width +
                                     static_cast<std::ptrdiff_t>(k) * width);
    } else {
        for (long k = 0; k < on_line; ++k) lanes.base.push_back(k * width);
    }
    return lanes;
}

// Copies the lanes of one vector that are outputs to their places.
void scatter(const float* values, std::ptrdiff_t base, int width, bool by_row, int plane_width,
             const Pass& pass, float* plane, int out_width) {
    int y = static_cast<int>(base / plane_width), x = static_cast<int>(base % plane_width);
    for (int lane = 0; lane < width && y < pass.out_height;) {
        const int count = std::min(width - lane, std::max(0, pass.out_width - x));
        float* out = plane + (static_cast<std::size_t>(y) * pass.step + pass.row) * out_width +
                     static_cast<std::size_t>(x) * pass.step + pass.column;
        if (pass.step == 1)
            std::copy(values + lane, values + lane + count, out);
        else
            for (int i = 0; i < count; ++i) out[static_cast<std::size_t>(i) * pass.step] = values[lane + i];
        if (by_row) return;
        lane += plane_width - x; // the next row starts there
        x = 0;
        ++y;
    }
}

// Vectors of one task: fewer where the input has so many channels that it would leave the cache.
int chunk_size(int channels, int width) {
    return std::clamp(static_cast<int>(cached_floats / (std::ptrdiff_t{channels} * width)), 4,
                      vectors_per_task);
}

// The input as the kernel reads it for one chunk of vectors.
struct Window {
    const float* data;
    std::size_t plane; // floats from one channel to the next
    const std::ptrdiff_t *taps, *bases;
};

// A chunk reads a short stretch of every channel. Where the channels lie pages apart, the stretches are first
// copied to one place: all filters read them again and again, and neither the processor's address cache nor
// its prefetcher would follow from channel to channel.
class Gathered {
public:
    Window window(const PhasePlanes& planes, const std::vector<std::ptrdiff_t>& taps,
                  const std::ptrdiff_t* bases, int count, int width, int channels) {
        const Window direct = {planes.data, planes.channel, taps.data(), bases};
        if (taps.empty()) return direct; // a phase of a transposed convolution that no tap reaches
        const auto [nearest, farthest] = std::minmax_element(taps.begin(), taps.end());
        const std::ptrdiff_t begin = bases[0] + *nearest,
                             length = bases[count - 1] + *farthest + width - begin;
        if (planes.channel < apart || length * channels > cached_floats) return direct;
        // No stretch reaches beyond the scratch memory's spare floats behind the last plane.
        values_.resize(static_cast<std::size_t>(length * channels));
        for (int c = 0; c < channels; ++c)
            std::copy_n(planes.data + planes.channel * c + begin, length, values_.data() + length * c);
        for (const std::ptrdiff_t tap : taps) taps_.push_back(tap - *nearest);
        for (int v = 0; v < count; ++v) bases_.push_back(bases[v] - bases[0]);
        return {values_.data(), static_cast<std::size_t>(length), taps_.data(), bases_.data()};
    }

private:
    static constexpr std::size_t apart = 512; // floats

    std::vector<float> values_;
    std::vector<std::ptrdiff_t> taps_, bases_;
};

} // namespace

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
    const PhasePlanes planes = split_phases(input, n, pass, runtime);
    const Lanes lanes = place_vectors(pass, planes.width, kernel.width);
    std::vector<std::ptrdiff_t> taps; // [tap]
    for (const Tap& tap : pass.taps) {
        const int phase = tap.dy % pass.stride * pass.stride + tap.dx % pass.stride;
        taps.push_back((static_cast<std::ptrdiff_t>(phase) * planes.height + tap.dy / pass.stride) *
                           planes.width +
                       tap.dx / pass.stride);
    }

    const int vectors = static_cast<int>(lanes.base.size());
    const int per_task = chunk_size(input.channels(), kernel.width);
    const int chunks = (vectors + per_task - 1) / per_task;
    const int blocks = static_cast<int>(filters.blocks.size());
    // Small images have few chunks: then the filters are shared out as well.
    const int slices = std::clamp(tasks_per_thread * runtime.threads() / chunks, 1, blocks);
    // Where the lanes follow one another as the outputs do, whole chunks are written in place.
    const bool in_order = !lanes.by_row && pass.step == 1 && planes.width == output.width();
    const auto run_block = [&](const FilterBlock& block, const Window& window, int first, int count) {
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
            for (int v = 0; v < count; ++v)
                scatter(results + r * stride + static_cast<std::size_t>(v) * kernel.width,
                        lanes.base[first + v], kernel.width, lanes.by_row, planes.width, pass,
                        output.plane(n, block.first + r), output.width());
    };
    runtime.parallel_for(chunks * slices, [&](int task) {
        const int first = task / slices * per_task, slice = task % slices;
        const int count = std::min(per_task, vectors - first);
        Gathered gathered;
        const Window window =
            gathered.window(planes, taps, lanes.base.data() + first, count, kernel.width, input.channels());
        for (int b = slice * blocks / slices; b < (slice + 1) * blocks / slices; ++b)
            run_block(filters.blocks[b], window, first, count);
    });
}

} // namespace pantin::network
