// SPDX-License-Identifier: MIT
// What of a page is drawn, and how strongly: the distance of every pixel from the paper's colour. The one
// place that tells ink from paper; every later step sees its result.
#include <algorithm>
#include <array>

#include "image/paper.hpp"
#include "image/ruling.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

constexpr float dark_pixel = 0.15f;     // pixels darker than this count as strokes …
constexpr int dark_percent = 95;        // … and this percentile of them becomes 1
constexpr float min_dark_level = 0.25f; // faint pencil is raised at most fourfold
constexpr int darkness_bins = 1024;
constexpr float clear_stroke = 0.5f;   // pixels darker than this are strokes on a pale fill …
constexpr double stroke_share = 0.005; // … if they are so many of what is drawn

// Ink that is lighter than the paper (white on kraft) shows where the paper leaves room for it: on a ground
// whose channels are this far below white, and if it is as much ink as this share of the darker one.
constexpr float dull_paper = 200;
constexpr float light_ink = 0.5f;
constexpr double light_ink_share = 0.2;

// A filled area is at least this far from the paper, and this many times the paper's own noise.
constexpr float faintest_fill = 0.05f, fill_over_noise = 3;
constexpr float blur_contrast = 2;            // an edge at half of what is near it …
constexpr int blur_reach = 2;                 // … within so many pixels
constexpr float opaque_darkness = dark_pixel; // least of what is opaque on a page without paper

std::array<float, 3> channels(Rgb8 p) {
    return {static_cast<float>(p.r), static_cast<float>(p.g), static_cast<float>(p.b)};
}

// By how much a channel falls short of the paper, the largest of the three; 0 … 1.
float darker_by(Rgb8 pixel, const Colour& paper) {
    const std::array<float, 3> c = channels(pixel);
    float most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, 1 - std::max(1.0f, c[k]) / paper[k]);
    return most;
}

// The share of its way to white by which a channel exceeds the paper, the largest of the three; 0 … 1.
float lighter_by(Rgb8 pixel, const Colour& paper) {
    const std::array<float, 3> c = channels(pixel);
    float most = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (paper[k] <= dull_paper) most = std::max(most, (c[k] - paper[k]) / (255 - paper[k]));
    return most;
}

// Calls visit(pixel, paper, darkness) for every pixel of the page.
template <class Visit>
void for_each_pixel(const RgbImage& page, const Paper& paper, Grid<float>& darkness, const Visit& visit) {
    for (int y = 0; y < page.height(); ++y) {
        const std::vector<Colour> row = paper_row(paper, y, page.width());
        for (int x = 0; x < page.width(); ++x)
            visit(page(x, y), row[static_cast<std::size_t>(x)], darkness(x, y));
    }
}

// Distance from the paper, 0 … 1.
Grid<float> distance_from(const RgbImage& page, const Paper& paper) {
    Grid<float> distance(page.width(), page.height());
    long dark = 0, light = 0;
    for_each_pixel(page, paper, distance, [&](Rgb8 pixel, const Colour& p, float& d) {
        d = darker_by(pixel, p);
        dark += d >= light_ink;
        light += lighter_by(pixel, p) >= light_ink;
    });
    if (light == 0 || static_cast<double>(light) < light_ink_share * static_cast<double>(dark))
        return distance;
    for_each_pixel(page, paper, distance,
                   [](Rgb8 pixel, const Colour& p, float& d) { d = std::max(d, lighter_by(pixel, p)); });
    return distance;
}

struct Level {
    float darkness = 0;
    std::int64_t count = 0; // of the pixels that are darker than asked
};
Level percentile_above(const Grid<float>& darkness, float least) {
    std::array<std::int64_t, darkness_bins> histogram{};
    Level level;
    for (float d : darkness) {
        if (d <= least) continue;
        ++histogram[static_cast<std::size_t>(d * (darkness_bins - 1))];
        ++level.count;
    }
    if (level.count == 0) return level;
    std::size_t bin = 0;
    for (std::int64_t below = histogram[0]; 100 * below < dark_percent * level.count; below += histogram[bin])
        ++bin;
    level.darkness = static_cast<float>(bin) / (darkness_bins - 1);
    return level;
}

// The darkness of the darkest strokes: a percentile over the pixels that are not paper; where a pale fill is
// nearly all of them, over its strokes.
float dark_level(const Grid<float>& darkness) {
    const Level all = percentile_above(darkness, dark_pixel);
    if (all.darkness < clear_stroke)
        if (const Level strokes = percentile_above(darkness, clear_stroke);
            static_cast<double>(strokes.count) >= stroke_share * static_cast<double>(all.count))
            return std::max(min_dark_level, strokes.darkness);
    return std::max(min_dark_level, all.darkness);
}

void normalise(Grid<float>& darkness) {
    const float level = dark_level(darkness);
    for (float& d : darkness) d = std::min(1.0f, d / level);
}

