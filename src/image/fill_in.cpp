// SPDX-License-Identifier: MIT
// This work is based on:
// Gortler et al., The Lumigraph, 1996, section 3.4 (push-pull: scattered colours averaged up a pyramid and
// carried down into the gaps), followed by Jacobi steps of Laplace's equation, which take the pyramid's
// blocks out.
#include <algorithm>
#include <vector>

#include "pantin/image.hpp"

namespace pantin {

namespace {

struct Colour {
    float r = 0, g = 0, b = 0;
};
Colour operator+(Colour a, Colour b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
Colour operator*(float s, Colour c) { return {s * c.r, s * c.g, s * c.b}; }

struct Level {
    Grid<Colour> colour; // where nothing is known: black, until it is filled
    Grid<float> known;   // 0 … 1
};

constexpr int smoothing_steps = 60;

Level halved(const Level& level) {
    const int width = (level.colour.width() + 1) / 2, height = (level.colour.height() + 1) / 2;
    Level half{Grid<Colour>(width, height), Grid<float>(width, height)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Colour sum;
            float weight = 0;
            for (int k = 0; k < 4; ++k) {
                const int u = 2 * x + k % 2, v = 2 * y + k / 2;
                if (!level.known.contains(u, v)) continue;
                sum = sum + level.known(u, v) * level.colour(u, v);
                weight += level.known(u, v);
            }
            if (weight > 0) half.colour(x, y) = (1 / weight) * sum;
            half.known(x, y) = std::min(weight, 1.0f);
        }
    return half;
}

// What is not known takes the colour of the coarser level, bilinear.
void fill_from(Level& level, const Level& coarse) {
    for (int y = 0; y < level.colour.height(); ++y)
        for (int x = 0; x < level.colour.width(); ++x) {
            const float known = level.known(x, y);
            if (known >= 1) continue;
            const int x0 = x / 2, x1 = std::clamp(x % 2 ? x0 + 1 : x0 - 1, 0, coarse.colour.width() - 1);
            const int y0 = y / 2, y1 = std::clamp(y % 2 ? y0 + 1 : y0 - 1, 0, coarse.colour.height() - 1);
            const Colour near = 0.75f * coarse.colour(x0, y0) + 0.25f * coarse.colour(x1, y0);
            const Colour far = 0.75f * coarse.colour(x0, y1) + 0.25f * coarse.colour(x1, y1);
            level.colour(x, y) = known * level.colour(x, y) + (1 - known) * (0.75f * near + 0.25f * far);
        }
}

// Each pixel of the hole becomes the mean of its neighbours.
void smooth(Grid<Colour>& colour, const std::vector<Point2i>& hole) {
    std::vector<Colour> next(hole.size());
    for (int step = 0; step < smoothing_steps; ++step) {
        for (std::size_t i = 0; i < hole.size(); ++i) {
            const auto [x, y] = hole[i];
            const auto at = [&](int u, int v) {
                return colour(std::clamp(u, 0, colour.width() - 1), std::clamp(v, 0, colour.height() - 1));
            };
            next[i] = 0.25f * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1));
        }
        for (std::size_t i = 0; i < hole.size(); ++i) colour(hole[i].x, hole[i].y) = next[i];
    }
}

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5f, 0.0f, 255.0f));
}

} // namespace

RgbImage fill_in(const RgbImage& image, const Mask& hole) {
    std::vector<Level> pyramid(1);
    pyramid[0] = {Grid<Colour>(image.width(), image.height()), Grid<float>(image.width(), image.height())};
    std::vector<Point2i> pixels;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            if (hole(x, y)) {
                pixels.push_back({x, y});
                continue;
            }
            const Rgb8 p = image(x, y);
            pyramid[0].colour(x, y) = {static_cast<float>(p.r), static_cast<float>(p.g),
                                       static_cast<float>(p.b)};
            pyramid[0].known(x, y) = 1;
        }
    while (pyramid.back().colour.size() > 1) pyramid.push_back(halved(pyramid.back()));
    for (std::size_t i = pyramid.size() - 1; i-- > 0;) fill_from(pyramid[i], pyramid[i + 1]);
    smooth(pyramid[0].colour, pixels);
    RgbImage filled = image;
    for (const Point2i p : pixels) {
        const Colour c = pyramid[0].colour(p.x, p.y);
        filled(p.x, p.y) = {byte_of(c.r), byte_of(c.g), byte_of(c.b)};
    }
    return filled;
}

} // namespace pantin
