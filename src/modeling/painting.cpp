// SPDX-License-Identifier: MIT
// Filled areas in, pixels out, by lines of sampling through each row (include/pantin/painting.hpp).
#include "pantin/painting.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {
namespace {

constexpr int lines_a_row = 4;

struct Crossing {
    double x = 0;
    int turn = 0; // +1 down, −1 up
};

// Edges of an outline in pixels, upper end first.
struct Edge {
    Point2d top, bottom;
    int turn = 0;
};

std::vector<Edge> edges_of(const PaintedShape& shape, const CanvasView& view) {
    std::vector<Edge> edges;
    for (const std::vector<Point2d>& outline : shape.outlines)
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point2d a = view.pixel(outline[i]), b = view.pixel(outline[(i + 1) % outline.size()]);
            if (a.y < b.y) edges.push_back({a, b, 1});
            if (b.y < a.y) edges.push_back({b, a, -1});
        }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.top.y < b.top.y; });
    return edges;
}

// Adds `share` of every pixel between x0 and x1 to the row.
void cover(std::vector<double>& row, double x0, double x1, double share) {
    const double right = static_cast<double>(row.size());
    x0 = std::clamp(x0 + 0.5, 0.0, right);
    x1 = std::clamp(x1 + 0.5, 0.0, right);
    if (!(x1 > x0)) return;
    const auto first = static_cast<std::size_t>(x0), last = static_cast<std::size_t>(x1);
    if (first == last) {
        row[first] += share * (x1 - x0);
        return;
    }
    row[first] += share * (static_cast<double>(first + 1) - x0);
    for (std::size_t x = first + 1; x < last; ++x) row[x] += share;
    if (last < row.size()) row[last] += share * (x1 - static_cast<double>(last));
}

// What of the line at height y is inside.
void cover_line(std::vector<double>& row, std::vector<Crossing>& crossings, bool even_odd) {
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    int count = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        count += even_odd ? 1 : crossings[i].turn;
        const bool inside = even_odd ? count % 2 != 0 : count != 0;
        if (inside) cover(row, crossings[i].x, crossings[i + 1].x, 1.0 / lines_a_row);
    }
}

// Colours over colours (Porter & Duff 1984), straight alpha.
void blend(Rgba8& under, Rgb8 colour, double alpha) {
    if (!(alpha > 0)) return;
    const double below = under.a / 255.0 * (1 - alpha), sum = alpha + below;
    const auto mixed = [&](std::uint8_t over, std::uint8_t old) {
        return static_cast<std::uint8_t>(std::floor((over * alpha + old * below) / sum + 0.5));
    };
    under = {mixed(colour.r, under.r), mixed(colour.g, under.g), mixed(colour.b, under.b),
             static_cast<std::uint8_t>(std::floor(255 * std::min(1.0, sum) + 0.5))};
}

void paint_shape(RgbaImage& image, const PaintedShape& shape, const CanvasView& view) {
    const std::vector<Edge> edges = edges_of(shape, view);
    if (edges.empty()) return;
    double bottom = edges.front().bottom.y;
    for (const Edge& e : edges) bottom = std::max(bottom, e.bottom.y);
    const double rows = static_cast<double>(image.height());
    const int first = static_cast<int>(std::clamp(std::floor(edges.front().top.y), 0.0, rows));
    const int last = static_cast<int>(std::clamp(std::ceil(bottom), -1.0, rows - 1));
    std::vector<std::size_t> active;
    std::size_t next = 0;
    std::vector<double> row(static_cast<std::size_t>(image.width()));
    std::vector<Crossing> crossings;
    for (int y = first; y <= last; ++y) {
        std::fill(row.begin(), row.end(), 0.0);
        while (next < edges.size() && edges[next].top.y < y + 0.5) active.push_back(next++);
        std::erase_if(active, [&](std::size_t e) { return edges[e].bottom.y <= y - 0.5; });
        for (int k = 0; k < lines_a_row; ++k) {
            const double at = y - 0.5 + (k + 0.5) / lines_a_row;
            crossings.clear();
            for (const std::size_t i : active) {
                const Edge& e = edges[i];
                if (e.top.y > at || e.bottom.y <= at) continue;
                const double t = (at - e.top.y) / (e.bottom.y - e.top.y);
                crossings.push_back({e.top.x + t * (e.bottom.x - e.top.x), e.turn});
            }
            cover_line(row, crossings, shape.even_odd);
        }
        for (int x = 0; x < image.width(); ++x)
            blend(image(x, y), shape.colour, std::min(1.0, row[static_cast<std::size_t>(x)]) * shape.opacity);
    }
}

} // namespace

RgbaImage paint(const Painting& painting, const CanvasView& view, int width, int height) {
    RgbaImage image(width, height);
    for (const PaintedShape& shape : painting) paint_shape(image, shape, view);
    return image;
}

} // namespace pantin
