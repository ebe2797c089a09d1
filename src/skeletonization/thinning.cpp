// SPDX-License-Identifier: MIT
// Thinning to one pixel: Zhang & Suen, "A fast parallel algorithm for thinning digital patterns", 1984, as
// Algorithm 4.1 of the thesis, with its misprints mended (B(P_1) for B(P_0), M cleared before each
// sub-iteration, the second one with C_c' and C_d'); then the staircase pixels that it leaves are removed,
// because each would count as a junction. Pixels outside the image are 0.
#include "pantin/skeletonization.hpp"

#include <array>
#include <bit>
#include <utility>

#include "skeletonization/bit_tiles.hpp"
#include "skeletonization/neighbourhood.hpp"

namespace pantin {
namespace {

// The pixels of a tile that fulfil C_a to C_d (C_c' and C_d' in the second sub-iteration).
Tile deletable(Tile tile, const NeighbourTiles& n, bool second) {
    const std::array<Tile, 8> p = {n.north, n.north_east, n.east, n.south_east,
                                   n.south, n.south_west, n.west, n.north_west};
    // Steps from 0 to 1 on the way round: A(P_1) = 1 where there is one. Then the neighbours that are 1 lie
    // side by side, and so do the others: B(P_1) ≥ 2 where two ones are side by side, ≤ 6 where two zeros
    // are.
    Tile one = 0, more = 0, ones = 0, zeros = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Tile a = p[i], b = p[(i + 1) % p.size()], step = ~a & b;
        more |= one & step;
        one |= step;
        ones |= a & b;
        zeros |= ~(a | b);
    }
    const Tile c_and_d =
        second ? ~(n.north & n.west & (n.east | n.south)) : ~(n.east & n.south & (n.north | n.west));
    return tile & one & ~more & ones & zeros & c_and_d;
}

// Tiles to look at in a sub-iteration, each once.
class Waiting {
public:
    explicit Waiting(std::size_t tiles) : waits_(tiles) {}
    void add(std::size_t tile) {
        if (waits_[tile]) return;
        waits_[tile] = 1;
        tiles_.push_back(tile);
    }
    std::vector<std::size_t> take() {
        for (const std::size_t tile : tiles_) waits_[tile] = 0;
        return std::exchange(tiles_, {});
    }

private:
    std::vector<char> waits_;
    std::vector<std::size_t> tiles_;
};

// Of a sub-iteration: M.
struct Marked {
    std::size_t tile;
    Tile pixels;
};

// Calls add(tile) for the tiles whose pixels have a neighbour among those.
template <class Add> void for_each_touched(const BitTiles& tiles, const Marked& marked, const Add& add) {
    const std::size_t at = marked.tile, stride = tiles.stride();
    const Tile pixels = marked.pixels;
    add(at);
    if (pixels & tile_row(0)) add(at - stride);
    if (pixels & tile_row(7)) add(at + stride);
    if (pixels & tile_column(0)) add(at - 1);
    if (pixels & tile_column(7)) add(at + 1);
    if (pixels & tile_row(0) & tile_column(0)) add(at - stride - 1);
    if (pixels & tile_row(0) & tile_column(7)) add(at - stride + 1);
    if (pixels & tile_row(7) & tile_column(0)) add(at + stride - 1);
    if (pixels & tile_row(7) & tile_column(7)) add(at + stride + 1);
}

} // namespace

// A pixel that stays in a sub-iteration stays in the next one of its kind, too, unless a neighbour has gone
// since. So only tiles next to deleted pixels are looked at again.
Thinning zhang_suen_steps(const Mask& mask, ThinningStop stop) {
    Thinning result{mask, Grid<std::uint16_t>(mask.width(), mask.height())};
    BitTiles tiles(mask);
    std::array<Waiting, 2> waiting = {Waiting(tiles.size()), Waiting(tiles.size())};
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (tiles[i])
            for (Waiting& kind : waiting) kind.add(i);
    const auto erase = [&](const Marked& marked, std::uint16_t step) {
        const int x = 8 * tiles.x_of(marked.tile), y = 8 * tiles.y_of(marked.tile);
        tiles[marked.tile] &= ~marked.pixels;
        for (Tile rest = marked.pixels; rest; rest &= rest - 1) {
            const int bit = std::countr_zero(rest);
            result.thinned(x + bit % 8, y + bit / 8) = 0;
            result.removed_in(x + bit % 8, y + bit / 8) = step;
        }
        for_each_touched(tiles, marked, [&](std::size_t tile) {
            if (tiles[tile])
                for (Waiting& kind : waiting) kind.add(tile);
        });
    };
    std::uint16_t step = 0;
    std::vector<Marked> marked;
    for (bool changed = true; changed;) {
        changed = false;
        for (const bool second : {false, true}) {
            ++step;
            marked.clear();
            for (const std::size_t tile : waiting[second].take())
                if (const Tile pixels = deletable(tiles[tile], tiles.neighbours(tile), second))
                    marked.push_back({tile, pixels});
            for (const Marked& m : marked) erase(m, step);
            if (stop == ThinningStop::either && marked.empty()) return result; // lines 11 and 21
            changed |= !marked.empty();
        }
    }
    return result;
}

Mask zhang_suen(const Mask& mask, ThinningStop stop) { return zhang_suen_steps(mask, stop).thinned; }

Mask remove_redundant_pixels(const Mask& skeleton) {
    Mask image = skeleton;
    std::vector<Point2i> foreground = foreground_pixels(image);
    const auto redundant = [&image](Point2i p) {
        const unsigned n = neighbourhood(image, p.x, p.y);
        if (is_line_end(n) || connectivity_number(n) != 1) return false;
        image(p.x, p.y) = 0;
        return true;
    };
    while (std::erase_if(foreground, redundant) > 0) {
    }
    return image;
}

} // namespace pantin
