// SPDX-License-Identifier: MIT
// What of a page is bare paper: shading correction of documents by blocks, in colour. The block size and its
// percentile are ours; that shading changes slowly and print does not is the usual assumption (e.g. Lins et
// al. 2007).
#include "image/paper.hpp"

#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"

namespace pantin {

float brightness(const Colour& c) { return 0.299f * c[0] + 0.587f * c[1] + 0.114f * c[2]; }

namespace {

constexpr int min_block = 8;        // px; a block holds a pen stroke and paper beside it
constexpr int blocks_per_side = 64; // along the longer side at most
constexpr int paper_percent = 80;   // percentile of a block's brightness that counts as its paper
constexpr int ground_percent = 50;  // the same where it is not known yet which of the two is lighter

// Steps between neighbouring blocks of one paper: brightness may fall to this share (or rise by it), and each
// channel's share of the brightness may change by this much.
constexpr float shadow_step = 0.9f, shadow_tint = 0.04f;
// A block that no such steps lead to (inside of a thick outline, beyond the edge of a hard shadow) is bare if
// it is like the paper around it: no darker than this share, no other tint.
constexpr float shadow_depth = 0.7f, same_tint = 0.06f;
constexpr float even_depth = 0.97f; // … on a page without light and grain, where a light grey is a fill
constexpr float even_grain = 0.5f;  // of 255; noise of a bare block below this is none

constexpr long edge_weight = 8;        // what a block at the page's border counts: figures rarely reach it
constexpr float lightest_ground = 170; // brighter paper is paper, whatever is on it
constexpr float clear_contrast = 25;   // of 255; less than this is noise and shade
constexpr double most_drawn = 0.4;     // of the page may be lighter than its ground: beyond, it is a sheet

int block_size(int width, int height) {
    return std::max(min_block, (std::max(width, height) + blocks_per_side - 1) / blocks_per_side);
}

// Calls visit(colour, brightness) for the block's pixels.
template <class Visit>
void for_each_pixel(const RgbImage& page, const GreyImage& grey, int block, int bx, int by, Visit visit) {
    const int end = std::min(page.width(), (bx + 1) * block);
    for (int y = by * block; y < std::min(page.height(), (by + 1) * block); ++y) {
        const Rgb8* const colours = page.row(y);
        const std::uint8_t* const values = grey.row(y);
        for (int x = bx * block; x < end; ++x) visit(colours[x], values[x]);
    }
}

// The value of the block at that percentile of brightness, in the mean tint of the pixels that are about as
// bright: one pixel's colour is noise.
Colour percentile_colour(const RgbImage& page, const GreyImage& grey, int block, int bx, int by,
                         int percent) {
    std::array<int, 256> histogram{};
    int count = 0;
    for_each_pixel(page, grey, block, bx, by, [&](Rgb8, int level) { ++histogram[level], ++count; });
    int value = 0;
    for (int below = histogram[0]; 100 * below < percent * count; below += histogram[value]) ++value;
    std::array<long, 3> sum{};
    long total = 0;
    for_each_pixel(page, grey, block, bx, by, [&](Rgb8 p, int level) {
        if (std::abs(level - value) > 4) return;
        sum[0] += p.r, sum[1] += p.g, sum[2] += p.b;
        total += level;
    });
    const auto level = static_cast<float>(value);
    if (total == 0) return {level, level, level};
    const auto scaled = [&](long s) { return level * static_cast<float>(s) / static_cast<float>(total); };
    return {scaled(sum[0]), scaled(sum[1]), scaled(sum[2])};
}

Grid<Colour> block_colours(const RgbImage& page, const GreyImage& grey, int block, int percent) {
    Grid<Colour> colours((page.width() + block - 1) / block, (page.height() + block - 1) / block);
    for (int y = 0; y < colours.height(); ++y)
        for (int x = 0; x < colours.width(); ++x)
            colours(x, y) = percentile_colour(page, grey, block, x, y, percent);
    return colours;
}

// Largest change of a channel's share of the brightness.
float tint_change(const Colour& a, const Colour& b) {
    const float la = std::max(1.0f, brightness(a)), lb = std::max(1.0f, brightness(b));
    float most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a[k] / la - b[k] / lb));
    // In the dark a step of a few levels is a large share.
    return most * std::min(1.0f, std::min(la, lb) / 64);
}

