// SPDX-License-Identifier: MIT
// Surfaces in, rows of pixels out.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

#include "animation/fragments.hpp"
#include "animation/surface.hpp"

namespace pantin {

constexpr int same_place = 32; // 1/256 texels, of two faces in the middle of a pixel

// The texture's place in the middle of a pixel, for even surfaces without perspective: whole numbers, from
// pixel to pixel in whole steps. Starts in the row's first one.
class PlaceWalk {
public:
    PlaceWalk() = default;
    PlaceWalk(const Surface& s, const FilmTexture& texture, int samples, int row)
        : most_u_(fixed(texture.width() - 1)), most_v_(fixed(texture.height() - 1)),
          across_u_(fixed(samples * s.look[0].dx)), across_v_(fixed(samples * s.look[1].dx)),
          down_u_(fixed(samples * s.look[0].dy)), down_v_(fixed(samples * s.look[1].dy)) {
        const double x = 0.5 * (samples - 1), y = row * samples + x;
        u_ = fixed(s.shape.value(s.look[0], x, y)) + half;
        v_ = fixed(s.shape.value(s.look[1], x, y)) + half;
    }
    void next_row() { u_ += down_u_, v_ += down_v_; }
    void next_column() { u_ += across_u_, v_ += across_v_; }
    void skip_columns(int count) { u_ += count * across_u_, v_ += count * across_v_; }
    TexturePoint place() const { return {whole(u_, most_u_), whole(v_, most_v_)}; }
    // From the middle of a pixel to another place in it, which is so many 2 · n-ths of the pixel away.
    TexturePoint offset(int across, int down, int n) const {
        const auto part = [n](std::int64_t value) {
            return static_cast<int>((value + n * half * 2) / (2 * n) >> bits);
        };
        return {part(across * across_u_ + down * down_u_), part(across * across_v_ + down * down_v_)};
    }

private:
    static constexpr int bits = 16; // below those of a TexturePoint
    static constexpr std::int64_t half = 1 << (bits - 1);
    static std::int64_t fixed(double texels) {
        return static_cast<std::int64_t>(std::rint(texels * (256 << bits)));
    }
    static int whole(std::int64_t value, std::int64_t most) {
        return static_cast<int>(std::clamp<std::int64_t>(value, 0, most) >> bits);
    }
    std::int64_t u_ = 0, v_ = 0, most_u_ = 0, most_v_ = 0;
    std::int64_t across_u_ = 0, across_v_ = 0, down_u_ = 0, down_v_ = 0; // per pixel
};

// Draws a band of a frame's rows at a time; n samples per axis of a pixel.
template <int n> class BandRenderer {
public:
    BandRenderer(int width, int rows, const std::vector<Surface>& surfaces, const FilmTexture& texture,
                 const Picture& picture)
        : width_(width), surfaces_(surfaces), texture_(texture), picture_(picture), buffer_(width, rows),
          plain_(picture.textured && !picture.lit), drawn_(static_cast<std::size_t>(rows), {width, 0}) {}

    // The surfaces of these numbers, in that order, to the rows [first, end) of the image.
    void operator()(RgbaImage& image, int first, int end, std::span<const int> numbers) {
        first_ = first, end_ = end;
        for (const int number : numbers)
            draw({surfaces_[static_cast<std::size_t>(number)], number, false, {}});
        for (int y = first; y < end; ++y) resolve(y, image.row(y));
        buffer_.forget_lists();
    }

private:
    static constexpr SampleMask all = (SampleMask{1} << (n * n)) - 1;
    using Spans = std::array<SampleSpan, n>;
    using Opacity = FilmTexture::Opacity;

    // A surface on its way down the rows.
    struct Drawing {
        const Surface& surface;
        int number;
        bool affine = false; // else `places` are not used
        PlaceWalk places;
    };

    void draw(Drawing d) {
        const ScreenFace& shape = d.surface.shape;
        const SampleSpan rows{std::max(shape.rows().begin, first_ * n), std::min(shape.rows().end, end_ * n)};
        const SampleSpan columns{std::max(shape.columns().begin, 0),
                                 std::min(shape.columns().end, width_ * n)};
        if (rows.begin >= rows.end || columns.begin >= columns.end) return;
        FaceWalk walk(shape);
        int y = rows.begin / n;
        d.affine = picture_.textured && !picture_.perspective && d.surface.even;
        if (d.affine) d.places = PlaceWalk(d.surface, texture_, n, y);
        for (; y * n < rows.end; ++y, d.places.next_row()) {
            Spans spans;
            for (int j = 0; j < n; ++j) {
                const int row = y * n + j;
                if (row >= rows.begin && row < rows.end)
                    spans[static_cast<std::size_t>(j)] = walk.next(row, columns);
            }
            draw_row(d, y, spans);
        }
    }

    // A row of pixels, of whose rows of samples the spans are inside.
    void draw_row(const Drawing& d, int y, const Spans& spans) {
        int begin = width_ * n, end = 0, inner_begin = 0, inner_end = width_ * n;
        for (const SampleSpan& span : spans) {
            if (span.begin < span.end) begin = std::min(begin, span.begin), end = std::max(end, span.end);
            inner_begin = std::max(inner_begin, span.begin), inner_end = std::min(inner_end, span.end);
        }
        if (begin >= end) return;
        const int first = begin / n, last = (end + n - 1) / n;
        const int whole_end = std::max(inner_end / n, first),
                  whole = std::min((inner_begin + n - 1) / n, whole_end);
        SampleSpan& drawn = drawn_[static_cast<std::size_t>(y - first_)];
        drawn = {std::min(drawn.begin, first), std::max(drawn.end, last)};
        Fragment* row = buffer_.row(y - first_);
        const auto samples_at = [&](int x) {
            return x >= whole && x < whole_end ? all : samples_of(spans, x);
        };
        if (d.affine)
            draw_affine(d, y, first, last, samples_at, row);
        else
            for (int x = first; x < last; ++x) draw_pixel(d, x, y, samples_at(x), row[x]);
    }

    void draw_pixel(const Drawing& d, int x, int y, SampleMask samples, Fragment& pixel) {
        if (samples == 0) return;
        const bool even = d.surface.even, placed = even && picture_.textured;
        const TexturePoint place =
            placed ? place_of(d.surface, middle(x), middle(y)) : TexturePoint{even ? 0 : -1, 0};
        const Opacity opacity = placed              ? texture_.reader().opacity(place)
                                : picture_.textured ? Opacity::mixed
                                                    : Opacity::full;
        draw_among_others(d, x, y, {samples, d.number, -1, place}, opacity, pixel);
    }

    // The same for most pixels of most films: the place goes on evenly, and nothing else is there yet.
    template <class SamplesAt>
    void draw_affine(const Drawing& d, int y, int first, int last, const SamplesAt& samples_at,
                     Fragment* row) {
        const FilmTexture::Reader texture = texture_.reader();
        PlaceWalk places = d.places;
        places.skip_columns(first);
        for (int x = first; x < last; ++x, places.next_column()) {
            const SampleMask samples = samples_at(x);
            const TexturePoint place = places.place();
            const Opacity opacity = texture.opacity(place);
            if (opacity == Opacity::full && row[x].samples == 0)
                row[x] = {samples, d.number, -1, place};
            else if (opacity != Opacity::none && samples != 0)
                draw_among_others(d, x, y, {samples, d.number, -1, place}, opacity, row[x]);
        }
    }

    static SampleMask samples_of(const Spans& spans, int x) {
        // Per column the samples of a row from there on.
        constexpr auto from = [] {
            std::array<SampleMask, n + 1> masks{};
            for (int i = 0; i < n; ++i) masks[i] = all >> (n * (n - 1)) >> i << i;
            return masks;
        }();
        SampleMask samples = 0;
        for (int j = 0; j < n; ++j) {
            const SampleSpan& span = spans[static_cast<std::size_t>(j)];
            const auto begin = static_cast<std::size_t>(std::clamp(span.begin - x * n, 0, n)),
                       end = static_cast<std::size_t>(std::clamp(span.end - x * n, 0, n));
            samples |= (from[begin] & ~from[end]) << (j * n);
        }
        return samples;
    }

    void draw_among_others(const Drawing& d, int x, int y, Fragment fragment, Opacity opacity,
                           Fragment& pixel) {
        SampleMask& samples = fragment.samples;
        if (opacity == Opacity::none) return;
        if (pixel.samples != 0) samples = nearest(d.surface, x, y, samples, pixel);
        if (opacity == Opacity::mixed) samples = opaque(d, x, y, fragment);
        if (samples == 0) return;
        if (samples == all || pixel.samples == 0)
            pixel = fragment;
        else if (continues(pixel, fragment))
            pixel.samples |= samples;
        else
            buffer_.put(pixel, fragment);
    }

    // Whether the fragment shows the same place of the texture as the one that is there, on the other side of
    // an edge that the two faces share: both are one.
    bool continues(const Fragment& there, const Fragment& f) const {
        return (there.samples & f.samples) == 0 && plain_ && there.even() && f.even() &&
               std::abs(there.place.x - f.place.x) <= same_place &&
               std::abs(there.place.y - f.place.y) <= same_place;
    }

    // Those of the samples in which the surface is nearer than what the pixel holds.
    SampleMask nearest(const Surface& s, int x, int y, SampleMask samples, const Fragment& pixel) const {
        for (const Fragment* f = &pixel; f; f = buffer_.next(*f)) {
            const SampleMask both = f->samples & samples;
            if (both == 0) continue;
            const Surface& other = surface_of(*f);
            const double first =
                s.shape.value(s.depth, x * n, y * n) - other.shape.value(other.depth, x * n, y * n);
            const double dx = s.depth.dx - other.depth.dx, dy = s.depth.dy - other.depth.dy;
            const double across = dx * (n - 1), down = dy * (n - 1);
            if (first + std::min(across, 0.0) + std::min(down, 0.0) > 0) continue;
            if (first + std::max(across, 0.0) + std::max(down, 0.0) <= 0)
                samples &= ~both;
            else
                samples &= ~both | those(both, [&](int i, int j) { return first + i * dx + j * dy > 0; });
        }
        return samples;
    }

    SampleMask opaque(const Drawing& d, int x, int y, const Fragment& f) const {
        if (!d.affine)
            return those(f.samples, [&](int i, int j) {
                return texture_.reader().opaque(place_of(d.surface, x * n + i, y * n + j));
            });
        const FilmTexture::Reader texture = texture_.reader();
        const TexturePoint across = d.places.offset(2, 0, n), down = d.places.offset(0, 2, n);
        TexturePoint place = f.place + d.places.offset(1 - n, 1 - n, n);
        SampleMask kept = 0, bit = 1;
        for (int j = 0; j < n; ++j, place = place + down) {
            if ((f.samples >> (n * j) & (all >> (n * (n - 1)))) == 0) {
                bit <<= n;
                continue;
            }
            TexturePoint at = place;
            for (int i = 0; i < n; ++i, at = at + across, bit <<= 1) kept |= texture.opaque(at) ? bit : 0;
        }
        return kept & f.samples;
    }

    // The samples (i, j) of a pixel that fulfil the condition.
    template <class Condition> static SampleMask those(SampleMask samples, const Condition& condition) {
        SampleMask kept = 0, bit = 1;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i, bit <<= 1)
                if ((samples & bit) != 0 && condition(i, j)) kept |= bit;
        return kept;
    }

