// SPDX-License-Identifier: MIT
// Paper and camera: tint, lines, shadow, vignette, blur, noise.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/canvas.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0));
}

// Printed lines: 1 where the paper is bare, less on a line.
struct Ruling {
    bool lined = false, squared = false, margin = false;
    double pitch = 20, phase_x = 0, phase_y = 0, depth = 0.2, margin_x = 0;

    double at(double x, double y) const {
        double value = 1.0;
        const auto line = [&](double position, double period) {
            const double d = std::abs(position - period * std::floor(position / period + 0.5));
            return std::clamp(1.2 - d, 0.0, 1.0);
        };
        if (lined || squared) value -= depth * line(y + phase_y, pitch);
        if (squared) value -= depth * line(x + phase_x, pitch);
        return value;
    }
};

Ruling random_ruling(Random& r, int width, int height) {
    Ruling ruling;
    const double size = std::min(width, height);
    const double kind = r.uniform();
    ruling.lined = kind < 0.16;
    ruling.squared = kind > 0.9;
    ruling.pitch = size * r.uniform(0.05, 0.11);
    ruling.phase_x = r.uniform(0, ruling.pitch);
    ruling.phase_y = r.uniform(0, ruling.pitch);
    ruling.depth = r.uniform(0.05, 0.16);
    return ruling;
}

// [1 2 1] / 4 in both directions, mixed with the original by `amount`.
void soften(Grid<Colour>& image, float amount) {
    const Grid<Colour> source = image;
    const int w = image.width(), h = image.height();
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            Colour sum{};
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const float weight = static_cast<float>((2 - std::abs(dx)) * (2 - std::abs(dy))) / 16.0f;
                    const Colour& c = source(std::clamp(x + dx, 0, w - 1), std::clamp(y + dy, 0, h - 1));
                    for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * c[k];
                }
            for (std::size_t k = 0; k < 3; ++k)
                image(x, y)[k] = source(x, y)[k] + amount * (sum[k] - source(x, y)[k]);
        }
}

struct Light {
    Point2d gradient; // change of brightness over the page's half
    double vignette = 0;
    bool shadow = false; // a soft shadow beyond a line
    Point2d normal{1, 0};
    double offset = 0, softness = 0.2, depth = 0;

    double at(double u, double v) const { // u, v in −1 … 1
        double light = 1.0 + gradient.x * u + gradient.y * v - vignette * (u * u + v * v) * 0.5;
        if (shadow) {
            const double t = std::clamp((normal.x * u + normal.y * v - offset) / softness + 0.5, 0.0, 1.0);
            light *= 1.0 - depth * t * t * (3 - 2 * t);
        }
        return light;
    }
};

Light random_light(Random& r) {
    Light light;
    const double slope = r.uniform(0.0, 0.16);
    light.gradient = slope * direction(r.uniform(0.0, 2 * pi));
    light.vignette = r.chance(0.5) ? r.uniform(0.0, 0.25) : 0.0;
    light.shadow = r.chance(0.4);
    light.normal = direction(r.uniform(0.0, 2 * pi));
    light.offset = r.uniform(-0.4, 0.8);
    light.softness = r.uniform(0.15, 0.8);
    light.depth = r.uniform(0.08, 0.32);
    return light;
}

// Slow stains: bilinear value noise on a coarse grid, in [−1, 1].
double blotch_at(int x, int y, int cell, std::uint64_t seed) {
    const double fx = static_cast<double>(x) / cell, fy = static_cast<double>(y) / cell;
    const int cx = static_cast<int>(fx), cy = static_cast<int>(fy);
    const double tx = fx - cx, ty = fy - cy;
    const double top = pixel_noise(cx, cy, seed) * (1 - tx) + pixel_noise(cx + 1, cy, seed) * tx;
    const double bottom = pixel_noise(cx, cy + 1, seed) * (1 - tx) + pixel_noise(cx + 1, cy + 1, seed) * tx;
    return 2 * (top * (1 - ty) + bottom * ty) - 1;
}

// Ink, print and the sheet's own colour, multiplied.
Colour on_sheet(const Colour& ink, const Colour& sheet, double print, double shade, double fade) {
    Colour out;
    for (std::size_t k = 0; k < 3; ++k) {
        const double stain = 1.0 - (1.0 - ink[k] / 255.0) * (1.0 - fade);
        const double line = k == 2 ? 0.5 + 0.5 * print : print; // the lines are bluish
        out[k] = static_cast<float>(sheet[k] * shade * stain * line);
    }
    return out;
}

