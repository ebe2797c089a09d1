// SPDX-License-Identifier: MIT
// Median cut (Heckbert, Color image quantization for frame buffer display, 1982) on a histogram with 6 bits a
// channel. Departures: the box with the largest weighted variance is split next, at its mean, because
// drawings are mostly paper and the few ink colours must not be crowded out. Everything is integer
// arithmetic; ties go to the first box and to the order red, green, blue.
#include "export/palette.hpp"

#include <algorithm>
#include <array>

namespace pantin {

namespace {

constexpr int bin_count = 1 << 18;

std::size_t bin_of(int r, int g, int b) {
    return static_cast<std::size_t>(r >> 2 << 12 | g >> 2 << 6 | b >> 2);
}

struct Bin {
    std::size_t index = 0;
    std::int64_t count = 0;
    std::array<std::int64_t, 3> sum{};
    std::array<int, 3> mean{};
};

std::vector<Bin> histogram(const std::vector<RgbaImage>& frames) {
    std::vector<Bin> all(bin_count);
    for (const RgbaImage& frame : frames)
        for (const Rgba8 c : frame) {
            if (c.a < opaque_alpha) continue;
            Bin& bin = all[bin_of(c.r, c.g, c.b)];
            ++bin.count;
            bin.sum[0] += c.r;
            bin.sum[1] += c.g;
            bin.sum[2] += c.b;
        }
    std::vector<Bin> used;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].count == 0) continue;
        all[i].index = i;
        for (std::size_t c = 0; c < 3; ++c) all[i].mean[c] = static_cast<int>(all[i].sum[c] / all[i].count);
        used.push_back(all[i]);
    }
    return used;
}

// A box of bins [begin, end) of the histogram, with its widest channel and the squared spread along it.
struct Box3 {
    std::size_t begin = 0, end = 0;
    std::size_t channel = 0;
    std::int64_t spread = 0; // Σ count · (value − mean)²
    std::int64_t mean = 0;   // of that channel
};

Box3 measure(const std::vector<Bin>& bins, std::size_t begin, std::size_t end) {
    Box3 box{begin, end, 0, -1, 0};
    for (std::size_t c = 0; c < 3; ++c) {
        std::int64_t count = 0, sum = 0, spread = 0;
        for (std::size_t i = begin; i < end; ++i) {
            count += bins[i].count;
            sum += bins[i].count * bins[i].mean[c];
        }
        const std::int64_t mean = sum / count;
        for (std::size_t i = begin; i < end; ++i) {
            const std::int64_t d = bins[i].mean[c] - mean;
            spread += bins[i].count * d * d;
        }
        if (spread > box.spread) box = {begin, end, c, spread, mean};
    }
    return box;
}

// Cuts the box at its mean; both halves are non-empty because the spread is positive.
std::size_t cut(std::vector<Bin>& bins, const Box3& box) {
    const auto first = bins.begin() + static_cast<long>(box.begin),
               last = bins.begin() + static_cast<long>(box.end);
    const auto middle =
        std::stable_partition(first, last, [&](const Bin& bin) { return bin.mean[box.channel] <= box.mean; });
    return static_cast<std::size_t>(middle - bins.begin());
}

Rgb8 average(const std::vector<Bin>& bins, const Box3& box) {
    std::int64_t count = 0;
    std::array<std::int64_t, 3> sum{};
    for (std::size_t i = box.begin; i < box.end; ++i) {
        count += bins[i].count;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += bins[i].sum[c];
    }
    const auto mean = [&](std::size_t c) {
        return static_cast<std::uint8_t>((2 * sum[c] + count) / (2 * count));
    };
    return {mean(0), mean(1), mean(2)};
}

std::uint8_t nearest(const std::vector<Rgb8>& colours, const std::array<int, 3>& value) {
    std::size_t best = 0;
    int least = 1 << 30;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const int dr = colours[i].r - value[0], dg = colours[i].g - value[1], db = colours[i].b - value[2];
        const int distance = dr * dr + dg * dg + db * db;
        if (distance < least) {
            least = distance;
            best = i;
        }
    }
    return static_cast<std::uint8_t>(best);
}

} // namespace

Palette::Palette(const std::vector<RgbaImage>& frames, int size) : entry_of_bin_(bin_count, 0) {
    std::vector<Bin> bins = histogram(frames);
    std::vector<Box3> boxes;
    if (!bins.empty()) boxes.push_back(measure(bins, 0, bins.size()));
    while (!boxes.empty() && boxes.size() < static_cast<std::size_t>(size)) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](auto& a, auto& b) { return a.spread < b.spread; });
        if (widest->spread <= 0) break;
        const Box3 box = *widest;
        const std::size_t middle = cut(bins, box);
        if (middle == box.end || middle == box.begin) break;
        *widest = measure(bins, box.begin, middle);
        boxes.push_back(measure(bins, middle, box.end));
    }
    for (const Box3& box : boxes) colours_.push_back(average(bins, box));
    for (const Bin& bin : bins) entry_of_bin_[bin.index] = nearest(colours_, bin.mean);
}

std::uint8_t Palette::index_of(Rgba8 colour) const {
    return entry_of_bin_[bin_of(colour.r, colour.g, colour.b)];
}

} // namespace pantin