// Median over the bare blocks of the mean distance of their lighter pixels: what is left of the paper.
float noise_of(const Grid<float>& distance, const Paper& paper) {
    std::vector<float> means;
    const int block = paper.block;
    for (int by = 0; by < paper.bare.height(); ++by)
        for (int bx = 0; bx < paper.bare.width(); ++bx) {
            if (!paper.bare(bx, by)) continue;
            float sum = 0;
            int count = 0;
            for (int y = by * block; y < std::min(distance.height(), (by + 1) * block); ++y)
                for (int x = bx * block; x < std::min(distance.width(), (bx + 1) * block); ++x)
                    if (distance(x, y) <= dark_pixel) sum += distance(x, y), ++count;
            if (count > 0) means.push_back(sum / static_cast<float>(count));
        }
    if (means.empty()) return 0;
    const auto middle = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2);
    std::nth_element(means.begin(), middle, means.end());
    return *middle;
}

double bare_border(const Paper& paper) {
    const Mask& bare = paper.bare;
    long border = 0, paper_blocks = 0;
    for (int y = 0; y < bare.height(); ++y)
        for (int x = 0; x < bare.width(); ++x) {
            if (x > 0 && y > 0 && x + 1 < bare.width() && y + 1 < bare.height()) continue;
            ++border;
            paper_blocks += bare(x, y);
        }
    return static_cast<double>(paper_blocks) / static_cast<double>(border);
}

// Whether a pixel near by is so much darker that this one may be the blurred edge of its stroke.
bool is_blurred_edge(const Grid<float>& distance, int x, int y) {
    const float limit = blur_contrast * distance(x, y);
    for (int v = y - blur_reach; v <= y + blur_reach; ++v)
        for (int u = x - blur_reach; u <= x + blur_reach; ++u)
            if (distance.value_or(u, v, 0.0f) > limit) return true;
    return false;
}

// Filled areas: connected pixels away from the paper that hold a block without bare paper.
Mask find_fills(const Grid<float>& distance, const Paper& paper) {
    const float least = std::max(faintest_fill, fill_over_noise * noise_of(distance, paper));
    Mask away(distance.width(), distance.height());
    for (int y = 0; y < away.height(); ++y)
        for (int x = 0; x < away.width(); ++x)
            away(x, y) = distance(x, y) >= least && !is_blurred_edge(distance, x, y);
    away = open_disc(away, 1.5); // grain is no area
    const Components pieces = connected_components(away);
    std::vector<char> filled(pieces.list.size() + 1, 0);
    for (int y = 0; y < away.height(); ++y)
        for (int x = 0; x < away.width(); ++x)
            if (pieces.ids(x, y) && !paper.bare(x / paper.block, y / paper.block))
                filled[static_cast<std::size_t>(pieces.ids(x, y))] = 1;
    for (std::size_t i = 0; i < away.size(); ++i)
        away.data()[i] = filled[static_cast<std::size_t>(pieces.ids.data()[i])];
    return away;
}

} // namespace

PageInk find_page_ink(const RgbImage& page) {
    PageInk ink;
    if (page.empty()) return ink;
    ink.light_on_dark = is_light_on_dark(page);
    const RgbImage inverse = ink.light_on_dark ? inverted(page) : RgbImage();
    const RgbImage& turned = ink.light_on_dark ? inverse : page;
    const Paper paper = estimate_paper(turned);
    ink.darkness = distance_from(turned, paper);
    ink.bare_border = bare_border(paper);
    remove_ruling(ink.darkness);
    ink.fills = find_fills(ink.darkness, paper);
    normalise(ink.darkness);
    return ink;
}

PageInk find_cut_out_ink(const RgbaImage& page) {
    PageInk ink;
    ink.cut_out = true;
    ink.darkness = Grid<float>(page.width(), page.height());
    ink.fills = Mask(page.width(), page.height());
    for (std::size_t i = 0; i < page.size(); ++i) {
        const Rgba8 p = page.data()[i];
        if (!is_opaque(p)) continue;
        ink.darkness.data()[i] = std::max(opaque_darkness, darker_by({p.r, p.g, p.b}, Colour{255, 255, 255}));
        ink.fills.data()[i] = 1;
    }
    normalise(ink.darkness);
    return ink;
}

Grid<float> ink_darkness(const RgbImage& image) { return find_page_ink(image).darkness; }

GreyImage ink_of_crop(const Grid<float>& darkness) {
    Grid<float> own = darkness;
    normalise(own);
    GreyImage grey(own.width(), own.height());
    std::transform(own.begin(), own.end(), grey.begin(),
                   [](float d) { return static_cast<std::uint8_t>(255 * d + 0.5f); });
    return grey;
}

Grid<float> darkness_of(const GreyImage& ink) {
    Grid<float> darkness(ink.width(), ink.height());
    std::transform(ink.begin(), ink.end(), darkness.begin(),
                   [](std::uint8_t v) { return static_cast<float>(v) / 255; });
    return darkness;
}

} // namespace pantin
