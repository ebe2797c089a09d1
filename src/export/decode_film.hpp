// SPDX-License-Identifier: MIT
// Films back to frames: for comparing results, and for tests.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pantin/grid.hpp"

namespace pantin {

struct DecodedFilm {
    std::vector<RgbaImage> frames; // as shown; colours under alpha 0 are 0
    std::vector<int> delays;       // WebP: milliseconds, GIF: hundredths of a second
    bool loops_for_ever = false;
    bool disposes_to_background = true; // GIF: every frame
};

// Error(input) names `source` when the bytes are damaged. GIF frames are taken as whole pictures, which is
// how encode_gif makes them.
#ifdef PANTIN_WEBP
DecodedFilm decode_webp(std::span<const unsigned char> bytes, const std::string& source);
#endif
#ifdef PANTIN_GIF
DecodedFilm decode_gif(std::span<const unsigned char> bytes, const std::string& source);
#endif

} // namespace pantin
