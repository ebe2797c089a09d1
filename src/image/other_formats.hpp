// SPDX-License-Identifier: MIT
// Formats of pictures and documents that are known by their first bytes, but not read.
#pragma once

#include <string>

#include "image/bytes.hpp"

namespace pantin {

// "is a TIFF image, which is not read; convert it: convert page.tif page.png". Empty for bytes of no such
// format.
std::string other_format(ByteView bytes, const std::string& file);

// The advice alone, "convert it: …", for a format of which only some kinds are read: IN, OUT in the command
// stand for the files.
std::string convert_it(const std::string& command, const std::string& file);

} // namespace pantin
