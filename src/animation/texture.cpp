// SPDX-License-Identifier: MIT
// The drawing as a texture: opaque where the character is, transparent elsewhere. A silhouette's border often
// runs along the middle of the outline's ink, so the ink that touches it from outside belongs to the
// character as well.
#include <algorithm>
#include <cmath>
#include <queue>

#include "pantin/animation.hpp"
#include "pantin/image.hpp"

namespace pantin {
namespace {

constexpr float faint_ink =
    0.10f;                        // darkness from which a pixel outside the silhouette may belong to a stroke
constexpr float full_ink = 0.55f; // … and from which it is opaque
constexpr double solid_rim = 1.5; // working pixels inside the silhouette that a solid's texture leaves out
constexpr double small_hole_share = 0.02; // of the silhouette; as in skeletonization

Mask filled_silhouette(const LabelMap& labels) {
    const Mask mask = foreground(labels);
    const auto area = std::count(mask.begin(), mask.end(), 1);
    return fill_holes(mask, static_cast<long>(small_hole_share * static_cast<double>(area)));
}

// The silhouette at the drawing's size: bilinear between working pixels, cut at one half, so edges are
// smooth.
Mask enlarged(const Mask& mask, int width, int height) {
    if (mask.width() == width && mask.height() == height) return mask;
    Mask large(width, height);
    const double sx = static_cast<double>(mask.width()) / width,
                 sy = static_cast<double>(mask.height()) / height;
    for (int y = 0; y < height; ++y) {
        const double v = (y + 0.5) * sy - 0.5;
        const int y0 = static_cast<int>(std::floor(v));
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5) * sx - 0.5;
            const int x0 = static_cast<int>(std::floor(u));
            const double fx = u - x0, fy = v - y0;
            const auto at = [&](int i, int j) {
                return static_cast<double>(
                    mask(std::clamp(i, 0, mask.width() - 1), std::clamp(j, 0, mask.height() - 1)));
            };
            large(x, y) = (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x0 + 1, y0)) +
                              fy * ((1 - fx) * at(x0, y0 + 1) + fx * at(x0 + 1, y0 + 1)) >=
                          0.5;
        }
    }
    return large;
}

// Ink that is connected with the silhouette and lies within `reach` of it.
Mask touching_ink(const Mask& inside, const Grid<float>& darkness, double reach) {
    Mask outside(inside.width(), inside.height()), touching = outside;
    for (std::size_t i = 0; i < inside.size(); ++i) outside.data()[i] = !inside.data()[i];
    // The frame counts as inside for the distance transform; that only extends the reach at the crop's
    // border.
    const Grid<int> squared = squared_distance_transform(outside);
    std::queue<Point2i> queue;
    for (int y = 0; y < inside.height(); ++y)
        for (int x = 0; x < inside.width(); ++x)
            if (inside(x, y)) queue.push({x, y});
    while (!queue.empty()) {
        const Point2i p = queue.front();
        queue.pop();
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int x = p.x + dx, y = p.y + dy;
                if (!inside.contains(x, y) || inside(x, y) || touching(x, y)) continue;
                if (darkness(x, y) < faint_ink || squared(x, y) > reach * reach) continue;
                touching(x, y) = 1;
                queue.push({x, y});
            }
    }
    return touching;
}

// Paper between the silhouette's border and the outline's ink: reached from outside through paper, within
// `reach` of the border. Cut away, so that a figure on a coloured ground has no white rim; a gap in the
// outline costs a shallow notch.
void trim_paper(Mask& inside, const Grid<float>& darkness, double reach) {
    const Grid<int> squared = squared_distance_transform(inside);
    std::queue<Point2i> queue;
    const auto cut = [&](int x, int y) {
        if (!inside.contains(x, y) || !inside(x, y)) return;
        if (darkness(x, y) >= faint_ink || squared(x, y) > reach * reach) return;
        inside(x, y) = 0;
        queue.push({x, y});
    };
    const Mask before = inside;
    for (int y = 0; y < inside.height(); ++y)
        for (int x = 0; x < inside.width(); ++x)
            if (on_border(before, x, y)) cut(x, y);
    while (!queue.empty()) {
        const Point2i p = queue.front();
        queue.pop();
        cut(p.x - 1, p.y), cut(p.x + 1, p.y), cut(p.x, p.y - 1), cut(p.x, p.y + 1);
    }
}

} // namespace

RgbaImage make_texture(const RgbImage& drawing, const GreyImage& drawn, const LabelMap& labels) {
    const int width = drawing.width(), height = drawing.height();
    Mask inside = enlarged(filled_silhouette(labels), width, height);
    Mask ink(width, height);
    const Grid<float> darkness = drawn.empty() ? Grid<float>(width, height) : darkness_of(drawn);
    if (!drawn.empty()) {
        const double reach =
            static_cast<double>(width) / labels.width() * ink_margin(labels.width(), labels.height()) - 0.5;
        ink = touching_ink(inside, darkness, reach);
        trim_paper(inside, darkness, reach);
    }
    RgbaImage texture(width, height);
    Mask opaque(width, height);
    for (std::size_t i = 0; i < texture.size(); ++i) {
        float alpha = inside.data()[i] ? 1 : 0;
        if (!inside.data()[i] && ink.data()[i])
            alpha = std::clamp((darkness.data()[i] - faint_ink) / (full_ink - faint_ink), 0.f, 1.f);
        const Rgb8 colour = drawing.data()[i];
        texture.data()[i] = {colour.r, colour.g, colour.b,
                             static_cast<std::uint8_t>(std::floor(255 * alpha + 0.5f))};
        opaque.data()[i] = alpha == 1;
    }
    // What is not opaque takes the colour of the nearest opaque pixel, so that no paper shines through at the
    // edges.
    const Grid<int> nearest = nearest_seed(opaque);
    for (std::size_t i = 0; i < texture.size(); ++i) {
        if (opaque.data()[i] || nearest.data()[i] < 0) continue;
        const Rgba8 source = texture.data()[nearest.data()[i]];
        texture.data()[i] = {source.r, source.g, source.b, texture.data()[i].a};
    }
    return texture;
}

RgbaImage make_solid_texture(const RgbImage& drawing, const LabelMap& labels) {
    // The border's own pixels may hold paper, which the sides of the solid would be painted with.
    const double rim = solid_rim * drawing.width() / labels.width();
    const Mask inside = erode_disc(enlarged(foreground(labels), drawing.width(), drawing.height()), rim);
    const Grid<int> nearest = nearest_seed(inside);
    RgbaImage texture(drawing.width(), drawing.height());
    for (std::size_t i = 0; i < texture.size(); ++i) {
        const Rgb8 colour = drawing.data()[std::max(nearest.data()[i], 0)];
        texture.data()[i] = {colour.r, colour.g, colour.b, 255};
    }
    return texture;
}

} // namespace pantin
