// SPDX-License-Identifier: MIT
// This work is based on:
// Juan Pineda, A parallel algorithm for polygon rasterization, 1988 (edge functions);
// Lance Williams, Pyramidal parametrics, 1983 (the reduced texture).
// Every sample of every pixel is shaded by itself, in double: slow, and simple enough to check the
// rasteriser of the program against.
#include "bench/sample_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "animation/vector.hpp"
#include "core/math.hpp"

namespace pantin::bench {
namespace {

constexpr std::int64_t subsamples = 256;  // fixed-point units per sample
constexpr int band_rows = 32;             // pixel rows that are drawn at a time
constexpr double camera_distance = 2.5;   // of the perspective camera, in longer sides of the view
constexpr Vec3 to_light{-0.4, 0.5, 0.77}; // of solids; about a unit vector
constexpr double ambient = 0.5;           // brightness of what the light does not reach

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

// A vertex on the sample grid. `w` is 1/depth of the perspective camera, 1 in the orthographic one.
struct ScreenVertex {
    std::int64_t x = 0, y = 0;  // fixed point, y down
    double z = 0;               // larger is nearer
    double w = 1, u = 0, v = 0; // u and v are divided by depth
    double light = 1;           // brightness, 0 to 1
    Rgb8 colour;                // of solids without a texture
};

class Projection {
public:
    Projection(const View& view, const FrameSize& frame, int supersampling, bool perspective)
        : view_(view), scale_(frame.pixels_per_unit * supersampling), perspective_(perspective) {
        centre_ = {view.left + 0.5 * view.width, view.bottom + 0.5 * view.height};
        distance_ = camera_distance * std::max(view.width, view.height);
        rows_ = frame.height * supersampling;
    }
    ScreenVertex operator()(const Vec3& p, Point2d texture) const {
        ScreenVertex s;
        // Nothing of a flat character comes near the camera; the bound keeps the division safe whatever
        // comes.
        s.w = perspective_ ? distance_ / std::max(distance_ - p.z, 0.05 * distance_) : 1;
        const double x = centre_.x + (p.x - centre_.x) * s.w, y = centre_.y + (p.y - centre_.y) * s.w;
        s.x = fixed((x - view_.left) * scale_);
        s.y = fixed(rows_ - (y - view_.bottom) * scale_);
        s.z = p.z;
        s.u = texture.x * s.w;
        s.v = texture.y * s.w;
        return s;
    }

private:
    static std::int64_t fixed(double samples) {
        return static_cast<std::int64_t>(std::rint(std::clamp(samples, -1e6, 1e6) * subsamples));
    }
    View view_;
    double scale_, distance_ = 1;
    bool perspective_;
    int rows_ = 1;
    Point2d centre_;
};

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

// The texture, bilinear; weights are whole 256ths, so the arithmetic is exact. Two channels share a 64-bit
// number: none of their sums (at most 255 · 2^16 + 2^15) reaches the other.
class Sampler {
public:
    explicit Sampler(const RgbaImage& image) : texels_(image.width(), image.height()) {
        const auto pair = [](std::uint8_t low, std::uint8_t high) {
            return low | static_cast<std::uint64_t>(high) << 32;
        };
        std::transform(image.begin(), image.end(), texels_.begin(), [&](const Rgba8& p) {
            return Texel{pair(p.r, p.g), pair(p.b, p.a)};
        });
    }
    Rgba8 operator()(double u, double v) const {
        const double x = std::clamp(u * texels_.width() - 0.5, 0.0, texels_.width() - 1.0);
        const double y = std::clamp(v * texels_.height() - 0.5, 0.0, texels_.height() - 1.0);
        const int fx = static_cast<int>(x * 256 + 0.5), fy = static_cast<int>(y * 256 + 0.5);
        const int x0 = fx >> 8, y0 = fy >> 8, x1 = std::min(x0 + 1, texels_.width() - 1);
        const auto tx = static_cast<std::uint64_t>(fx & 255), ty = static_cast<std::uint64_t>(fy & 255);
        const Texel *top = texels_.row(y0), *bottom = texels_.row(std::min(y0 + 1, texels_.height() - 1));
        const std::uint64_t a = (256 - tx) * (256 - ty), b = tx * (256 - ty), c = (256 - tx) * ty,
                            d = tx * ty;
        const auto mix = [&](std::uint64_t Texel::*channels) {
            constexpr std::uint64_t half = 32768;
            return a * (top[x0].*channels) + b * (top[x1].*channels) + c * (bottom[x0].*channels) +
                   d * (bottom[x1].*channels) + (half | half << 32);
        };
        const auto low = [](std::uint64_t sums) { return static_cast<std::uint8_t>(sums >> 16); };
        const auto high = [](std::uint64_t sums) { return static_cast<std::uint8_t>(sums >> 48); };
        const std::uint64_t red_green = mix(&Texel::red_green), blue_alpha = mix(&Texel::blue_alpha);
        return {low(red_green), high(red_green), low(blue_alpha), high(blue_alpha)};
    }

private:
    struct Texel {
        std::uint64_t red_green = 0, blue_alpha = 0;
    };
    Grid<Texel> texels_;
};

// Draws a band of a frame's sample rows at a time: its samples stay in the processor's cache.
class Rasteriser {
public:
    Rasteriser(int width, int rows)
        : colour_(width, rows), depth_(width, rows, farthest),
          drawn_(static_cast<std::size_t>(rows), {width, 0}) {}

