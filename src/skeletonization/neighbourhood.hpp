// SPDX-License-Identifier: MIT
// The eight neighbours of a pixel as the bits of a byte, in the order P_2 … P_9 of Figure 4.10: north, then
// clockwise.
#pragma once

#include <array>
#include <bit>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/point.hpp"

namespace pantin {

inline constexpr std::array<Point2i, 8> neighbour_offsets = {
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

inline unsigned neighbourhood(const Mask& image, int x, int y) {
    unsigned bits = 0;
    for (unsigned k = 0; k < 8; ++k)
        bits |= static_cast<unsigned>(
                    image.value_or(x + neighbour_offsets[k].x, y + neighbour_offsets[k].y, 0) != 0)
                << k;
    return bits;
}

// The foreground pixels in raster order.
inline std::vector<Point2i> foreground_pixels(const Mask& image) {
    std::vector<Point2i> pixels;
    for (int y = 0; y < image.height(); ++y) {
        const std::uint8_t* row = image.row(y);
        for (int x = 0; x < image.width(); ++x)
            if (row[x]) pixels.push_back({x, y});
    }
    return pixels;
}

inline int neighbour_count(unsigned neighbourhood) { return std::popcount(neighbourhood); }

// The end of a line: at most one neighbour, or two side by side, as at the end of a staircase (which would
// else be eaten up from there).
inline bool is_line_end(unsigned neighbourhood) {
    if (neighbour_count(neighbourhood) < 2) return true;
    const unsigned turned = (neighbourhood >> 1 | neighbourhood << 7) & 255u;
    return neighbour_count(neighbourhood) == 2 && (neighbourhood & turned) != 0;
}

// Yokoi's connectivity number for an 8-connected foreground (Yokoi, Toriwaki & Fukumura 1975): the number of
// 8-components of the neighbours that an edge neighbour of background separates. A pixel whose number is 1
// can be removed without changing how many components and holes there are.
inline int connectivity_number(unsigned neighbourhood) {
    const auto p = [neighbourhood](unsigned k) { return (neighbourhood >> (k & 7u)) & 1u; };
    int number = 0;
    for (unsigned k = 0; k < 8; k += 2) number += !p(k) && (p(k + 1) || p(k + 2));
    return number;
}

} // namespace pantin
