// SPDX-License-Identifier: MIT
// Decoded animations, for tests.
#pragma once

#include <vector>

#include "export/decode_film.hpp"

namespace pantin::test {

using Film = DecodedFilm;

inline Film read_webp(const std::vector<unsigned char>& bytes) { return decode_webp(bytes, "film.webp"); }
inline Film read_gif(const std::vector<unsigned char>& bytes) { return decode_gif(bytes, "film.gif"); }

} // namespace pantin::test
