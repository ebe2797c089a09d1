// SPDX-License-Identifier: MIT
// What the decoders of films share: when a file is refused.
#include "export/decode_film.hpp"

#include "pantin/error.hpp"
#include "pantin/image.hpp"

namespace pantin {

void damaged_film(const std::string& source, const char* kind) {
    throw Error(ErrorKind::input, source + ": is damaged or no " + kind);
}

void check_film_size(long width, long height, const std::string& source) {
    if (width * height > max_image_pixels) damaged_film(source, "film of ours: it is too large");
}

} // namespace pantin
