// SPDX-License-Identifier: MIT
// PNG and JPEG files made by the tests, byte by byte.
#include "image_files.hpp"

#include <unistd.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace pantin::test {

Bytes make_jpeg(const RgbImage& image, int quality) {
    Bytes out;
    const auto sink = [](void* context, void* data, int size) {
        const auto* bytes = static_cast<unsigned char*>(data);
        static_cast<Bytes*>(context)->insert(static_cast<Bytes*>(context)->end(), bytes, bytes + size);
    };
    stbi_write_jpg_to_func(sink, &out, image.width(), image.height(), 3, image.data(), quality);
    return out;
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "pantin-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
}
TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace pantin::test
