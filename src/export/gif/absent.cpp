// SPDX-License-Identifier: MIT
// Built without giflib (`make GIF=0`): no such films are written or read.
#include "export/decode_film.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"

namespace pantin {

bool gif_available() { return false; }

std::vector<unsigned char> encode_gif(const std::vector<RgbaImage>&, double, int) {
    throw Error(ErrorKind::usage, "this pantin was built without GIF (make GIF=1)");
}

DecodedFilm decode_gif(std::span<const unsigned char>, const std::string& source) {
    throw Error(ErrorKind::input, source + ": this pantin was built without GIF (make GIF=1)");
}

} // namespace pantin