    // The colour of a fragment of the pixel.
    Rgb8 colour_of(const Fragment& f, int x, int y) const {
        if (plain_ && f.even()) return texture_.reader().colour(f.place);
        const Surface& s = surface_of(f);
        if (f.even()) return look(s, middle(x), middle(y), f.place);
        int r = 0, g = 0, b = 0;
        those(f.samples, [&](int i, int j) {
            const double column = x * n + i, row = y * n + j;
            const Rgb8 p =
                look(s, column, row, picture_.textured ? place_of(s, column, row) : TexturePoint{});
            r += p.r, g += p.g, b += p.b;
            return false;
        });
        const int count = std::popcount(f.samples);
        const auto mean = [count](int sum) {
            return static_cast<std::uint8_t>((2 * sum + count) / (2 * count));
        };
        return {mean(r), mean(g), mean(b)};
    }

    // At a place of the sample grid, which is `place` of the texture.
    Rgb8 look(const Surface& s, double x, double y, TexturePoint place) const {
        const Rgb8 colour = picture_.textured ? texture_.reader().colour(place) : mixed(s, x, y);
        if (!picture_.lit) return colour;
        const int light = static_cast<int>(std::clamp(s.shape.value(s.light, x, y), 0.0, 1.0) * 256 + 0.5);
        const auto lit = [light](int value) { return static_cast<std::uint8_t>((light * value + 128) >> 8); };
        return {lit(colour.r), lit(colour.g), lit(colour.b)};
    }

