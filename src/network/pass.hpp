// SPDX-License-Identifier: MIT
// What every convolution shares, whatever it computes with: where taps and vectors lie, and where results go.
//
// A convolution of any stride and dilation becomes "for every tap, a shifted plane": the padded input is
// split into stride² phase planes (rows and columns modulo the stride), so that neighbouring outputs read
// neighbouring elements and a tap is one fixed offset. Vectors run along an output row, or, where rows are no
// whole number of vectors, through the padded rows as one line whose few surplus results are dropped.
//
// An element is a float, or a word of four bytes (integer/byte_tensor.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "network/vector_width.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

// Vectors of one task: enough to reuse the weights, few enough that the input stays in the first cache
// levels.
inline constexpr int vectors_per_task = 16;
inline constexpr int tasks_per_thread = 4; // so that no thread waits long for the last task
inline constexpr std::ptrdiff_t cached_elements = 256 * 1024; // half of a second-level cache

// A tap reads the input at row y·stride + dy, column x·stride + dx of the padded image, dy and dx ≥ 0.
struct Tap {
    int dy = 0, dx = 0;
};
struct Pass {
    int out_height = 0, out_width = 0; // of the grid of outputs that this pass computes
    int stride = 1;                    // of the input
    int top = 0, left = 0;             // rows and columns of padding before the image
    std::vector<Tap> taps;
    bool relu = false;
    int step = 1, row = 0, column = 0; // output (y, x) of the grid goes to (y·step + row, x·step + column)
};

// The padded input as phase planes: channel c, phase (py, px) at ((c·stride + py)·stride + px)·size, of which
// row r, column q is the padded image's pixel (r·stride + py, q·stride + px).
template <class Element> struct PhasePlanes {
    int height = 0, width = 0;     // of one phase plane
    std::size_t channel = 0;       // elements from one input channel to the next
    const Element* data = nullptr; // in the runtime's scratch memory, or the image itself
};

// Where each tap reads, relative to the first element of a vector's place in a phase plane.
std::vector<std::ptrdiff_t> tap_offsets(const Pass& pass, int plane_height, int plane_width);

// Where the lanes of each vector lie in a phase plane.
struct Lanes {
    bool by_row = true;               // a vector stays in its row; else it runs on into the next one
    std::vector<std::ptrdiff_t> base; // per vector, of its first lane
};
Lanes place_vectors(const Pass& pass, int plane_width, int width);

// Vectors of one task: fewer where the input has so many channels that it would leave the cache.
int chunk_size(int channels, int width);

// One row of a phase plane: padding, every stride-th pixel of the image's row, padding.
template <class Element>
void fill_row(const Element* in, int width, const Pass& pass, int px, Element padding, int count,
              Element* row) {
    const int shift = px - pass.left; // column q shows in[q·stride + shift]
    const int first = std::min(count, shift < 0 ? (-shift + pass.stride - 1) / pass.stride : 0);
    const int last = width > shift ? std::min(count, (width - 1 - shift) / pass.stride + 1) : first;
    std::fill(row, row + first, padding);
    if (pass.stride == 1 && last > first)
        std::copy(in + (first + shift), in + (last + shift), row + first);
    else
        for (int q = first; q < last; ++q) row[q] = in[q * pass.stride + shift];
    std::fill(row + std::max(first, last), row + count, padding);
}

template <class Element>
void fill_phase(const Element* image, int height, int width, const Pass& pass, int py, int px,
                Element padding, const PhasePlanes<Element>& planes, Element* out) {
    for (int r = 0; r < planes.height; ++r, out += planes.width) {
        const int y = r * pass.stride + py - pass.top;
        if (y < 0 || y >= height)
            std::fill(out, out + planes.width, padding);
        else
            fill_row(image + static_cast<std::size_t>(y) * width, width, pass, px, padding, planes.width,
                     out);
    }
}

template <class Element>
PhasePlanes<Element> split_phases(const BasicTensor<Element>& input, int n, const Pass& pass, Element padding,
                                  const Runtime& runtime) {
    PhasePlanes<Element> planes;
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
    Element* const data = runtime.scratch<Element>(total + max_vector_width);
    planes.data = data;
    std::fill(data + total, data + total + max_vector_width, Element{});
    runtime.parallel_for(input.channels(), [&](int c) {
        Element* out = data + planes.channel * c;
        for (int py = 0; py < pass.stride; ++py)
            for (int px = 0; px < pass.stride; ++px, out += size)
                fill_phase(input.plane(n, c), input.height(), input.width(), pass, py, px, padding, planes,
                           out);
    });
    return planes;
}

// The input as the kernel reads it for one chunk of vectors.
template <class Element> struct Window {
    const Element* data;
    std::size_t plane; // elements from one channel to the next
    const std::ptrdiff_t *taps, *bases;
};

// A chunk reads a short stretch of every channel. Where the channels lie pages apart, the stretches are first
// copied to one place: all filters read them again and again, and neither the processor's address cache nor
// its prefetcher would follow from channel to channel.
template <class Element> class Gathered {
public:
    Window<Element> window(const PhasePlanes<Element>& planes, const std::vector<std::ptrdiff_t>& taps,
                           const std::ptrdiff_t* bases, int count, int width, int channels) {
        const Window<Element> direct = {planes.data, planes.channel, taps.data(), bases};
        if (taps.empty()) return direct; // a phase of a transposed convolution that no tap reaches
        const auto [nearest, farthest] = std::minmax_element(taps.begin(), taps.end());
        const std::ptrdiff_t begin = bases[0] + *nearest,
                             length = bases[count - 1] + *farthest + width - begin;
        if (planes.channel < apart || length * channels > cached_elements) return direct;
        // No stretch reaches beyond the scratch memory's spare elements behind the last plane.
        values_ = std::make_unique_for_overwrite<Element[]>(static_cast<std::size_t>(length * channels));
        for (int c = 0; c < channels; ++c)
            std::copy_n(planes.data + planes.channel * c + begin, length, values_.get() + length * c);
        for (const std::ptrdiff_t tap : taps) taps_.push_back(tap - *nearest);
        for (int v = 0; v < count; ++v) bases_.push_back(bases[v] - bases[0]);
        return {values_.get(), static_cast<std::size_t>(length), taps_.data(), bases_.data()};
    }

private:
    static constexpr std::size_t apart = 512; // elements

    std::unique_ptr<Element[]> values_;
    std::vector<std::ptrdiff_t> taps_, bases_;
};

// Calls visit(lane, count, place) for the runs of a vector's lanes that are outputs: lanes lane … lane +
// count − 1 go to place, place + step, … of the plane of the output.
template <class Visit>
void visit_runs(std::ptrdiff_t base, int width, bool by_row, int plane_width, const Pass& pass, int out_width,
                Visit visit) {
    int y = static_cast<int>(base / plane_width), x = static_cast<int>(base % plane_width);
    for (int lane = 0; lane < width && y < pass.out_height;) {
        const int count = std::min(width - lane, std::max(0, pass.out_width - x));
        visit(lane, count,
              (static_cast<std::size_t>(y) * pass.step + pass.row) * out_width +
                  static_cast<std::size_t>(x) * pass.step + pass.column);
        if (by_row) return;
        lane += plane_width - x; // the next row starts there
        x = 0;
        ++y;
    }
}

// Copies `count` elements to every step-th place.
template <class Element> void spread(const Element* values, int count, int step, Element* out) {
    if (step == 1)
        std::copy(values, values + count, out);
    else
        for (int i = 0; i < count; ++i) out[static_cast<std::size_t>(i) * step] = values[i];
}

} // namespace pantin::network
