// SPDX-License-Identifier: MIT
// Corners in, a face with its planes out.
#include "animation/surface.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {
namespace {

constexpr double place_tolerance = 1 / 32.0; // texels, of a quadrangle's corners against a plane
constexpr double depth_tolerance = 1e-4;     // world units, of the same

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

} // namespace

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

} // namespace pantin
