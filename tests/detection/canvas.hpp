// SPDX-License-Identifier: MIT
// A pen for the tests: drawings on white (or any) paper, and their true silhouettes.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin::test {

class Canvas {
public:
    Canvas(int width, int height, Rgb8 paper = {255, 255, 255}) : image(width, height, paper) {}

    void line(Point2d a, Point2d b, double pen = 3, Rgb8 ink = {0, 0, 0}) {
        const Point2d along = b - a;
        const double squared = std::max(1e-9, dot(along, along));
        const auto low = [&](double p, double q) {
            return std::max(0, static_cast<int>(std::min(p, q) - pen));
        };
        const auto high = [&](double p, double q, int n) {
            return std::min(n - 1, static_cast<int>(std::max(p, q) + pen));
        };
        for (int y = low(a.y, b.y); y <= high(a.y, b.y, image.height()); ++y) {
            for (int x = low(a.x, b.x); x <= high(a.x, b.x, image.width()); ++x) {
                const Point2d q = Point2d{1.0 * x, 1.0 * y} - a;
                const Point2d off = q - std::clamp(dot(q, along) / squared, 0.0, 1.0) * along;
                if (length(off) <= pen / 2) image(x, y) = ink;
            }
        }
    }
    void polyline(const std::vector<Point2d>& points, double pen = 3, Rgb8 ink = {0, 0, 0}) {
        for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], pen, ink);
    }
    // Part of an ellipse, angles in degrees, clockwise on screen from the right.
    void arc(Point2d centre, double rx, double ry, double from, double to, double pen = 3,
             Rgb8 ink = {0, 0, 0}) {
        constexpr double radian = 3.14159265358979 / 180;
        std::vector<Point2d> points;
        for (int i = 0; i <= 40; ++i) {
            const double a = (from + (to - from) * i / 40) * radian;
            points.push_back({centre.x + rx * std::cos(a), centre.y + ry * std::sin(a)});
        }
        polyline(points, pen, ink);
    }
    void disc(Point2d centre, double rx, double ry, Rgb8 ink = {0, 0, 0}) {
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (std::pow((x - centre.x) / rx, 2) + std::pow((y - centre.y) / ry, 2) <= 1)
                    image(x, y) = ink;
    }
    // Brightness of every pixel times light(x, y), plus noise of ±`noise` levels.
    template <class Light> void photograph(Light light, int noise) {
        std::mt19937 random{17};
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const int n = noise == 0
                                  ? 0
                                  : static_cast<int>(random() % static_cast<unsigned>(2 * noise + 1)) - noise;
                for (std::uint8_t Rgb8::*channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b})
                    image(x, y).*channel = static_cast<std::uint8_t>(
                        std::clamp(static_cast<int>(image(x, y).*channel * light(x, y)) + n, 0, 255));
            }
        }
    }

    RgbImage image;
};

// A cat-like figure in outline: body, head, four legs open at the top, tail line. `gap`: how much of body and
// head is left out, in degrees.
inline void draw_animal(Canvas& canvas, Point2d at, double size, double gap = 0, double pen = 3,
                        Rgb8 ink = {0, 0, 0}) {
    const auto p = [&](double x, double y) { return at + size * Point2d{x, y}; };
    canvas.arc(p(0.45, 0.45), 0.3 * size, 0.16 * size, -60 + gap, 300, pen, ink);
    canvas.arc(p(0.85, 0.3), 0.13 * size, 0.13 * size, 200 + gap, 560, pen, ink);
    for (double x : {0.25, 0.37, 0.55, 0.67})
        canvas.polyline({p(x - 0.03, 0.56), p(x - 0.03, 0.85), p(x + 0.03, 0.85), p(x + 0.03, 0.58)}, pen,
                        ink);
    canvas.line(p(0.16, 0.42), p(0.02, 0.2), pen, ink);
}

// A stick figure: a circle and lines.
inline void draw_stick_figure(Canvas& canvas, Point2d at, double size, double pen = 3, Rgb8 ink = {0, 0, 0}) {
    const auto p = [&](double x, double y) { return at + size * Point2d{x, y}; };
    canvas.arc(p(0.25, 0.15), 0.13 * size, 0.13 * size, 0, 360, pen, ink);
    canvas.line(p(0.25, 0.28), p(0.25, 0.65), pen, ink);
    canvas.polyline({p(0.02, 0.3), p(0.25, 0.4), p(0.48, 0.3)}, pen, ink);
    canvas.polyline({p(0.08, 1.0), p(0.25, 0.65), p(0.42, 1.0)}, pen, ink);
}

inline double intersection_over_union(const Mask& a, const Mask& b) {
    double both = 0, any = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a.data()[i] && b.data()[i];
        any += a.data()[i] || b.data()[i];
    }
    return any == 0 ? 1 : both / any;
}

} // namespace pantin::test
