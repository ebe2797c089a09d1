// SPDX-License-Identifier: MIT
// Polygons and lines in, masks and coverage out (non-zero winding; distance to a line).
#include "doodle/raster.hpp"

#include <algorithm>
#include <cmath>

namespace pantin::doodle {

Box bounds(const Path& points, double margin, int width, int height) {
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (Point2d p : points) {
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    const int left = std::max(0, static_cast<int>(std::floor(std::clamp(x0 - margin, -1.0, double(width)))));
    const int top = std::max(0, static_cast<int>(std::floor(std::clamp(y0 - margin, -1.0, double(height)))));
    const int right =
        std::min(width - 1, static_cast<int>(std::ceil(std::clamp(x1 + margin, -1.0, double(width)))));
    const int bottom =
        std::min(height - 1, static_cast<int>(std::ceil(std::clamp(y1 + margin, -1.0, double(height)))));
    if (right < left || bottom < top) return {0, 0, 0, 0};
    return {left, top, right - left + 1, bottom - top + 1};
}

namespace {

struct Crossing {
    double x;
    int winding;
};

// The crossings of the polygon with the horizontal line at y, from left to right.
void crossings_at(const Path& polygon, double y, std::vector<Crossing>& out) {
    out.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2d a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        if ((a.y <= y) == (b.y <= y)) continue;
        const double t = (y - a.y) / (b.y - a.y);
        out.push_back({a.x + t * (b.x - a.x), a.y <= y ? 1 : -1});
    }
    std::stable_sort(out.begin(), out.end(), [](const Crossing& p, const Crossing& q) { return p.x < q.x; });
}

// Calls span(from, to) for each inner interval of the line at y.
template <class Span> void inner_spans(const std::vector<Crossing>& crossings, Span span) {
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].winding;
        if (winding != 0) span(crossings[i].x, crossings[i + 1].x);
    }
}

} // namespace

Patch<std::uint8_t> fill_polygon(const Path& polygon, int width, int height) {
    Patch<std::uint8_t> patch{bounds(polygon, 0.0, width, height), {}};
    patch.values = Grid<std::uint8_t>(patch.box.width, patch.box.height);
    std::vector<Crossing> crossings;
    for (int row = 0; row < patch.box.height; ++row) {
        crossings_at(polygon, patch.box.y + row, crossings);
        inner_spans(crossings, [&](double from, double to) {
            const int a = std::max(0, static_cast<int>(std::ceil(std::max(from, -1.0))) - patch.box.x);
            const int b = std::min(patch.box.width - 1,
                                   static_cast<int>(std::floor(std::min(to, double(width)))) - patch.box.x);
            for (int x = a; x <= b; ++x) patch.values(x, row) = 1;
        });
    }
    return patch;
}

Patch<float> cover_polygon(const Path& polygon, int width, int height) {
    constexpr int samples = 4;
    Patch<float> patch{bounds(polygon, 1.0, width, height), {}};
    patch.values = Grid<float>(patch.box.width, patch.box.height);
    std::vector<Crossing> crossings;
    for (int line = 0; line < samples * patch.box.height; ++line) {
        const double y = patch.box.y - 0.5 + (line + 0.5) / samples;
        crossings_at(polygon, y, crossings);
        inner_spans(crossings, [&](double from, double to) {
            const double left = std::max(from, patch.box.x - 0.5),
                         right = std::min(to, patch.box.x + patch.box.width - 0.5);
            const int a = static_cast<int>(std::ceil((left - patch.box.x + 0.5) * samples - 0.5));
            const int b = static_cast<int>(std::floor((right - patch.box.x + 0.5) * samples - 0.5));
            for (int s = std::max(a, 0); s <= std::min(b, samples * patch.box.width - 1); ++s)
                patch.values(s / samples, line / samples) += 1.0f / (samples * samples);
        });
    }
    return patch;
}

Patch<float> cover_line(const Path& line, const std::vector<double>& radius, int width, int height) {
    const double widest = *std::max_element(radius.begin(), radius.end());
    Patch<float> patch{bounds(line, widest + 1.0, width, height), {}};
    patch.values = Grid<float>(patch.box.width, patch.box.height);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const std::size_t j = std::min(i + 1, line.size() - 1);
        if (i == j && line.size() > 1) break;
        const Point2d a = line[i], along = line[j] - a;
        const double squared = dot(along, along);
        const Box near = bounds({a, line[j]}, std::max(radius[i], radius[j]) + 1.0, width, height);
        for (int y = near.y; y < near.y + near.height; ++y)
            for (int x = near.x; x < near.x + near.width; ++x) {
                const Point2d p{static_cast<double>(x), static_cast<double>(y)};
                const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
                const double r = radius[i] + t * (radius[j] - radius[i]);
                const double cover = std::clamp(r + 0.5 - distance(p, a + t * along), 0.0, 1.0);
                float& value = patch.values(x - patch.box.x, y - patch.box.y);
                value = std::max(value, static_cast<float>(cover));
            }
    }
    return patch;
}

} // namespace pantin::doodle
