// SPDX-License-Identifier: MIT
// Posed vertices in, a frame out. Whether a sample belongs to a face is decided in integers
// (screen_face.hpp); the colour of a face in a pixel is looked up once, at the end (film_texture.hpp), and a
// pixel is the mean of what its samples see (fragments.hpp). A sample is covered or not: alpha of the texture
// against one half.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "animation/film_texture.hpp"
#include "animation/fragments.hpp"
#include "animation/screen_face.hpp"
#include "animation/vector.hpp"
#include "core/thread_pool.hpp"
#include "pantin/animation.hpp"

namespace pantin {
namespace {

constexpr int band_rows = 16;                // pixel rows that are drawn at a time: they stay in the cache
constexpr double depth_units = 1 << 24;      // of a world unit; what is nearer by less is as near
constexpr double place_tolerance = 1 / 32.0; // texels, of a quadrangle's corners against a plane
constexpr double depth_tolerance = 1e-4;     // world units, of the same
constexpr int same_place = 32;               // 1/256 texels, of two faces in the middle of a pixel
constexpr double camera_distance = 2.5;      // of the perspective camera, in longer sides of the view
constexpr Vec3 to_light{-0.4, 0.5, 0.77};    // of solids; about a unit vector
constexpr double ambient = 0.5;              // brightness of what the light does not reach

struct FrameSize {
    int width = 1, height = 1;
    double pixels_per_unit = 1;
};

FrameSize frame_size(const View& view, int size) {
    const double longer = std::max(view.width, view.height);
    FrameSize frame;
    frame.pixels_per_unit = size / longer;
    frame.width = std::clamp(static_cast<int>(std::floor(view.width * frame.pixels_per_unit + 0.5)), 1, size);
    frame.height =
        std::clamp(static_cast<int>(std::floor(view.height * frame.pixels_per_unit + 0.5)), 1, size);
    return frame;
}

class Projection {
public:
    Projection(const View& view, const FrameSize& frame, int supersampling, bool perspective)
        : view_(view), scale_(frame.pixels_per_unit * supersampling), perspective_(perspective) {
        centre_ = {view.left + 0.5 * view.width, view.bottom + 0.5 * view.height};
        distance_ = camera_distance * std::max(view.width, view.height);
        rows_ = frame.height * supersampling;
    }
    // `texel`: where in the texture, in texels from the centre of the first one.
    ScreenVertex operator()(const Vec3& p, Point2d texel) const {
        ScreenVertex s;
        // Nothing of a flat character comes near the camera; the bound keeps the division safe whatever
        // comes.
        s.w = perspective_ ? distance_ / std::max(distance_ - p.z, 0.05 * distance_) : 1;
        const double x = centre_.x + (p.x - centre_.x) * s.w, y = centre_.y + (p.y - centre_.y) * s.w;
        s.x = fixed((x - view_.left) * scale_);
        s.y = fixed(rows_ - (y - view_.bottom) * scale_);
        s.z = std::rint(p.z * depth_units);
        s.u = texel.x * s.w;
        s.v = texel.y * s.w;
        return s;
    }

private:
    static std::int64_t fixed(double samples) {
        return static_cast<std::int64_t>(std::rint(std::clamp(samples, -1e6, 1e6) * sample_units));
    }
    View view_;
    double scale_, distance_ = 1;
    bool perspective_;
    int rows_ = 1;
    Point2d centre_;
};

// A face and what is to be seen of it.
struct Surface {
    ScreenFace shape;
    ScreenPlane depth, light;
    std::array<ScreenPlane, 3> look; // u, v and w; without a texture red, green and blue
    bool even = true;                // changes so little over a pixel that its middle stands for all samples
};

struct Picture {
    int samples = 1; // per axis of a pixel
    bool perspective = false, lit = false, textured = true;
    Rgba8 background;
};

using Corners = std::span<const ScreenVertex* const>;

// Longest step of the texture's place, along u or v, for a step of one sample across and one down. In
// perspective (du - u dw) / w changes over the face; the largest numerator over the smallest w bounds it.
double longest_step(const std::array<ScreenPlane, 3>& look, Corners corners, double least_w) {
    double longest = 0;
    for (const ScreenVertex* corner : corners) {
        const auto step = [&](const ScreenPlane& plane, double value) {
            return std::abs(plane.dx - value * look[2].dx) + std::abs(plane.dy - value * look[2].dy);
        };
        longest =
            std::max({longest, step(look[0], corner->u / corner->w), step(look[1], corner->v / corner->w)});
    }
    return longest / least_w;
}

bool changes_little(const ScreenPlane& plane, double most) {
    return std::abs(plane.dx) + std::abs(plane.dy) <= most;
}

bool is_even(const Surface& s, Corners corners, const Picture& picture, const FilmTexture& texture) {
    const double samples = picture.samples;
    if (picture.lit && !changes_little(s.light, 0.25 / samples)) return false;
    if (!picture.textured)
        return std::all_of(s.look.begin(), s.look.end(),
                           [&](const ScreenPlane& p) { return changes_little(p, 64 / samples); });
    double least_w = corners[0]->w;
    for (const ScreenVertex* corner : corners) least_w = std::min(least_w, corner->w);
    return changes_little(s.look[2], 0.25 * least_w / samples) &&
           samples * longest_step(s.look, corners, least_w) <= texture.longest_step();
}

Surface make_surface(Corners corners, const Picture& picture, const FilmTexture& texture) {
    const ScreenFace shape(corners);
    const auto plane = [&](const auto& value) {
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < corners.size(); ++i) values[i] = value(*corners[i]);
        return shape.plane(values);
    };
    Surface s{shape,
              plane([](const ScreenVertex& p) { return p.z; }),
              plane([](const ScreenVertex& p) { return p.light; }),
              {}};
    if (picture.textured)
        s.look = {plane([](const ScreenVertex& p) { return p.u; }),
                  plane([](const ScreenVertex& p) { return p.v; }),
                  plane([](const ScreenVertex& p) { return p.w; })};
    else
        s.look = {plane([](const ScreenVertex& p) { return p.colour.r; }),
                  plane([](const ScreenVertex& p) { return p.colour.g; }),
                  plane([](const ScreenVertex& p) { return p.colour.b; })};
    s.even = is_even(s, corners, picture, texture);
    return s;
}

std::int64_t area_of(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Whether the quadrangle can be drawn as one: strictly convex, and even enough that its values are those of a
// plane. `turn`: 1 when it runs clockwise, else -1.
bool is_plane(Corners corners, int turn) {
    for (std::size_t i = 0; i < 4; ++i)
        if (turn * area_of(*corners[i], *corners[(i + 1) % 4], *corners[(i + 2) % 4]) <= 0) return false;
    const auto differs = [&](double ScreenVertex::*value, double most) {
        return std::abs(corners[0]->*value - corners[1]->*value + corners[2]->*value - corners[3]->*value) >
               4 * most;
    };
    return !differs(&ScreenVertex::u, place_tolerance) && !differs(&ScreenVertex::v, place_tolerance) &&
           !differs(&ScreenVertex::w, 1e-4) && !differs(&ScreenVertex::z, depth_tolerance * depth_units);
}

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
        std::array<EdgeWalk, 4> walks;
        const std::size_t sides = shape.edges().size();
        for (std::size_t i = 0; i < sides; ++i) walks[i] = EdgeWalk(shape.edges()[i], rows.begin);
        int y = rows.begin / n;
        d.affine = picture_.textured && !picture_.perspective && d.surface.even;
        if (d.affine) d.places = PlaceWalk(d.surface, texture_, n, y);
        for (; y * n < rows.end; ++y, d.places.next_row()) {
            Spans spans;
            for (int j = 0; j < n; ++j) {
                const int row = y * n + j;
                std::int64_t begin = columns.begin, end = columns.end;
                if (row < rows.begin || row >= rows.end)
                    end = begin;
                else
                    for (std::size_t i = 0; i < sides; ++i) walks[i].clip(begin, end);
                spans[static_cast<std::size_t>(j)] =
                    begin < end ? SampleSpan{static_cast<int>(begin), static_cast<int>(end)} : SampleSpan{};
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

// Which surfaces each band of rows shows, in their order.
class Bands {
public:
    Bands(const std::vector<Surface>& surfaces, int count, int samples)
        : begin_(static_cast<std::size_t>(count) + 1) {
        const auto each_band = [&](const Surface& s, const auto& use) {
            const int rows = band_rows * samples, first = std::max(s.shape.rows().begin, 0),
                      last = std::min(s.shape.rows().end, count * rows) - 1;
            if (first > last) return;
            for (int band = first / rows; band <= last / rows; ++band) use(static_cast<std::size_t>(band));
        };
        for (const Surface& s : surfaces) each_band(s, [&](std::size_t band) { ++begin_[band + 1]; });
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        numbers_.resize(begin_.back());
        std::vector<std::size_t> next = begin_;
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            each_band(surfaces[i], [&](std::size_t band) { numbers_[next[band]++] = static_cast<int>(i); });
    }
    std::span<const int> operator[](int band) const {
        const auto b = static_cast<std::size_t>(band);
        return std::span(numbers_).subspan(begin_[b], begin_[b + 1] - begin_[b]);
    }

private:
    std::vector<std::size_t> begin_; // per band, its first number
    std::vector<int> numbers_;
};

} // namespace

struct FrameRenderer::Parts {
    const Rig& rig;
    FrameSize frame;
    Picture picture;
    Projection project;
    FilmTexture texture;

    std::vector<ScreenVertex> on_screen(const std::vector<Vec3>& vertices) const;
    void add_surface(Corners corners, std::vector<Surface>& surfaces) const;
    std::vector<Surface> surfaces(const std::vector<ScreenVertex>& screen) const;
    template <int n> void draw(RgbaImage& image, const std::vector<Surface>& surfaces, int threads) const;
};

std::vector<ScreenVertex> FrameRenderer::Parts::on_screen(const std::vector<Vec3>& vertices) const {
    std::vector<ScreenVertex> screen;
    screen.reserve(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v)
        screen.push_back(project(vertices[v], {rig.texture[v].x * texture.width() - 0.5,
                                               rig.texture[v].y * texture.height() - 0.5}));
    if (!rig.solid) return screen;
    const std::vector<Vec3> normals = vertex_normals(rig.mesh, vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (!rig.colours.empty()) screen[v].colour = rig.colours[v];
        screen[v].light = ambient + (1 - ambient) * std::clamp(dot(normals[v], to_light), 0.0, 1.0);
    }
    return screen;
}

// A triangle or a quadrangle that is_plane, where it may cover samples of the frame.
void FrameRenderer::Parts::add_surface(Corners corners, std::vector<Surface>& surfaces) const {
    const std::int64_t area = area_of(*corners[0], *corners[1], *corners[2]);
    if (area == 0) return;
    std::array<const ScreenVertex*, 4> clockwise{};
    if (area > 0)
        std::copy(corners.begin(), corners.end(), clockwise.begin());
    else // both sides of the paper are visible
        std::reverse_copy(corners.begin(), corners.end(), clockwise.begin());
    const std::int64_t unit = sample_units * picture.samples;
    const auto outside = [&](std::int64_t ScreenVertex::*side, std::int64_t most) {
        return std::all_of(corners.begin(), corners.end(), [&](auto* p) { return p->*side < 0; }) ||
               std::all_of(corners.begin(), corners.end(), [&](auto* p) { return p->*side > most; });
    };
    if (outside(&ScreenVertex::x, unit * frame.width) || outside(&ScreenVertex::y, unit * frame.height))
        return;
    surfaces.push_back(make_surface({clockwise.data(), corners.size()}, picture, texture));
}

std::vector<Surface> FrameRenderer::Parts::surfaces(const std::vector<ScreenVertex>& screen) const {
    std::vector<Surface> surfaces;
    surfaces.reserve(rig.mesh.faces.size());
    for (const std::vector<int>& face : rig.mesh.faces) {
        if (face.size() == 4 && picture.textured && !picture.lit) {
            const std::array<const ScreenVertex*, 4> quad = {&screen[face[0]], &screen[face[1]],
                                                             &screen[face[2]], &screen[face[3]]};
            if (is_plane(quad, area_of(*quad[0], *quad[1], *quad[2]) > 0 ? 1 : -1)) {
                add_surface(quad, surfaces);
                continue;
            }
        }
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const std::array<const ScreenVertex*, 3> triangle = {&screen[face[0]], &screen[face[i]],
                                                                 &screen[face[i + 1]]};
            add_surface(triangle, surfaces);
        }
    }
    return surfaces;
}

// Threads take every so many a band.
template <int n>
void FrameRenderer::Parts::draw(RgbaImage& image, const std::vector<Surface>& surfaces, int threads) const {
    const int count = (frame.height + band_rows - 1) / band_rows;
    const Bands bands(surfaces, count, n);
    const int workers = std::clamp(threads, 1, count);
    parallel_for(workers, workers, [&](int worker) {
        BandRenderer<n> render(frame.width, std::min(band_rows, frame.height), surfaces, texture, picture);
        for (int band = worker; band < count; band += workers)
            render(image, band * band_rows, std::min((band + 1) * band_rows, frame.height), bands[band]);
    });
}

FrameRenderer::FrameRenderer(const Rig& rig, const RgbaImage& texture, const View& view,
                             const RenderOptions& options) {
    const FrameSize frame = frame_size(view, options.size);
    const Picture picture{std::clamp(options.supersampling, 1, most_samples), options.perspective, rig.solid,
                          rig.colours.empty(), options.background};
    parts_.reset(
        new Parts{rig, frame, picture, Projection(view, frame, picture.samples, options.perspective),
                  FilmTexture(texture, frame.pixels_per_unit, picture.samples, options.perspective)});
}
FrameRenderer::~FrameRenderer() = default;
FrameRenderer::FrameRenderer(FrameRenderer&&) noexcept = default;

RgbaImage FrameRenderer::operator()(const std::vector<Vec3>& vertices, int threads) const {
    const Parts& parts = *parts_;
    // A background without alpha is empty, as the mean of its samples would make it.
    const Rgba8 background = parts.picture.background;
    RgbaImage image(parts.frame.width, parts.frame.height,
                    background.a == 0 ? Rgba8{0, 0, 0, 0} : background);
    constexpr std::array draw = {&Parts::draw<1>, &Parts::draw<2>, &Parts::draw<3>, &Parts::draw<4>,
                                 &Parts::draw<5>};
    static_assert(draw.size() == most_samples);
    (parts.*draw[static_cast<std::size_t>(parts.picture.samples) - 1])(
        image, parts.surfaces(parts.on_screen(vertices)), threads);
    return image;
}

RgbaImage render_frame(const Rig& rig, const std::vector<Vec3>& vertices, const RgbaImage& texture,
                       const View& view, const RenderOptions& options) {
    return FrameRenderer(rig, texture, view, options)(vertices);
}

std::vector<RgbaImage> render(const Rig& rig, const BoneAnimation& animation, const RgbaImage& texture,
                              const View& view, double fps, const RenderOptions& options) {
    const FrameRenderer renderer(rig, texture, view, options);
    const int count = std::max(1, static_cast<int>(std::floor(animation.duration * fps + 0.5)));
    std::vector<RgbaImage> frames;
    for (int i = 0; i < count; ++i)
        frames.push_back(renderer(skin(rig, animation, animation.duration * i / count)));
    return frames;
}

} // namespace pantin
