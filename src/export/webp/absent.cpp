// SPDX-License-Identifier: MIT
// Built without libwebp (`make WEBP=0`): no such films are written or read.
#include "export/decode_film.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"

namespace pantin {

bool webp_available() { return false; }

std::vector<unsigned char> encode_webp(const std::vector<RgbaImage>&, double, std::optional<int>, int) {
    throw Error(ErrorKind::usage, "this pantin was built without WebP (make WEBP=1)");
}

DecodedFilm decode_webp(std::span<const unsigned char>, const std::string& source) {
    throw Error(ErrorKind::input, source + ": this pantin was built without WebP (make WEBP=1)");
}

} // namespace pantin