bool leads_on(const Colour& from, const Colour& to) {
    const float a = brightness(from), b = brightness(to), slack = 2;
    return b + slack >= shadow_step * a && a + slack >= shadow_step * b &&
           tint_change(from, to) <= shadow_tint;
}

// Numbers the regions of blocks that lead on to each other (8-neighbours).
Grid<int> regions_of(const Grid<Colour>& colours, int& count) {
    Grid<int> region(colours.width(), colours.height(), -1);
    count = 0;
    std::vector<Point2i> front;
    for (int y0 = 0; y0 < colours.height(); ++y0)
        for (int x0 = 0; x0 < colours.width(); ++x0) {
            if (region(x0, y0) >= 0) continue;
            region(x0, y0) = count;
            front.push_back({x0, y0});
            while (!front.empty()) {
                const Point2i p = front.back();
                front.pop_back();
                for (int y = p.y - 1; y <= p.y + 1; ++y)
                    for (int x = p.x - 1; x <= p.x + 1; ++x) {
                        if (region.value_or(x, y, 0) >= 0 || !leads_on(colours(p.x, p.y), colours(x, y)))
                            continue;
                        region(x, y) = count;
                        front.push_back({x, y});
                    }
            }
            ++count;
        }
    return region;
}

// The region with most blocks, those of the border counting more; the brighter one of equals.
Mask ground_of(const Grid<Colour>& colours) {
    int count = 0;
    const Grid<int> region = regions_of(colours, count);
    std::vector<std::pair<long, double>> score(static_cast<std::size_t>(count)); // blocks, brightness
    for (int y = 0; y < region.height(); ++y)
        for (int x = 0; x < region.width(); ++x) {
            const bool edge = x == 0 || y == 0 || x == region.width() - 1 || y == region.height() - 1;
            auto& [blocks, light] = score[static_cast<std::size_t>(region(x, y))];
            blocks += edge ? edge_weight : 1;
            light += static_cast<double>(brightness(colours(x, y)));
        }
    const auto best = std::max_element(score.begin(), score.end()) - score.begin();
    Mask ground(region.width(), region.height());
    std::transform(region.begin(), region.end(), ground.begin(),
                   [&](int r) -> std::uint8_t { return r == best; });
    return ground;
}

// Every block that is not in the mask takes the colour of the nearest one that is.
Grid<Colour> continued(const Grid<Colour>& colours, const Mask& known) {
    const Grid<int> nearest = nearest_seed(known);
    Grid<Colour> out = colours;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (nearest.data()[i] >= 0) out.data()[i] = colours.data()[nearest.data()[i]];
    return out;
}

// Binomial 3×3 mean, cut at the border by repeating the edge. Sums of 16 values: exact when all are equal.
Grid<Colour> smooth(const Grid<Colour>& in) {
    Grid<Colour> out(in.width(), in.height());
    for (int y = 0; y < in.height(); ++y)
        for (int x = 0; x < in.width(); ++x)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto at = [&](int dx, int dy) {
                    return in(std::clamp(x + dx, 0, in.width() - 1),
                              std::clamp(y + dy, 0, in.height() - 1))[k];
                };
                out(x, y)[k] = (4 * at(0, 0) + 2 * (at(-1, 0) + at(1, 0) + at(0, -1) + at(0, 1)) +
                                at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1)) /
                               16;
            }
    return out;
}

