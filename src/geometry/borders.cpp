// SPDX-License-Identifier: MIT
// Border following after Suzuki & Abe, "Topological structural analysis of digitized binary images by border
// following", 1985, Algorithm 1 and Appendix I, with the paper's names: f the picture, NBD the number of the
// border that is being followed, LNBD that of the border last met on the row.
#include "pantin/geometry.hpp"

#include <array>
#include <cmath>

namespace pantin {
namespace {

// The eight neighbours counterclockwise on the screen, from the east.
constexpr std::array<Point2i, 8> direction = {
    {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
constexpr int east = 0, west = 4;

// The picture with a frame of zeros, so that no neighbour lies outside.
Grid<int> framed(const Mask& mask) {
    Grid<int> f(mask.width() + 2, mask.height() + 2);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) f(x + 1, y + 1) = mask(x, y) != 0;
    return f;
}

// Step 3: follows the border that starts at `start` with the zero pixel in direction `from`, marks its pixels
// in f with ±nbd (negative where the pixel's eastern neighbour is outside) and returns them in picture
// coordinates.
std::vector<Point2i> follow(Grid<int>& f, Point2i start, int from, int nbd) {
    const auto step = [](Point2i p, int d) {
        return Point2i{p.x + direction[d & 7].x, p.y + direction[d & 7].y};
    };
    const auto at = [&f](Point2i p) -> int& { return f(p.x, p.y); };

    // (3.1) clockwise from the zero pixel: the first nonzero neighbour, where the border will close.
    int d = from;
    do d = (d + 7) & 7;
    while (d != from && at(step(start, d)) == 0);
    std::vector<Point2i> border;
    if (d == from) { // a single pixel
        at(start) = -nbd;
        border.push_back({start.x - 1, start.y - 1});
        return border;
    }
    const Point2i last = step(start, d);
    for (Point2i p = start;;) {
        // (3.3) counterclockwise from the pixel we came from: the next pixel of the border.
        const int back = d;
        bool east_is_outside = false;
        for (d = back + 1; at(step(p, d)) == 0; ++d) east_is_outside |= (d & 7) == east;
        d &= 7;
        // (3.4)
        if (east_is_outside)
            at(p) = -nbd;
        else if (at(p) == 1)
            at(p) = nbd;
        border.push_back({p.x - 1, p.y - 1});
        // (3.5)
        const Point2i next = step(p, d);
        if (next == start && p == last) return border;
        p = next;
        d = (d + 4) & 7;
    }
}

} // namespace

std::vector<Border> follow_borders(const Mask& mask) {
    Grid<int> f = framed(mask);
    std::vector<Border> borders; // number NBD = index + 2; 1 is the frame, which counts as a hole's border
    for (int y = 1; y <= mask.height(); ++y) {
        int lnbd = 1;
        for (int x = 1; x <= mask.width(); ++x) {
            if (f(x, y) == 0) continue;
            const bool outer = f(x, y) == 1 && f(x - 1, y) == 0;
            const bool hole = !outer && f(x, y) >= 1 && f(x + 1, y) == 0;
            if (outer || hole) {
                if (hole && f(x, y) > 1) lnbd = f(x, y);
                // Step 2, Table 1: the parent is the last border met, or that one's parent when both are of a
                // kind.
                const int met = lnbd - 2;
                const bool met_outer = met >= 0 && borders[met].outer;
                Border border;
                border.outer = outer;
                border.parent = met < 0 || met_outer != outer ? met : borders[met].parent;
                border.points = follow(f, {x, y}, outer ? west : east, static_cast<int>(borders.size()) + 2);
                borders.push_back(std::move(border));
            }
            // Step 4
            if (f(x, y) != 1) lnbd = std::abs(f(x, y));
        }
    }
    return borders;
}

double closed_length(const std::vector<Point2i>& border) {
    // Counted in whole steps, so that the sum does not depend on where the border starts.
    long straight = 0, diagonal = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Point2i a = border[i], b = border[i + 1 < border.size() ? i + 1 : 0];
        const int steps = std::abs(a.x - b.x) + std::abs(a.y - b.y);
        straight += steps == 1;
        diagonal += steps == 2;
    }
    return static_cast<double>(straight) + static_cast<double>(diagonal) * std::sqrt(2.0);
}

} // namespace pantin
