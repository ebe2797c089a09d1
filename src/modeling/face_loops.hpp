// SPDX-License-Identifier: MIT
// Triangles between loops that lie in a triangle of a surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pantin {

struct LoopCorner {
    std::int64_t x = 0, y = 0;
    int vertex = 0;
    unsigned edges = 0; // bit k: it lies on the k-th edge of the triangle
};
// Of the vertices; loops run with what they enclose on the left (y up), those around holes the other way.
// Whatever the loops are like, each of their edges is an edge of one triangle and every other edge one of
// two. No edge joins two corners on one edge of the triangle, which the next triangle would share. Ears are
// cut, the best shaped first (Meisters 1975); holes are joined to their border by the shortest way (Held
// 2001).
std::vector<std::array<int, 3>> fill_loops(std::vector<std::vector<LoopCorner>> loops);

} // namespace pantin
