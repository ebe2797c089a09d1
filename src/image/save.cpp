// SPDX-License-Identifier: MIT
// Pixels in, PNG bytes out, by stb_image_write.
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/file.hpp"
#include "image/stb.hpp"
#include "pantin/image.hpp"

// It checks every match that it looks at, which takes as long as the search.
#define STBIW_ASSERT(condition) ((void)0)
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace pantin {

namespace {

// The writer's setting is global; 5 instead of 8 takes half the time for files of the same size.
[[maybe_unused]] const int compression = stbi_write_png_compression_level = 5;

struct FreeBytes {
    void operator()(unsigned char* bytes) const { std::free(bytes); }
};

template <class Pixel> std::vector<unsigned char> encode(const Grid<Pixel>& image) {
    constexpr int channels = sizeof(Pixel);
    static_assert(channels == 1 || channels == 3 || channels == 4);
    if (image.empty()) throw Error(ErrorKind::internal, "an empty image cannot be encoded as PNG");
    int length = 0;
    const auto* data = reinterpret_cast<const unsigned char*>(image.data());
    const std::unique_ptr<unsigned char, FreeBytes> png(stbi_write_png_to_mem(
        data, image.width() * channels, image.width(), image.height(), channels, &length));
    if (!png) throw Error(ErrorKind::internal, "out of memory while encoding a PNG");
    return std::vector<unsigned char>(png.get(), png.get() + length);
}

} // namespace

std::vector<unsigned char> encode_png(const GreyImage& image) { return encode(image); }
std::vector<unsigned char> encode_png(const RgbImage& image) { return encode(image); }
std::vector<unsigned char> encode_png(const RgbaImage& image) { return encode(image); }

void save_png(const std::filesystem::path& file, const GreyImage& image) { write_file(file, encode(image)); }
void save_png(const std::filesystem::path& file, const RgbImage& image) { write_file(file, encode(image)); }
void save_png(const std::filesystem::path& file, const RgbaImage& image) { write_file(file, encode(image)); }

} // namespace pantin
