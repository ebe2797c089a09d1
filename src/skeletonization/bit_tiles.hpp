// SPDX-License-Identifier: MIT
// A mask as tiles of 8×8 bits, so that one instruction works on 64 pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pantin/grid.hpp"

namespace pantin {

// Bit 8·y + x of a tile is its pixel (x, y).
using Tile = std::uint64_t;

inline constexpr Tile tile_column(int x) { return Tile{0x0101010101010101} << x; }
inline constexpr Tile tile_row(int y) { return Tile{0xff} << (8 * y); }

// For each pixel of a tile one of its eight neighbours, in the place of the pixel; P_2 … P_9 of Figure 4.10.
struct NeighbourTiles {
    Tile north, north_east, east, south_east, south, south_west, west, north_west;
};

// A frame of empty tiles is around those of the mask: every tile of the mask has eight tiles about it.
class BitTiles {
public:
    explicit BitTiles(const Mask& mask)
        : across_((mask.width() + 7) / 8), down_((mask.height() + 7) / 8),
          tiles_(static_cast<std::size_t>(across_ + 2) * (down_ + 2)) {
        for (int y = 0; y < mask.height(); ++y) {
            const std::uint8_t* const pixels = mask.row(y);
            Tile* const tile = tiles_.data() + index(0, y / 8);
            for (int x = 0; x < across_; ++x)
                tile[x] |= bits_of(pixels + 8 * x, std::min(8, mask.width() - 8 * x)) << (8 * (y % 8));
        }
    }

    int across() const { return across_; } // without the frame
    int down() const { return down_; }
    std::size_t size() const { return tiles_.size(); } // with it
    // Of the tile with the pixel (8·x, 8·y).
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y + 1) * stride() + x + 1; }
    int x_of(std::size_t index) const { return static_cast<int>(index % stride()) - 1; }
    int y_of(std::size_t index) const { return static_cast<int>(index / stride()) - 1; }
    std::size_t stride() const { return static_cast<std::size_t>(across_) + 2; } // from a row to the next one

    Tile& operator[](std::size_t index) { return tiles_[index]; }
    Tile operator[](std::size_t index) const { return tiles_[index]; }

    NeighbourTiles neighbours(std::size_t index) const {
        const Tile* const at = tiles_.data() + index;
        const Tile* const above = at - stride();
        const Tile* const below = at + stride();
        const Tile east = shifted_west(at[0], at[1]), west = shifted_east(at[0], at[-1]);
        return {at[0] << 8 | above[0] >> 56,
                east << 8 | shifted_west(above[0], above[1]) >> 56,
                east,
                east >> 8 | shifted_west(below[0], below[1]) << 56,
                at[0] >> 8 | below[0] << 56,
                west >> 8 | shifted_east(below[0], below[-1]) << 56,
                west,
                west << 8 | shifted_east(above[0], above[-1]) >> 56};
    }

private:
    // Bit k: whether pixel k is not 0.
    static Tile bits_of(const std::uint8_t* pixels, int count) {
        std::uint64_t bytes = 0;
        if (count == 8)
            for (int k = 0; k < 8; ++k) bytes |= static_cast<std::uint64_t>(pixels[k]) << (8 * k);
        else
            for (int k = 0; k < count; ++k) bytes |= static_cast<std::uint64_t>(pixels[k]) << (8 * k);
        bytes |= bytes >> 4;
        bytes |= bytes >> 2;
        bytes |= bytes >> 1;
        // Bit 8k times 2^(56 − 7k) is bit 56 + k.
        return (bytes & tile_column(0)) * 0x0102040810204080 >> 56;
    }
    static Tile shifted_west(Tile tile, Tile next) {
        return (tile & ~tile_column(0)) >> 1 | (next & tile_column(0)) << 7;
    }
    static Tile shifted_east(Tile tile, Tile next) {
        return (tile & ~tile_column(7)) << 1 | (next & tile_column(7)) >> 7;
    }

    int across_, down_;
    std::vector<Tile> tiles_;
};

} // namespace pantin
