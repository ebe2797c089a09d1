// SPDX-License-Identifier: MIT
// GIF: the structure of a file, and the pixels of its first picture.
#pragma once

#include <string>

#include "image/bytes.hpp"
#include "image/containers.hpp"
#include "pantin/grid.hpp"

namespace pantin {

ContainerInfo read_gif(ByteView bytes);
// Of a file in which read_gif() found no problem. What the first picture does not cover is transparent, as in
// browsers. Empty when its data are damaged.
RgbaImage decode_gif_picture(ByteView bytes);

} // namespace pantin
