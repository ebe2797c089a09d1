// SPDX-License-Identifier: MIT
// BMP: the header, and the pixels of files whose header was found right.
#pragma once

#include "image/bytes.hpp"
#include "image/containers.hpp"
#include "pantin/grid.hpp"

namespace pantin {

// Whether it begins like a BMP: two letters alone could begin a text.
bool is_bmp(ByteView bytes);
ContainerInfo read_bmp(ByteView bytes);
// Of a file in which read_bmp() found no problem.
RgbaImage decode_bmp_picture(ByteView bytes);

} // namespace pantin
