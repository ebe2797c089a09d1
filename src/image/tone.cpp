// SPDX-License-Identifier: MIT
// Brightness to ink. Local thresholds and a local estimate of the paper's brightness, so that shadows and
// yellow paper of a phone photo do not become ink. Based on: P. D. Wellner, Adaptive Thresholding for the
// DigitalDesk, 1993 (darker than the local mean by a margin); the paper's estimate is a morphological closing
// of block percentiles, as in shading correction of documents.
#include <algorithm>
#include <array>

#include "pantin/image.hpp"

namespace pantin {

namespace {

// --- the paper's brightness --------------------------------------------------------------------------------

constexpr int min_block = 8;        // px; a block holds a pen stroke and paper beside it
constexpr int blocks_per_side = 64; // along the longer side at most
constexpr int paper_percent = 80;   // percentile of a block that counts as its paper
constexpr float fill_ratio = 0.7f;  // a block darker than this share of the closed paper is a filled area
constexpr float shadow_step = 0.9f; // … unless it is brighter than this share of a neighbour that is paper
constexpr float dark_pixel = 0.15f; // pixels darker than this count as strokes …
constexpr int dark_percent = 95;    // … and this percentile of them becomes 1
constexpr float min_dark_level = 0.25f; // faint pencil is raised at most fourfold
constexpr int darkness_bins = 1024;

Grid<float> block_percentiles(const GreyImage& grey, int block) {
    const int columns = (grey.width() + block - 1) / block, rows = (grey.height() + block - 1) / block;
    Grid<float> paper(columns, rows);
    for (int by = 0; by < rows; ++by) {
        for (int bx = 0; bx < columns; ++bx) {
            std::array<int, 256> histogram{};
            int count = 0;
            for (int y = by * block; y < std::min(grey.height(), (by + 1) * block); ++y)
                for (int x = bx * block; x < std::min(grey.width(), (bx + 1) * block); ++x, ++count)
                    ++histogram[grey(x, y)];
            int value = 0;
            for (int below = histogram[0]; 100 * below < paper_percent * count; below += histogram[value])
                ++value;
            paper(bx, by) = static_cast<float>(value);
        }
    }
    return paper;
}

// Largest (or smallest) value of the (2·radius+1)² window, cut at the border.
template <class Better> Grid<float> window_extreme(const Grid<float>& in, int radius, Better better) {
    Grid<float> rows = in, out = in;
    for (int y = 0; y < in.height(); ++y)
        for (int x = 0; x < in.width(); ++x)
            for (int k = std::max(0, x - radius); k <= std::min(in.width() - 1, x + radius); ++k)
                rows(x, y) = better(rows(x, y), in(k, y));
    out = rows;
    for (int y = 0; y < in.height(); ++y)
        for (int k = std::max(0, y - radius); k <= std::min(in.height() - 1, y + radius); ++k)
            for (int x = 0; x < in.width(); ++x) out(x, y) = better(out(x, y), rows(x, k));
    return out;
}

// Binomial 3×3 mean, cut at the border by repeating the edge. Sums of 16 values: exact when all are equal.
Grid<float> smooth(const Grid<float>& in) {
    Grid<float> out(in.width(), in.height());
    const auto at = [&](int x, int y) {
        return in(std::clamp(x, 0, in.width() - 1), std::clamp(y, 0, in.height() - 1));
    };
    for (int y = 0; y < in.height(); ++y)
        for (int x = 0; x < in.width(); ++x)
            out(x, y) = (4 * at(x, y) + 2 * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1)) +
                         at(x - 1, y - 1) + at(x + 1, y - 1) + at(x - 1, y + 1) + at(x + 1, y + 1)) /
                        16;
    return out;
}

// Adds to `paper` every block that is at most a small step darker than a neighbour in it: shadows fall off
// smoothly, filled areas begin with an edge. Repeated until nothing changes, so the order of the blocks does
// not matter.
void grow_along_shadows(const Grid<float>& brightness, Mask& paper) {
    std::vector<Point2i> front;
    for (int y = 0; y < paper.height(); ++y)
        for (int x = 0; x < paper.width(); ++x)
            if (paper(x, y)) front.push_back({x, y});
    while (!front.empty()) {
        const Point2i p = front.back();
        front.pop_back();
        for (int y = p.y - 1; y <= p.y + 1; ++y) {
            for (int x = p.x - 1; x <= p.x + 1; ++x) {
                if (paper.value_or(x, y, 1) || brightness(x, y) < shadow_step * brightness(p.x, p.y))
                    continue;
                paper(x, y) = 1;
                front.push_back({x, y});
            }
        }
    }
}

