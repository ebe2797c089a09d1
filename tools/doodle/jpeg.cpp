// SPDX-License-Identifier: MIT
// Pixels in, baseline JPEG bytes out, by stb_image_write.
#include <cstddef>

#include "doodle/doodle.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace pantin::doodle {

std::vector<unsigned char> encode_jpeg(const RgbImage& picture, int quality) {
    std::vector<unsigned char> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<unsigned char>*>(context);
        const auto* from = static_cast<const unsigned char*>(data);
        out.insert(out.end(), from, from + size);
    };
    stbi_write_jpg_to_func(append, &bytes, picture.width(), picture.height(), 3, picture.data(), quality);
    return bytes;
}

} // namespace pantin::doodle