Colour sheet_colour(double brightness, double warmth) {
    return {static_cast<float>(std::min(255.0, brightness * (1 + 0.3 * warmth))),
            static_cast<float>(brightness), static_cast<float>(brightness * (1 - warmth))};
}

RgbImage rounded(const Grid<Colour>& image) {
    RgbImage out(image.width(), image.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Colour& c = image.data()[i];
        out.data()[i] = {to_byte(c[0]), to_byte(c[1]), to_byte(c[2])};
    }
    return out;
}

void add_noise(Grid<Colour>& page, double noise, std::uint64_t seed) {
    for (int y = 0; y < page.height(); ++y)
        for (int x = 0; x < page.width(); ++x) {
            const double common = noise * (pixel_noise(x, y, seed + 1) + pixel_noise(x, y, seed + 2) - 1.0);
            const double tint = 0.4 * noise * (pixel_noise(x, y, seed + 3) - 0.5);
            Colour& c = page(x, y);
            c = {static_cast<float>(c[0] + common + tint), static_cast<float>(c[1] + common),
                 static_cast<float>(c[2] + common - tint)};
        }
}

RgbImage scanned(const Grid<Colour>& ink, Random& r) {
    const double brightness = r.uniform(228, 252);
    const Colour sheet = sheet_colour(brightness, r.uniform(-0.02, 0.12));
    const Ruling ruling = random_ruling(r, ink.width(), ink.height());
    Grid<Colour> page(ink.width(), ink.height());
    for (int y = 0; y < ink.height(); ++y)
        for (int x = 0; x < ink.width(); ++x)
            page(x, y) = on_sheet(ink(x, y), sheet, ruling.at(x, y), 1.0, 0.0);
    return rounded(page);
}

RgbImage photographed(const Grid<Colour>& ink, Random& r) {
    const int w = ink.width(), h = ink.height();
    const double brightness = r.uniform(165, 245);
    const Colour sheet = sheet_colour(brightness, r.uniform(-0.03, 0.12));
    const Ruling ruling = random_ruling(r, w, h);
    const Light light = random_light(r);
    const double noise = r.chance(0.7) ? r.uniform(0.5, 5.0) : 0.0, blotch = r.uniform(0.0, 0.02);
    const double fade = r.uniform(0.0, 0.25); // ink never gets quite black in a photograph
    const std::uint64_t seed = r.next();
    const int cell = std::max(8, std::min(w, h) / 12);
    Grid<Colour> page(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const double shade =
                light.at(2.0 * x / w - 1, 2.0 * y / h - 1) * (1 + blotch * blotch_at(x, y, cell, seed));
            page(x, y) = on_sheet(ink(x, y), sheet, ruling.at(x, y), shade, fade);
        }
    soften(page, static_cast<float>(r.uniform(0.2, 1.0)));
    if (r.chance(0.3)) soften(page, 1.0f);
    add_noise(page, noise, seed);
    return rounded(page);
}

} // namespace

Finish random_finish(Random& r, const DoodleOptions& options) {
    const bool photo = r.chance(options.photo), paper = r.chance(options.paper);
    return photo ? Finish::photo : paper ? Finish::paper : Finish::screen;
}

RgbImage under_camera(Grid<Colour> view, Random& r) {
    const Light light = random_light(r);
    const double exposure = r.uniform(0.8, 1.05), noise = r.uniform(0.5, 5.0);
    const std::uint64_t seed = r.next();
    for (int y = 0; y < view.height(); ++y)
        for (int x = 0; x < view.width(); ++x)
            for (float& c : view(x, y))
                c *= static_cast<float>(exposure *
                                        light.at(2.0 * x / view.width() - 1, 2.0 * y / view.height() - 1));
    soften(view, static_cast<float>(r.uniform(0.2, 1.0)));
    add_noise(view, noise, seed);
    return rounded(view);
}

RgbImage on_paper(const Grid<Colour>& ink, Random& r, Finish finish) {
    if (finish == Finish::photo) return photographed(ink, r);
    return finish == Finish::paper ? scanned(ink, r) : rounded(ink);
}

} // namespace pantin::doodle
