// SPDX-License-Identifier: MIT
// WebP: the structure of a file; and its pixels, in a build with libwebp (webp/).
#pragma once

#include "image/bytes.hpp"
#include "image/containers.hpp"
#include "pantin/grid.hpp"

namespace pantin {

ContainerInfo read_webp(ByteView bytes);
// Whether this build can decode it.
bool webp_pictures_available();
// Of a file in which read_webp() found no problem: the picture, or the first of an animation. Empty when it
// cannot be decoded.
RgbaImage decode_webp_picture(ByteView bytes);

} // namespace pantin
