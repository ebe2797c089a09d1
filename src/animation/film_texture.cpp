// SPDX-License-Identifier: MIT
// Reduced by halves (Lance Williams, Pyramidal parametrics, 1983) to a few texels a pixel, then blurred, not
// reduced further, by the width of a pixel: reading that bilinearly at a pixel's centre gives about the mean
// over the pixel, however it lies between the texels (own).
#include "animation/film_texture.hpp"

#include <cmath>

namespace pantin {
namespace {

// Half the size: each pixel the mean of four, weighted by alpha.
RgbaImage halved(const RgbaImage& image) {
    RgbaImage half((image.width() + 1) / 2, (image.height() + 1) / 2);
    for (int y = 0; y < half.height(); ++y)
        for (int x = 0; x < half.width(); ++x) {
            int r = 0, g = 0, b = 0, a = 0, plain_r = 0, plain_g = 0, plain_b = 0;
            for (int k = 0; k < 4; ++k) {
                const Rgba8 p = image(std::min(2 * x + k % 2, image.width() - 1),
                                      std::min(2 * y + k / 2, image.height() - 1));
                r += p.r * p.a, g += p.g * p.a, b += p.b * p.a, a += p.a;
                plain_r += p.r, plain_g += p.g, plain_b += p.b;
            }
            const auto mean = [a](int sum, int plain) {
                return static_cast<std::uint8_t>(a > 0 ? (2 * sum + a) / (2 * a) : (plain + 2) / 4);
            };
            half(x, y) = {mean(r, plain_r), mean(g, plain_g), mean(b, plain_b),
                          static_cast<std::uint8_t>((a + 2) / 4)};
        }
    return half;
}

// Sums of [i - reach, i + 1 + reach] for each i of a line of values `step` apart; at the ends the last ones
// go on.
void window_sums(const int* values, int* sums, std::ptrdiff_t step, int count, int reach) {
    const auto at = [&](int i) { return values[std::clamp(i, 0, count - 1) * step]; };
    int sum = 0;
    for (int i = -reach; i <= reach; ++i) sum += at(i);
    for (int i = 0; i < count; ++i) {
        sum += at(i + 1 + reach);
        sums[i * step] = sum;
        sum -= at(i - reach);
    }
}

// How many of the texels [x - reach, x + 1 + reach] x [y - reach, y + 1 + reach] are opaque: all that a
// bilinear lookup within `reach` of the cell (x, y) reads.
Grid<int> opaque_around(const RgbaImage& texture, int reach) {
    const int width = texture.width(), height = texture.height();
    Grid<int> opaque(width, height), rows(width, height);
    std::transform(texture.begin(), texture.end(), opaque.begin(),
                   [](const Rgba8& p) { return p.a >= 128 ? 1 : 0; });
    for (int y = 0; y < height; ++y) window_sums(opaque.row(y), rows.row(y), 1, width, reach);
    for (int x = 0; x < width; ++x) window_sums(rows.data() + x, opaque.data() + x, width, height, reach);
    return opaque;
}

// A texel that is not there at all, alpha 0, next to some that are, has no colour to blend with theirs
// (painting programs often leave black): it takes their mean.
void spread_colours(RgbaImage& texture, const Grid<int>& opaque, int reach) {
    const int width = texture.width(), height = texture.height();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Rgba8& p = texture.row(y)[x];
            if (p.a != 0 || opaque.row(y)[x] == 0) continue;
            int r = 0, g = 0, b = 0, count = 0;
            for (int j = std::max(y - reach, 0); j <= std::min(y + 1 + reach, height - 1); ++j)
                for (int i = std::max(x - reach, 0); i <= std::min(x + 1 + reach, width - 1); ++i) {
                    const Rgba8 q = texture.row(j)[i];
                    if (q.a >= 128) r += q.r, g += q.g, b += q.b, ++count;
                }
            const auto mean = [count](int sum) { return static_cast<std::uint8_t>(sum / count); };
            p = {mean(r), mean(g), mean(b), 0};
        }
}

// Weights of a filter around its middle, which is first; with both sides they add up to 64.
struct Taps {
    std::vector<std::uint64_t> weights;
};

// A box that has the variance of the pixel's samples, `texels` texels over all of them: they lie
// texels / samples apart. Its length L follows from h whole texels on each side of the middle one and a part
// of the next ones: variance = (S + (h + 1)² (L - 2h - 1)) / L, S = h (h + 1) (2h + 1) / 3.
Taps pixel_filter(double texels, int samples) {
    const double variance = texels * texels / 12 * (1 - 1.0 / (samples * samples));
    for (int h = 0;; ++h) {
        const double whole = 2 * h + 1, next = (h + 1) * (h + 1), s = h * (h + 1) * whole / 3.0;
        if (variance >= next) continue;
        const double length = (next * whole - s) / (next - variance);
        if (length > whole + 2) continue;
        const auto inner = static_cast<std::uint64_t>(64 / length + 0.5);
        const auto outer = static_cast<std::uint64_t>(32 * (length - whole) / length + 0.5);
        Taps taps{std::vector<std::uint64_t>(static_cast<std::size_t>(h) + 2, inner)};
        taps.weights.back() = outer;
        taps.weights.front() = 64 - 2 * (static_cast<std::uint64_t>(h > 0 ? h : 0) * inner + outer);
        return taps;
    }
}

// Rows and columns filtered. Three channels share a number, 21 bits each: 255 · 64 · 64 + half of 64² fits.
std::vector<std::uint64_t> filtered(const RgbaImage& texture, const Taps& taps) {
    const int width = texture.width(), height = texture.height();
    const auto reach = static_cast<int>(taps.weights.size()) - 1;
    Grid<std::uint64_t> rows(width, height);
    std::vector<std::uint64_t> line(static_cast<std::size_t>(width + 2 * reach)), colours(texture.size());
    for (int y = 0; y < height; ++y) {
        for (int x = -reach; x < width + reach; ++x) {
            const Rgba8 p = texture.row(y)[std::clamp(x, 0, width - 1)];
            line[static_cast<std::size_t>(x + reach)] =
                p.r | static_cast<std::uint64_t>(p.g) << 21 | static_cast<std::uint64_t>(p.b) << 42;
        }
        for (int x = 0; x < width; ++x) {
            const std::uint64_t* at = line.data() + x + reach;
            std::uint64_t sum = taps.weights[0] * at[0];
            for (int k = 1; k <= reach; ++k)
                sum += taps.weights[static_cast<std::size_t>(k)] * (at[-k] + at[k]);
            rows.row(y)[x] = sum;
        }
    }
    for (int y = 0; y < height; ++y) {
        std::uint64_t* out = colours.data() + static_cast<std::ptrdiff_t>(y) * width;
        for (int x = 0; x < width; ++x) out[x] = taps.weights[0] * rows.row(y)[x];
        for (int k = 1; k <= reach; ++k) {
            const std::uint64_t weight = taps.weights[static_cast<std::size_t>(k)];
            const std::uint64_t *above = rows.row(std::max(y - k, 0)),
                                *below = rows.row(std::min(y + k, height - 1));
            for (int x = 0; x < width; ++x) out[x] += weight * (above[x] + below[x]);
        }
    }
    return colours;
}

// The same next to what is not opaque, of the opaque texels alone: the mean of that part of a pixel which is
// drawn. `around`: opaque_around().
void filter_outline(const RgbaImage& texture, const Grid<int>& around, int window, const Taps& taps,
                    std::vector<std::uint64_t>& colours) {
    const int width = texture.width(), height = texture.height();
    const auto reach = static_cast<int>(taps.weights.size()) - 1;
    const auto tap = [&taps](int i) { return taps.weights[static_cast<std::size_t>(std::abs(i))]; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int count = around.row(y)[x];
            if (count == 0 || count == window) continue;
            std::uint64_t r = 0, g = 0, b = 0, sum = 0;
            for (int j = -reach; j <= reach; ++j)
                for (int i = -reach; i <= reach; ++i) {
                    const Rgba8 p =
                        texture.row(std::clamp(y + j, 0, height - 1))[std::clamp(x + i, 0, width - 1)];
                    const std::uint64_t weight = p.a < 128 ? 0 : tap(i) * tap(j);
                    r += weight * p.r, g += weight * p.g, b += weight * p.b, sum += weight;
                }
            if (sum == 0) continue;
            const auto mean = [sum](std::uint64_t value) { return (4096 * value + sum / 2) / sum; };
            colours[static_cast<std::size_t>(y) * width + x] = mean(r) | mean(g) << 21 | mean(b) << 42;
        }
}

// From 21 bits a channel, times 64², to 16 bits a channel.
std::uint64_t packed(std::uint64_t sums) {
    const auto channel = [sums](int i) { return ((sums >> (21 * i) & 0x1fffff) + 2048) >> 12; };
    return channel(0) | channel(1) << 16 | channel(2) << 32;
}

} // namespace

