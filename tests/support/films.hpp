// Decoded animations, for tests.
#pragma once

#include <vector>

#include "pantin/grid.hpp"

namespace pantin::test {

struct Film {
    std::vector<RgbaImage> frames; // as shown; colours under alpha 0 are 0
    std::vector<int> delays;       // WebP: milliseconds, GIF: hundredths of a second
    bool loops_for_ever = false;
    bool disposes_to_background = true; // GIF: every frame
};

#ifdef PANTIN_WEBP
Film read_webp(const std::vector<unsigned char>& bytes);
#endif
#ifdef PANTIN_GIF
Film read_gif(const std::vector<unsigned char>& bytes);
#endif

} // namespace pantin::test
