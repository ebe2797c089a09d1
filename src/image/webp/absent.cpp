// SPDX-License-Identifier: MIT
// Built without libwebp (`make WEBP=0`): no such pictures are read.
#include "image/webp.hpp"

namespace pantin {

bool webp_pictures_available() { return false; }

RgbaImage decode_webp_picture(ByteView) { return {}; }

} // namespace pantin