    // From here on, samples of the rows from `row` on are drawn.
    void begin_band(int row) {
        first_row_ = row;
        for (int y = 0; y < colour_.height(); ++y) {
            Span& drawn = drawn_[static_cast<std::size_t>(y)];
            if (drawn.begin < drawn.end) {
                std::fill(colour_.row(y) + drawn.begin, colour_.row(y) + drawn.end, Rgba8{});
                std::fill(depth_.row(y) + drawn.begin, depth_.row(y) + drawn.end, farthest);
            }
            drawn = {colour_.width(), 0};
        }
    }

    // Without a sampler the vertices' colours are used.
    void draw(ScreenVertex a, ScreenVertex b, ScreenVertex c, const Sampler* sampler) {
        const Span rows = sample_range(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), first_row_,
                                       first_row_ + colour_.height());
        if (rows.begin >= rows.end) return;
        std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (area == 0) return;
        if (area < 0) { // both sides of the paper are visible
            std::swap(b, c);
            area = -area;
        }
        const std::array<Edge, 3> edges = {Edge(b, c), Edge(c, a), Edge(a, b)};
        const Span columns =
            sample_range(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), 0, colour_.width());
        const double inverse = 1.0 / static_cast<double>(area);
        for (int y = rows.begin; y < rows.end; ++y) {
            Span span = columns;
            for (const Edge& edge : edges) edge.clip(span, y);
            if (span.begin >= span.end) continue;
            Span& drawn = drawn_[static_cast<std::size_t>(y - first_row_)];
            drawn = {std::min(drawn.begin, span.begin), std::max(drawn.end, span.end)};
            std::int64_t e0 = edges[0].at(span.begin, y), e1 = edges[1].at(span.begin, y);
            for (int x = span.begin; x < span.end; ++x, e0 += edges[0].step(), e1 += edges[1].step())
                shade(x, y - first_row_, a, b, c, static_cast<double>(e0) * inverse,
                      static_cast<double>(e1) * inverse, sampler);
        }
    }

    // Mean of the samples of each pixel over the background, straight alpha, to the rows of the image that
    // the band covers.
    void resolve(RgbaImage& image, int supersampling, Rgba8 background) const {
        const int first = first_row_ / supersampling;
        const int rows = std::min(colour_.height() / supersampling, image.height() - first);
        for (int y = 0; y < rows; ++y) {
            Span drawn{colour_.width(), 0};
            for (int j = 0; j < supersampling; ++j) {
                const Span& row = drawn_[static_cast<std::size_t>(y * supersampling + j)];
                drawn = {std::min(drawn.begin, row.begin), std::max(drawn.end, row.end)};
            }
            const int end = std::min((drawn.end + supersampling - 1) / supersampling, image.width());
            for (int x = drawn.begin / supersampling; x < end; ++x)
                image(x, first + y) = mean_of_samples(x, y, supersampling, background);
        }
    }

private:
    struct Span {
        int begin = 0, end = 0;
    };

    // Positive inside (y down, clockwise). A sample on the edge belongs to it if the edge is a top or a left
    // one.
    struct Edge {
        std::int64_t x, y, dx, dy, bias;
        Edge(const ScreenVertex& from, const ScreenVertex& to)
            : x(from.x), y(from.y), dx(to.x - from.x), dy(to.y - from.y) {
            const bool top_left = (dy == 0 && dx > 0) || dy < 0;
            bias = top_left ? 0 : -1;
        }
        std::int64_t at(int column, int row) const {
            const std::int64_t px = column * subsamples + subsamples / 2,
                               py = row * subsamples + subsamples / 2;
            return dx * (py - y) - dy * (px - x);
        }
        // From a sample to the next one of the row.
        std::int64_t step() const { return -dy * subsamples; }
        // Cuts the span to the samples inside.
        void clip(Span& span, int row) const {
            const std::int64_t first = at(0, row) + bias;
            if (step() > 0) // first + x · step ≥ 0
                span.begin = static_cast<int>(
                    std::clamp<std::int64_t>(-math::floor_divide(first, step()), span.begin, span.end));
            else if (step() < 0)
                span.end = static_cast<int>(
                    std::clamp<std::int64_t>(math::floor_divide(first, -step()) + 1, span.begin, span.end));
            else if (first < 0)
                span.end = span.begin;
        }
    };

    static Span sample_range(std::int64_t low, std::int64_t high, int begin, int end) {
        return {
            static_cast<int>(std::clamp<std::int64_t>(math::floor_divide(low, subsamples), begin, end)),
            static_cast<int>(std::clamp<std::int64_t>(math::floor_divide(high, subsamples) + 1, begin, end))};
    }

