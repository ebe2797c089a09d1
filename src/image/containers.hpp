// SPDX-License-Identifier: MIT
// What stands in the containers around the pixels of a picture file: dimensions, orientation, and whether the
// file is whole. stb_image decodes damaged files without complaint (it checks no PNG checksum and pads a
// truncated JPEG with grey), so the containers are walked here first, with every read bounds-checked.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace pantin {

enum class Container { unknown, png, jpeg, webp, gif, bmp };

struct ContainerInfo {
    Container kind = Container::unknown;
    std::uint32_t width = 0, height = 0; // as in the header, before orientation
    int orientation = 1;                 // EXIF tag 0x0112 of a PNG, JPEG or WebP, 1 … 8
    std::string problem; // empty when the file is whole, else what is wrong: "ends early", …
};

// Checks the signature, the header and the structure; decodes no pixel.
ContainerInfo read_container(std::span<const unsigned char> bytes);

// The orientation in a TIFF structure (the part of an APP1 segment after "Exif\0\0"): first directory, tag
// 0x0112. Anything malformed counts as 1, upright (EXIF 2.3, section 4.6.2).
int exif_orientation(std::span<const unsigned char> tiff);

} // namespace pantin