    Rgb8 mixed(const Surface& s, double x, double y) const {
        const auto channel = [&](const ScreenPlane& plane) {
            return static_cast<std::uint8_t>(std::clamp(s.shape.value(plane, x, y), 0.0, 255.0) + 0.5);
        };
        return {channel(s.look[0]), channel(s.look[1]), channel(s.look[2])};
    }

    TexturePoint place_of(const Surface& s, double x, double y) const {
        double u = s.shape.value(s.look[0], x, y), v = s.shape.value(s.look[1], x, y);
        if (picture_.perspective) {
            const double w = s.shape.value(s.look[2], x, y);
            u /= w, v /= w;
        }
        return texture_.place(u, v);
    }
    // Of a pixel's column or row, on the sample grid.
    static double middle(int pixel) { return pixel * n + 0.5 * (n - 1); }

    const Surface& surface_of(const Fragment& f) const { return surfaces_[static_cast<std::size_t>(f.face)]; }

    // The mean of the samples of each pixel over the background, straight alpha; the row is empty again then.
    void resolve(int y, Rgba8* image) {
        SampleSpan& drawn = drawn_[static_cast<std::size_t>(y - first_)];
        Fragment* row = buffer_.row(y - first_);
        const FilmTexture::Reader texture = texture_.reader();
        const bool plain = plain_;
        for (int x = drawn.begin; x < drawn.end; ++x) {
            const Fragment& f = row[x];
            if (f.samples == all && plain && f.even())
                image[x] = opaque_pixel(texture.colour(f.place));
            else if (f.samples == all)
                image[x] = opaque_pixel(colour_of(f, x, y));
            else if (f.samples != 0)
                image[x] = mean_of(f, x, y);
            row[x].samples = 0;
        }
        drawn = {width_, 0};
    }
    static Rgba8 opaque_pixel(Rgb8 colour) { return {colour.r, colour.g, colour.b, 255}; }

