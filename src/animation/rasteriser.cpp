// SPDX-License-Identifier: MIT
// Posed vertices in, a frame out. Whether a sample belongs to a face is decided in integers
// (screen_face.hpp); the colour of a face in a pixel is looked up once, at the end (film_texture.hpp), and a
// pixel is the mean of what its samples see (fragments.hpp). A sample is covered or not: alpha of the texture
// against one half.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "animation/band_renderer.hpp"
#include "animation/vector.hpp"
#include "core/thread_pool.hpp"
#include "pantin/animation.hpp"

namespace pantin {
namespace {

constexpr int band_rows = 16;             // pixel rows that are drawn at a time: they stay in the cache
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
    surfaces.reserve(2 * rig.mesh.faces.size());
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
