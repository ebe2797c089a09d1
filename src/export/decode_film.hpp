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

// A film's bytes to its frames. Error(input) names `source` when the bytes are damaged, or when this program
// was built without the library (webp_available, gif_available). GIF frames are taken as whole pictures,
// which is how encode_gif makes them.
DecodedFilm decode_webp(std::span<const unsigned char> bytes, const std::string& source);
DecodedFilm decode_gif(std::span<const unsigned char> bytes, const std::string& source);

// For the decoders. Error(input): `source` is damaged or no `kind`.
[[noreturn]] void damaged_film(const std::string& source, const char* kind);
// Error(input) when a frame of width x height pixels is larger than any film of ours.
void check_film_size(long width, long height, const std::string& source);

} // namespace pantin