    Rgba8 mean_of(const Fragment& pixel, int x, int y) const {
        int r = 0, g = 0, b = 0, covered = 0;
        for (const Fragment* f = &pixel; f; f = buffer_.next(*f)) {
            const int count = std::popcount(f->samples);
            if (count == 0) continue;
            const Rgb8 colour = colour_of(*f, x, y);
            r += count * colour.r, g += count * colour.g, b += count * colour.b, covered += count;
        }
        // Premultiplied sums in units of 1/255 of a sample.
        const Rgba8 back = picture_.background;
        const int samples = n * n, rest = samples - covered, alpha = 255 * covered + back.a * rest;
        const auto mean = [&](int sum, int behind) {
            const int weighted = 255 * sum + back.a * behind * rest;
            return static_cast<std::uint8_t>((2 * weighted + alpha) / (2 * alpha));
        };
        return {mean(r, back.r), mean(g, back.g), mean(b, back.b),
                static_cast<std::uint8_t>((2 * alpha + samples) / (2 * samples))};
    }

    int width_; // pixels
    const std::vector<Surface>& surfaces_;
    const FilmTexture& texture_;
    const Picture& picture_;
    FragmentBuffer buffer_;
    bool plain_;                    // the place alone says which colour an even fragment has
    std::vector<SampleSpan> drawn_; // per row the pixels that any face touches
    int first_ = 0, end_ = 0;       // rows of the band
};

} // namespace pantin
