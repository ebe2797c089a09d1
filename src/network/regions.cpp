// SPDX-License-Identifier: MIT
// Boxes and pooled regions: overlap, suppression (Girshick et al. 2014), RoIAlign (He et al. 2017, Fig. 3).
#include "network/regions.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace pantin::network {
namespace {

struct Neighbours {
    int low = 0, high = 0;
    float fraction = 0; // of `high`
};
Neighbours neighbours(float position, int extent) {
    if (position <= 0) position = 0;
    const int low = static_cast<int>(position);
    if (low >= extent - 1) return {extent - 1, extent - 1, 0};
    return {low, low + 1, position - static_cast<float>(low)};
}

RegionSample sample_at(float x, float y, int width, int height) {
    RegionSample sample;
    if (!(y >= -1 && y <= static_cast<float>(height) && x >= -1 && x <= static_cast<float>(width)))
        return sample;
    const Neighbours v = neighbours(y, height), h = neighbours(x, width);
    const auto index = [&](int row, int column) { return static_cast<std::size_t>(row) * width + column; };
    const float below = v.fraction, above = 1 - below, right = h.fraction, left = 1 - right;
    return {{index(v.low, h.low), index(v.low, h.high), index(v.high, h.low), index(v.high, h.high)},
            {above * left, above * right, below * left, below * right}};
}

} // namespace

std::vector<RegionSample> samples_of(const Region& region, float scale, int size, int sampling, int width,
                                     int height) {
    const float x0 = region.left * scale, y0 = region.top * scale;
    const float bin_width = std::max(region.right * scale - x0, 1.0f) / static_cast<float>(size);
    const float bin_height = std::max(region.bottom * scale - y0, 1.0f) / static_cast<float>(size);
    const auto place = [&](float start, float bin, int number, int sample) {
        return start + static_cast<float>(number) * bin +
               (static_cast<float>(sample) + 0.5f) * bin / static_cast<float>(sampling);
    };
    std::vector<RegionSample> samples;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            for (int i = 0; i < sampling; ++i)
                for (int j = 0; j < sampling; ++j)
                    samples.push_back(sample_at(place(x0, bin_width, column, j),
                                                place(y0, bin_height, row, i), width, height));
    return samples;
}

float overlap(const Region& a, const Region& b) {
    const float width = std::max(0.0f, std::min(a.right, b.right) - std::max(a.left, b.left));
    const float height = std::max(0.0f, std::min(a.bottom, b.bottom) - std::max(a.top, b.top));
    const float both = width * height;
    return both / (area(a) + area(b) - both);
}

std::vector<int> non_maximum_suppression(const std::vector<Region>& boxes, const std::vector<float>& scores,
                                         const std::vector<int>& groups, float threshold) {
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return scores[a] > scores[b]; });
    std::vector<int> kept;
    std::map<int, std::vector<int>> kept_of; // group → its boxes that stay
    for (const int candidate : order) {
        std::vector<int>& rivals = kept_of[groups[candidate]];
        const bool covered = std::any_of(rivals.begin(), rivals.end(), [&](int rival) {
            return overlap(boxes[rival], boxes[candidate]) > threshold;
        });
        if (covered) continue;
        rivals.push_back(candidate);
        kept.push_back(candidate);
    }
    return kept;
}

void roi_align(const Tensor& features, const std::vector<Region>& regions, const std::vector<int>& rows,
               float scale, int sampling, const Runtime& runtime, Tensor& output) {
    const int size = output.height();
    const std::size_t bins = static_cast<std::size_t>(size) * size;
    const std::size_t per_bin = static_cast<std::size_t>(sampling) * sampling;
    runtime.parallel_for(static_cast<int>(regions.size()), [&](int r) {
        const std::vector<RegionSample> samples = samples_of(
            regions[static_cast<std::size_t>(r)], scale, size, sampling, features.width(), features.height());
        for (int c = 0; c < features.channels(); ++c) {
            const float* plane = features.plane(0, c);
            float* bin = output.plane(rows[static_cast<std::size_t>(r)], c);
            for (std::size_t b = 0; b < bins; ++b) {
                float sum = 0;
                for (std::size_t s = b * per_bin; s < (b + 1) * per_bin; ++s)
                    sum += samples[s].weight[0] * plane[samples[s].at[0]] +
                           samples[s].weight[1] * plane[samples[s].at[1]] +
                           samples[s].weight[2] * plane[samples[s].at[2]] +
                           samples[s].weight[3] * plane[samples[s].at[3]];
                bin[b] = sum / static_cast<float>(per_bin);
            }
        }
    });
}

namespace {

// Four channels at once, in a vector of gcc and clang.
using Four = float __attribute__((vector_size(16)));

Four channels_of(std::uint32_t word, float zero) {
    return Four{static_cast<float>(word & 255), static_cast<float>(word >> 8 & 255),
                static_cast<float>(word >> 16 & 255), static_cast<float>(word >> 24)} -
           zero;
}

} // namespace

void roi_align(const integer::ByteTensor& features, const std::vector<Region>& regions,
               const std::vector<int>& rows, float scale, int sampling, std::uint8_t zero,
               const Runtime& runtime, integer::ByteTensor& output) {
    const int size = output.height();
    const std::size_t bins = static_cast<std::size_t>(size) * size;
    const std::size_t per_bin = static_cast<std::size_t>(sampling) * sampling;
    const auto z = static_cast<float>(zero);
    runtime.parallel_for(static_cast<int>(regions.size()), [&](int r) {
        const std::vector<RegionSample> samples = samples_of(
            regions[static_cast<std::size_t>(r)], scale, size, sampling, features.width(), features.height());
        for (int w = 0; w < features.words.channels(); ++w) {
            const std::uint32_t* plane = features.words.plane(0, w);
            std::uint32_t* bin = output.words.plane(rows[static_cast<std::size_t>(r)], w);
            for (std::size_t b = 0; b < bins; ++b) {
                Four sum = {0, 0, 0, 0};
                for (std::size_t s = b * per_bin; s < (b + 1) * per_bin; ++s)
                    sum += samples[s].weight[0] * channels_of(plane[samples[s].at[0]], z) +
                           samples[s].weight[1] * channels_of(plane[samples[s].at[1]], z) +
                           samples[s].weight[2] * channels_of(plane[samples[s].at[2]], z) +
                           samples[s].weight[3] * channels_of(plane[samples[s].at[3]], z);
                std::uint32_t word = 0;
                for (int k = 0; k < 4; ++k) {
                    const float mean = sum[k] / static_cast<float>(per_bin) + z + 0.5f;
                    word |= static_cast<std::uint32_t>(std::clamp(mean, 0.0f, 255.0f)) << (8 * k);
                }
                bin[b] = word;
            }
        }
    });
}

} // namespace pantin::network
