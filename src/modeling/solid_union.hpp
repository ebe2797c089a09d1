// SPDX-License-Identifier: MIT
// Unions of closed surfaces of triangles in exact arithmetic.
//
// Coordinates are whole numbers, and all that decides how the surfaces run through each other is the exact
// sign of a determinant. Where one is zero the surface that is added counts as moved by (ε, ε², ε³), ε > 0
// and smaller than any number (simulation of simplicity, Edelsbrunner & Mücke 1990): so every edge that meets
// a triangle crosses it, and the result is closed whatever lies on what. Edges are cut at triangles, and what
// lies outside of the other surface is put together to loops within each triangle, as Smith & Dodgson (2007)
// do. New corners are rounded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modeling/box_tree.hpp"

namespace pantin {

struct GridPoint {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const GridPoint&) const = default;
};
constexpr double grid_reach = 137438953472; // 2^37: every coordinate is at most so far from 0

// Closed and oriented, counter-clockwise from outside.
struct GridSurface {
    std::vector<GridPoint> points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> parts;     // per triangle
    std::vector<GridBox> boxes; // per triangle; made and kept by unite_with()
};

// Adds what `part` holds to what `all` holds; both may be in several pieces. Whether that was possible: not
// where the rounding of an earlier union made `all` cut itself. Then `all` is as it was.
// Points that no triangle has any more stay.
bool unite_with(GridSurface& all, GridSurface part);

} // namespace pantin
