// SPDX-License-Identifier: MIT
// Places of taps and vectors (pass.hpp says how). Ours.
#include "network/pass.hpp"

namespace pantin::network {

std::vector<std::ptrdiff_t> tap_offsets(const Pass& pass, int plane_height, int plane_width) {
    std::vector<std::ptrdiff_t> offsets;
    for (const Tap& tap : pass.taps) {
        const int phase = tap.dy % pass.stride * pass.stride + tap.dx % pass.stride;
        offsets.push_back((static_cast<std::ptrdiff_t>(phase) * plane_height + tap.dy / pass.stride) *
                              plane_width +
                          tap.dx / pass.stride);
    }
    return offsets;
}

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

int chunk_size(int channels, int width) {
    return std::clamp(static_cast<int>(cached_elements / (std::ptrdiff_t{channels} * width)), 4,
                      vectors_per_task);
}

} // namespace pantin::network