// Paper brightness per block, at least 1. A closing over half the picture lifts dark areas up to that size to
// the paper around them; it counts where a block is no paper. Blocks that are not much darker than it, or
// that lead into a shadow step by step, are paper and keep their own value.
Grid<float> paper_blocks(const GreyImage& grey, int block) {
    Grid<float> brightness = block_percentiles(grey, block);
    const int radius = std::max(1, std::max(brightness.width(), brightness.height()) / 2);
    const auto larger = [](float a, float b) { return std::max(a, b); };
    const auto smaller = [](float a, float b) { return std::min(a, b); };
    const Grid<float> closed = window_extreme(window_extreme(brightness, radius, larger), radius, smaller);
    Mask paper(brightness.width(), brightness.height());
    for (std::size_t i = 0; i < paper.size(); ++i)
        paper.data()[i] = brightness.data()[i] >= fill_ratio * closed.data()[i];
    grow_along_shadows(brightness, paper);
    for (std::size_t i = 0; i < paper.size(); ++i) {
        float& value = brightness.data()[i];
        if (!paper.data()[i]) value = closed.data()[i];
        value = std::max(value, 1.0f);
    }
    return smooth(brightness);
}

// Block index and weight of the next block for every pixel of an axis: bilinear between block centres.
struct Interpolation {
    int low = 0, high = 0;
    float t = 0;
};
std::vector<Interpolation> interpolations(int pixels, int blocks, int block) {
    std::vector<Interpolation> result(static_cast<std::size_t>(pixels));
    for (int i = 0; i < pixels; ++i) {
        const int twice = std::clamp(2 * i + 1 - block, 0, 2 * block * (blocks - 1)); // from the first centre
        const int low = twice / (2 * block);
        result[i] = {low, std::min(low + 1, blocks - 1),
                     static_cast<float>(twice - 2 * block * low) / static_cast<float>(2 * block)};
    }
    return result;
}

// 1 − grey / paper, clamped to [0, 1].
Grid<float> relative_darkness(const GreyImage& grey) {
    const int block =
        std::max(min_block, (std::max(grey.width(), grey.height()) + blocks_per_side - 1) / blocks_per_side);
    const Grid<float> paper = paper_blocks(grey, block);
    const std::vector<Interpolation> columns = interpolations(grey.width(), paper.width(), block);
    const std::vector<Interpolation> rows = interpolations(grey.height(), paper.height(), block);
    Grid<float> darkness(grey.width(), grey.height());
    std::vector<float> blended(static_cast<std::size_t>(paper.width()));
    for (int y = 0; y < grey.height(); ++y) {
        const float* upper = paper.row(rows[y].low);
        const float* lower = paper.row(rows[y].high);
        for (int k = 0; k < paper.width(); ++k) blended[k] = upper[k] + rows[y].t * (lower[k] - upper[k]);
        for (int x = 0; x < grey.width(); ++x) {
            const float a = blended[columns[x].low], b = blended[columns[x].high];
            const float local = a + columns[x].t * (b - a);
            darkness(x, y) = std::clamp(1 - static_cast<float>(grey(x, y)) / local, 0.0f, 1.0f);
        }
    }
    return darkness;
}

// The darkness of the darkest strokes: a percentile over the pixels that are not paper.
float dark_level(const Grid<float>& darkness) {
    std::array<std::int64_t, darkness_bins> histogram{};
    std::int64_t count = 0;
    for (float d : darkness) {
        if (d <= dark_pixel) continue;
        ++histogram[static_cast<int>(d * (darkness_bins - 1))];
        ++count;
    }
    if (count == 0) return min_dark_level;
    int bin = 0;
    for (std::int64_t below = histogram[0]; 100 * below < dark_percent * count; below += histogram[bin])
        ++bin;
    return std::max(min_dark_level, static_cast<float>(bin) / (darkness_bins - 1));
}

} // namespace

GreyImage greyscale(const RgbImage& image) {
    GreyImage grey(image.width(), image.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 p = image.data()[i];
        grey.data()[i] = static_cast<std::uint8_t>((299u * p.r + 587u * p.g + 114u * p.b + 500u) / 1000u);
    }
    return grey;
}

Mask adaptive_threshold(const GreyImage& image, int radius, int offset) {
    const int w = image.width(), h = image.height();
    Mask ink(w, h);
    std::vector<int> column(static_cast<std::size_t>(w), 0); // sums over the rows of the window
    const auto add_row = [&](int y, int sign) {
        const std::uint8_t* in = image.row(y);
        for (int x = 0; x < w; ++x) column[x] += sign * in[x];
    };
    for (int y = 0; y < std::min(radius, h); ++y) add_row(y, 1);
    for (int y = 0; y < h; ++y) {
        if (y + radius < h) add_row(y + radius, 1);
        if (y - radius - 1 >= 0) add_row(y - radius - 1, -1);
        const std::int64_t window_rows = std::min(h - 1, y + radius) - std::max(0, y - radius) + 1;
        std::int64_t sum = 0;
        for (int x = 0; x < std::min(radius, w); ++x) sum += column[x];
        for (int x = 0; x < w; ++x) {
            if (x + radius < w) sum += column[x + radius];
            if (x - radius - 1 >= 0) sum -= column[x - radius - 1];
            const std::int64_t count =
                window_rows * (std::min(w - 1, x + radius) - std::max(0, x - radius) + 1);
            ink(x, y) = (image(x, y) + offset) * count < sum;
        }
    }
    return ink;
}

Grid<float> ink_darkness(const RgbImage& image) {
    if (image.empty()) return {};
    Grid<float> darkness = relative_darkness(greyscale(image));
    const float level = dark_level(darkness);
    for (float& d : darkness) d = std::min(1.0f, d / level);
    return darkness;
}

} // namespace pantin