    void shade(int x, int y, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, double p,
               double q, const Sampler* sampler) {
        const double r = 1 - p - q;
        const auto z = static_cast<float>(p * a.z + q * b.z + r * c.z);
        if (z <= depth_(x, y)) return;
        const double w = p * a.w + q * b.w + r * c.w;
        const Rgba8 texel =
            sampler ? (*sampler)((p * a.u + q * b.u + r * c.u) / w, (p * a.v + q * b.v + r * c.v) / w)
                    : mixed(a.colour, b.colour, c.colour, p, q, r);
        if (texel.a < 128) return;
        depth_(x, y) = z;
        const double light = p * a.light + q * b.light + r * c.light;
        const auto lit = [light](std::uint8_t value) {
            return static_cast<std::uint8_t>(light * value + 0.5);
        };
        colour_(x, y) = light == 1 ? Rgba8{texel.r, texel.g, texel.b, 255}
                                   : Rgba8{lit(texel.r), lit(texel.g), lit(texel.b), 255};
    }

    static Rgba8 mixed(Rgb8 a, Rgb8 b, Rgb8 c, double p, double q, double r) {
        const auto mix = [=](std::uint8_t u, std::uint8_t v, std::uint8_t w) {
            return static_cast<std::uint8_t>(p * u + q * v + r * w + 0.5);
        };
        return {mix(a.r, b.r, c.r), mix(a.g, b.g, c.g), mix(a.b, b.b, c.b), 255};
    }

    Rgba8 mean_of_samples(int x, int y, int supersampling, Rgba8 background) const {
        int r = 0, g = 0, b = 0, covered = 0;
        for (int j = 0; j < supersampling; ++j) {
            const Rgba8* row = colour_.row(y * supersampling + j) + x * supersampling;
            for (int i = 0; i < supersampling; ++i)
                if (row[i].a != 0) r += row[i].r, g += row[i].g, b += row[i].b, ++covered;
        }
        // Premultiplied sums in units of 1/255 of a sample.
        const int samples = supersampling * supersampling;
        const int rest = samples - covered, alpha = 255 * covered + background.a * rest;
        const auto mean = [&](int sum, int back) {
            const int weighted = 255 * sum + background.a * back * rest;
            return static_cast<std::uint8_t>(alpha > 0 ? (2 * weighted + alpha) / (2 * alpha) : 0);
        };
        return {mean(r, background.r), mean(g, background.g), mean(b, background.b),
                static_cast<std::uint8_t>((2 * alpha + samples) / (2 * samples))};
    }

    static constexpr float farthest = -std::numeric_limits<float>::infinity();

    int first_row_ = 0;
    RgbaImage colour_;
    Grid<float> depth_;
    std::vector<Span> drawn_; // per row of samples, the columns that any triangle covers
};

// The texture reduced until a sample is at least two thirds of a texel.
RgbaImage fitting(RgbaImage texture, const View& view, const RenderOptions& options) {
    const double samples = frame_size(view, options.size).pixels_per_unit * options.supersampling;
    while (texture.height() > 1.5 * samples && texture.height() > 1) texture = halved(texture);
    return texture;
}

} // namespace

struct SampleRenderer::Parts {
    const Rig& rig;
    RenderOptions options;
    FrameSize frame;
    Projection project;
    Sampler sampler;
};

SampleRenderer::SampleRenderer(const Rig& rig, const RgbaImage& texture, const View& view,
                               const RenderOptions& options) {
    const FrameSize frame = frame_size(view, options.size);
    parts_.reset(new Parts{rig, options, frame,
                           Projection(view, frame, options.supersampling, options.perspective),
                           Sampler(fitting(texture, view, options))});
}
SampleRenderer::~SampleRenderer() = default;

RgbaImage SampleRenderer::operator()(const std::vector<Vec3>& vertices) const {
    const auto& [rig, options, frame, project, sampler] = *parts_;
    std::vector<ScreenVertex> screen;
    for (std::size_t v = 0; v < vertices.size(); ++v) screen.push_back(project(vertices[v], rig.texture[v]));
    if (rig.solid) {
        const std::vector<Vec3> normals = vertex_normals(rig.mesh, vertices);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            if (!rig.colours.empty()) screen[v].colour = rig.colours[v];
            screen[v].light = ambient + (1 - ambient) * std::clamp(dot(normals[v], to_light), 0.0, 1.0);
        }
    }
    // A background without alpha is empty, as the mean of its samples would make it.
    RgbaImage image(frame.width, frame.height,
                    options.background.a == 0 ? Rgba8{0, 0, 0, 0} : options.background);
    const int rows = std::min(band_rows, frame.height);
    Rasteriser rasteriser(frame.width * options.supersampling, rows * options.supersampling);
    for (int y = 0; y < frame.height; y += rows) {
        rasteriser.begin_band(y * options.supersampling);
        for (const std::vector<int>& face : rig.mesh.faces)
            for (std::size_t i = 1; i + 1 < face.size(); ++i)
                rasteriser.draw(screen[face[0]], screen[face[i]], screen[face[i + 1]],
                                rig.colours.empty() ? &sampler : nullptr);
        rasteriser.resolve(image, options.supersampling, options.background);
    }
    return image;
}

} // namespace pantin::bench
