// SPDX-License-Identifier: MIT
// Faces as they are drawn: where they are in the frame, and what changes evenly over them.
#pragma once

#include <array>
#include <span>

#include "animation/film_texture.hpp"
#include "animation/screen_face.hpp"

namespace pantin {

constexpr double depth_units = 1 << 24; // of a world unit; what is nearer by less is as near

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

// Twice the area of the triangle, positive when it runs clockwise.
std::int64_t area_of(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c);

// Whether four corners can be drawn as one face: strictly convex, and even enough that their values are those
// of a plane. `turn`: 1 when they run clockwise, else -1.
bool is_plane(Corners corners, int turn);

// Of a clockwise triangle, or of four corners that is_plane().
Surface make_surface(Corners corners, const Picture& picture, const FilmTexture& texture);

} // namespace pantin
