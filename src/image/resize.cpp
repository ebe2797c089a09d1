// SPDX-License-Identifier: MIT
// Separable resizing, the columns of every row first, then the rows. Per axis: area average when it shrinks
// (exact overlap of the pixels' squares), bilinear when it grows.
#include "pantin/image.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

// Which source pixels make one target pixel, and with which weights.
struct Taps {
    int first = 0;
    std::vector<double> weights;
    double sum = 0;
};

std::vector<Taps> make_taps(int source, int target) {
    std::vector<Taps> taps(static_cast<std::size_t>(target));
    for (int i = 0; i < target; ++i) {
        Taps& tap = taps[i];
        if (target < source) {
            // In units of 1/target source pixels: source pixel j covers [j·target, (j+1)·target).
            const std::int64_t begin = static_cast<std::int64_t>(i) * source, end = begin + source;
            tap.first = static_cast<int>(begin / target);
            for (std::int64_t j = tap.first; j * target < end; ++j)
                tap.weights.push_back(
                    static_cast<double>(std::min(end, (j + 1) * target) - std::max(begin, j * target)));
        } else {
            const double centre = (i + 0.5) * source / target - 0.5;
            const double low = std::floor(centre), t = centre - low;
            const int a = std::clamp(static_cast<int>(low), 0, source - 1);
            const int b = std::clamp(static_cast<int>(low) + 1, 0, source - 1);
            tap.first = a;
            tap.weights = a == b || t == 0 ? std::vector<double>{1.0} : std::vector<double>{1 - t, t};
        }
        for (double weight : tap.weights) tap.sum += weight;
    }
    return taps;
}

// Index of the source pixel under the centre of target pixel i.
int nearest_index(int i, int source, int target) {
    return static_cast<int>((std::int64_t{2} * i + 1) * source / (std::int64_t{2} * target));
}

Grid<float> resize_rows(const Grid<float>& image, int width) {
    const std::vector<Taps> taps = make_taps(image.width(), width);
    Grid<float> out(width, image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const Taps& tap = taps[x];
            const float* in = image.row(y) + tap.first;
            double sum = 0;
            for (std::size_t k = 0; k < tap.weights.size(); ++k) sum += tap.weights[k] * in[k];
            out(x, y) = static_cast<float>(sum / tap.sum);
        }
    }
    return out;
}

Grid<float> resize_columns(const Grid<float>& image, int height) {
    const std::vector<Taps> taps = make_taps(image.height(), height);
    const int width = image.width();
    Grid<float> out(width, height);
    std::vector<double> sum(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        const Taps& tap = taps[y];
        std::fill(sum.begin(), sum.end(), 0.0);
        for (std::size_t k = 0; k < tap.weights.size(); ++k) {
            const float* in = image.row(tap.first + static_cast<int>(k));
            for (int x = 0; x < width; ++x) sum[x] += tap.weights[k] * in[x];
        }
        float* to = out.row(y);
        for (int x = 0; x < width; ++x) to[x] = static_cast<float>(sum[x] / tap.sum);
    }
    return out;
}

// Overlaps of target pixel i with source pixels, in whole units; nearest pixel when the axis grows.
struct Overlap {
    int first = 0;
    std::vector<std::int64_t> lengths;
    std::int64_t sum = 0;
};
std::vector<Overlap> make_overlaps(int source, int target) {
    std::vector<Overlap> overlaps(static_cast<std::size_t>(target));
    for (int i = 0; i < target; ++i) {
        Overlap& o = overlaps[i];
        if (target >= source) {
            o = {nearest_index(i, source, target), {1}, 1};
            continue;
        }
        const std::int64_t begin = static_cast<std::int64_t>(i) * source, end = begin + source;
        o.first = static_cast<int>(begin / target);
        for (std::int64_t j = o.first; j * target < end; ++j)
            o.lengths.push_back(std::min(end, (j + 1) * target) - std::max(begin, j * target));
        o.sum = source;
    }
    return overlaps;
}

void require_size(int width, int height) {
    if (width < 1 || height < 1) throw Error(ErrorKind::internal, "an image cannot be resized to nothing");
}

} // namespace

Grid<float> resize(const Grid<float>& image, int width, int height) {
    require_size(width, height);
    return resize_columns(resize_rows(image, width), height);
}

RgbImage resize(const RgbImage& image, int width, int height) {
    require_size(width, height);
    RgbImage out(width, height);
    Grid<float> channel(image.width(), image.height());
    for (std::uint8_t Rgb8::*member : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
        for (std::size_t i = 0; i < image.size(); ++i) channel.data()[i] = image.data()[i].*member;
        const Grid<float> small = resize(channel, width, height);
        for (std::size_t i = 0; i < out.size(); ++i)
            out.data()[i].*member = static_cast<std::uint8_t>(std::floor(small.data()[i] + 0.5f));
    }
    return out;
}

Mask resize_mask(const Mask& mask, int width, int height) {
    require_size(width, height);
    const std::vector<Overlap> columns = make_overlaps(mask.width(), width);
    const std::vector<Overlap> rows = make_overlaps(mask.height(), height);
    Mask out(width, height);
    Grid<std::int64_t> covered(width, 1);
    for (int y = 0; y < height; ++y) {
        const Overlap& row = rows[y];
        std::fill(covered.begin(), covered.end(), std::int64_t{0});
        for (std::size_t k = 0; k < row.lengths.size(); ++k) {
            const std::uint8_t* in = mask.row(row.first + static_cast<int>(k));
            for (int x = 0; x < width; ++x) {
                std::int64_t length = 0;
                for (std::size_t l = 0; l < columns[x].lengths.size(); ++l)
                    length += columns[x].lengths[l] * in[columns[x].first + static_cast<int>(l)];
                covered(x, 0) += length * row.lengths[k];
            }
        }
        for (int x = 0; x < width; ++x) out(x, y) = 2 * covered(x, 0) >= columns[x].sum * row.sum;
    }
    return out;
}

LabelMap resize_nearest(const LabelMap& labels, int width, int height) {
    require_size(width, height);
    LabelMap out(width, height);
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* in = labels.row(nearest_index(y, labels.height(), height));
        for (int x = 0; x < width; ++x) out(x, y) = in[nearest_index(x, labels.width(), width)];
    }
    return out;
}

} // namespace pantin