// Median over the bare blocks of the mean difference between horizontal neighbours.
float grain_of(const GreyImage& grey, int block, const Mask& bare) {
    std::vector<float> grain;
    for (int by = 0; by < bare.height(); ++by)
        for (int bx = 0; bx < bare.width(); ++bx) {
            if (!bare(bx, by)) continue;
            long sum = 0, count = 0;
            for (int y = by * block; y < std::min(grey.height(), (by + 1) * block); ++y)
                for (int x = bx * block + 1; x < std::min(grey.width(), (bx + 1) * block); ++x)
                    sum += std::abs(grey(x, y) - grey(x - 1, y)), ++count;
            if (count > 0) grain.push_back(static_cast<float>(sum) / static_cast<float>(count));
        }
    if (grain.empty()) return even_grain;
    const auto middle = grain.begin() + static_cast<std::ptrdiff_t>(grain.size() / 2);
    std::nth_element(grain.begin(), middle, grain.end());
    return *middle;
}

} // namespace

Paper estimate_paper(const RgbImage& page) {
    const GreyImage grey = greyscale(page);
    Paper paper;
    paper.block = block_size(page.width(), page.height());
    Grid<Colour> colours = block_colours(page, grey, paper.block, paper_percent);
    paper.bare = ground_of(colours);
    paper.grain = grain_of(grey, paper.block, paper.bare);
    paper.even = paper.grain < even_grain;
    const Grid<Colour> around = continued(colours, paper.bare);
    const float depth = paper.even ? even_depth : shadow_depth;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const Colour &own = colours.data()[i], &near = around.data()[i];
        paper.bare.data()[i] |= brightness(own) >= depth * brightness(near) &&
                                depth * brightness(own) <= brightness(near) &&
                                tint_change(own, near) <= same_tint;
    }
    colours = continued(colours, paper.bare);
    for (Colour& c : colours)
        for (float& channel : c) channel = std::max(channel, 1.0f);
    paper.colours = smooth(colours);
    return paper;
}

bool is_light_on_dark(const RgbImage& page) {
    const GreyImage grey = greyscale(page);
    const int block = block_size(page.width(), page.height());
    const Grid<Colour> colours = block_colours(page, grey, block, ground_percent);
    const Grid<Colour> ground = continued(colours, ground_of(colours));
    double lighter = 0, darker = 0, level = 0;
    long light_pixels = 0;
    for (int y = 0; y < page.height(); ++y)
        for (int x = 0; x < page.width(); ++x) {
            const float paper = brightness(ground(x / block, y / block));
            const float difference = static_cast<float>(grey(x, y)) - paper;
            light_pixels += difference > clear_contrast;
            lighter += static_cast<double>(std::max(0.0f, difference - clear_contrast));
            darker += static_cast<double>(std::max(0.0f, -difference - clear_contrast));
            level += static_cast<double>(paper);
        }
    const auto pixels = static_cast<double>(page.size());
    return level < static_cast<double>(lightest_ground) * pixels && lighter > darker &&
           static_cast<double>(light_pixels) <= most_drawn * pixels;
}

std::vector<Colour> paper_row(const Paper& paper, int y, int width) {
    const int block = paper.block;
    struct Place {
        int low, high;
        float t;
    };
    // Bilinear between block centres; in halves of a pixel from the first centre.
    const auto place = [&](int pixel, int blocks) -> Place {
        const int twice = std::clamp(2 * pixel + 1 - block, 0, 2 * block * (blocks - 1));
        const int low = twice / (2 * block);
        return {low, std::min(low + 1, blocks - 1),
                static_cast<float>(twice - 2 * block * low) / static_cast<float>(2 * block)};
    };
    const Place row = place(y, paper.colours.height());
    std::vector<Colour> blended(static_cast<std::size_t>(paper.colours.width()));
    for (int k = 0; k < paper.colours.width(); ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            const float upper = paper.colours(k, row.low)[c], lower = paper.colours(k, row.high)[c];
            blended[static_cast<std::size_t>(k)][c] = upper + row.t * (lower - upper);
        }
    std::vector<Colour> result(static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x) {
        const Place column = place(x, paper.colours.width());
        const Colour &a = blended[static_cast<std::size_t>(column.low)],
                     &b = blended[static_cast<std::size_t>(column.high)];
        for (std::size_t c = 0; c < 3; ++c)
            result[static_cast<std::size_t>(x)][c] = a[c] + column.t * (b[c] - a[c]);
    }
    return result;
}

} // namespace pantin
