// SPDX-License-Identifier: MIT
// One palette for all frames of an animation.
#pragma once

#include <cstdint>
#include <vector>

#include "pantin/grid.hpp"

namespace pantin {

// Pixels of at least this alpha are drawn, the others are transparent.
inline constexpr std::uint8_t opaque_alpha = 128;

class Palette {
public:
    // At most `size` colours for the opaque pixels of the frames.
    Palette(const std::vector<RgbaImage>& frames, int size);

    const std::vector<Rgb8>& colours() const { return colours_; }
    // Index of the entry for a colour of the frames.
    std::uint8_t index_of(Rgba8 colour) const;

private:
    std::vector<Rgb8> colours_;
    std::vector<std::uint8_t> entry_of_bin_; // per 6-bit colour
};

} // namespace pantin