FilmTexture::FilmTexture(RgbaImage texture, double pixels, int samples, bool perspective) {
    // Reduced until a sample is at least two thirds of a texel.
    while (texture.height() > 1.5 * pixels * samples && texture.height() > 1) texture = halved(texture);
    width_ = texture.width(), height_ = texture.height();
    const double texels = texture.height() / pixels; // of a pixel
    longest_step_ = std::max(1.75 * texels, 1.0);    // turned by 45 degrees 1.41 times as much as upright
    // A perspective pixel's samples lie not quite evenly.
    const double most = (perspective ? 1.34 : 1.0) * longest_step_;
    const int reach = static_cast<int>(std::ceil(0.5 * most * (samples - 1) / samples));
    const Grid<int> opaque = opaque_around(texture, reach);
    spread_colours(texture, opaque, reach);
    const int window = (2 * reach + 2) * (2 * reach + 2), margin = reach + 1;
    const Taps taps = pixel_filter(texels, samples);
    std::vector<std::uint64_t> colours = filtered(texture, taps);
    filter_outline(texture, opaque, window, taps, colours);
    stride_ = width_ + 2 * margin, first_ = margin * stride_ + margin;
    const std::size_t size =
        static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_ + 2 * margin);
    colours_.resize(size), alphas_.resize(size), opacities_.resize(size);
    std::size_t i = 0;
    for (int y = -margin; y < height_ + margin; ++y) {
        const int top = std::clamp(y, 0, height_ - 1), bottom = std::clamp(y + 1, 0, height_ - 1);
        const Rgba8 *above = texture.row(top), *below = texture.row(bottom);
        const int* count = opaque.row(top);
        const std::uint64_t* colour = colours.data() + static_cast<std::ptrdiff_t>(top) * width_;
        for (int x = -margin; x < width_ + margin; ++x, ++i) {
            const int left = std::clamp(x, 0, width_ - 1), right = std::clamp(x + 1, 0, width_ - 1);
            colours_[i] = packed(colour[left]);
            alphas_[i] = above[left].a | static_cast<std::uint32_t>(above[right].a) << 8 |
                         static_cast<std::uint32_t>(below[left].a) << 16 |
                         static_cast<std::uint32_t>(below[right].a) << 24;
            opacities_[i] = count[left] == window ? Opacity::full
                            : count[left] == 0    ? Opacity::none
                                                  : Opacity::mixed;
        }
    }
}

} // namespace pantin
