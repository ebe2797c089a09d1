// SPDX-License-Identifier: MIT
// PNG or JPEG bytes in, pixels out: checked by containers.cpp, decoded by stb_image, turned by its EXIF
// orientation.
#include <cstdlib>
#include <memory>
#include <string>

#include "core/file.hpp"
#include "image/containers.hpp"
#include "image/stb.hpp"
#include "pantin/image.hpp"

#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace pantin {

static_assert(STBI_MAX_DIMENSIONS == max_image_side);

namespace {

struct FreePixels {
    void operator()(unsigned char* pixels) const { stbi_image_free(pixels); }
};
using Pixels = std::unique_ptr<unsigned char, FreePixels>;

using Bytes = std::span<const unsigned char>;

[[noreturn]] void invalid(const std::string& source, const std::string& fact) {
    throw Error(ErrorKind::input, source + ": " + fact);
}

// Everything that can be known before a pixel is decoded: kind, dimensions, completeness.
ContainerInfo check_container(const std::string& source, Bytes bytes, int min_side) {
    if (bytes.empty()) invalid(source, "is empty");
    const ContainerInfo info = read_container(bytes);
    if (info.kind == Container::unknown) invalid(source, "is neither a PNG nor a JPEG image");
    const std::string size = std::to_string(info.width) + "x" + std::to_string(info.height);
    const auto side_limit = static_cast<std::uint32_t>(max_image_side);
    if (info.width > side_limit || info.height > side_limit)
        invalid(source, "is " + size + " pixels; the limit is " + std::to_string(max_image_side) + " a side");
    if (std::uint64_t{info.width} * info.height > static_cast<std::uint64_t>(max_image_pixels))
        invalid(source, "is " + size + " pixels; the limit is " +
                            std::to_string(max_image_pixels / 1'000'000) + " megapixels");
    if (!info.problem.empty()) invalid(source, info.problem);
    const auto smallest = static_cast<std::uint32_t>(min_side);
    if (info.width < smallest || info.height < smallest)
        invalid(source, "is " + size + " pixels; the smallest side allowed is " + std::to_string(min_side));
    return info;
}

Pixels decode(const std::string& source, Bytes bytes, const ContainerInfo& info, int channels) {
    int width = 0, height = 0, in_file = 0;
    stbi__g_failure_reason = nullptr; // not that of the picture before
    Pixels pixels(stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height,
                                        &in_file, channels));
    if (!pixels) {
        const char* reason = stbi_failure_reason(); // null where the decoder gives none
        invalid(source, std::string("cannot be decoded: ") + (reason ? reason : "its data is damaged"));
    }
    if (static_cast<std::uint32_t>(width) != info.width || static_cast<std::uint32_t>(height) != info.height)
        invalid(source, "cannot be decoded: its headers disagree on the dimensions");
    return pixels;
}

std::uint8_t over_white(unsigned value, unsigned alpha) {
    return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
}

RgbImage composite_on_white(const unsigned char* rgba, int width, int height) {
    RgbImage image(width, height);
    for (Rgb8& pixel : image) {
        pixel = {over_white(rgba[0], rgba[3]), over_white(rgba[1], rgba[3]), over_white(rgba[2], rgba[3])};
        rgba += 4;
    }
    return image;
}

RgbImage copy_rgb(const unsigned char* rgb, int width, int height) {
    RgbImage image(width, height);
    for (Rgb8& pixel : image) {
        pixel = {rgb[0], rgb[1], rgb[2]};
        rgb += 3;
    }
    return image;
}

// Turns the stored picture upright. EXIF 2.3, tag 0x0112: where the stored row 0 and column 0 belong.
template <class Image> Image apply_orientation(Image stored, int orientation) {
    if (orientation == 1) return stored;
    const int w = stored.width(), h = stored.height();
    const bool swaps = orientation >= 5;
    Image upright(swaps ? h : w, swaps ? w : h);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            Point2i to{x, y};
            switch (orientation) {
            case 2:
                to = {w - 1 - x, y};
                break; // mirrored left–right
            case 3:
                to = {w - 1 - x, h - 1 - y};
                break; // half a turn
            case 4:
                to = {x, h - 1 - y};
                break; // mirrored top–bottom
            case 5:
                to = {y, x};
                break; // transposed
            case 6:
                to = {h - 1 - y, x};
                break; // shown after a quarter turn clockwise
            case 7:
                to = {h - 1 - y, w - 1 - x};
                break; // transposed along the other diagonal
            default:
                to = {y, w - 1 - x};
                break; // 8: after a quarter turn counter-clockwise
            }
            upright(to.x, to.y) = stored(x, y);
        }
    }
    return upright;
}

} // namespace

namespace {

// The EXIF orientation of a turn.
int orientation_of(int degrees) {
    switch (degrees) {
    case 0:
        return 1;
    case 90:
        return 6;
    case 180:
        return 3;
    case 270:
        return 8;
    default:
        throw Error(ErrorKind::usage, "an image can be turned by 0, 90, 180 or 270 degrees");
    }
}

} // namespace

RgbImage turned(RgbImage image, int degrees) {
    return apply_orientation(std::move(image), orientation_of(degrees));
}
GreyImage turned(GreyImage image, int degrees) {
    return apply_orientation(std::move(image), orientation_of(degrees));
}
RgbaImage turned(RgbaImage image, int degrees) {
    return apply_orientation(std::move(image), orientation_of(degrees));
}

RgbImage composite_on_white(const RgbaImage& image) {
    RgbImage out(image.width(), image.height());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Rgba8 p = image.data()[i];
        out.data()[i] = {over_white(p.r, p.a), over_white(p.g, p.a), over_white(p.b, p.a)};
    }
    return out;
}

RgbaImage load_rgba(const std::filesystem::path& file, int min_side) {
    const std::vector<unsigned char> bytes = read_file(file);
    const ContainerInfo info = check_container(file.string(), bytes, min_side);
    if (info.kind == Container::png) return decode_rgba(bytes, file.string());
    const RgbImage opaque = decode_image(bytes, file.string(), min_side);
    RgbaImage image(opaque.width(), opaque.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb8 p = opaque.data()[i];
        image.data()[i] = {p.r, p.g, p.b, 255};
    }
    return image;
}

RgbImage decode_image(Bytes bytes, const std::string& source, int min_side) {
    const ContainerInfo info = check_container(source, bytes, min_side);
    const int width = static_cast<int>(info.width), height = static_cast<int>(info.height);
    if (info.kind == Container::png) // 16-bit samples keep their high byte, palettes are looked up
        return composite_on_white(decode(source, bytes, info, STBI_rgb_alpha).get(), width, height);
    return apply_orientation(copy_rgb(decode(source, bytes, info, STBI_rgb).get(), width, height),
                             info.orientation);
}

RgbaImage decode_rgba(Bytes bytes, const std::string& source) {
    const ContainerInfo info = check_container(source, bytes, 1);
    if (info.kind != Container::png) invalid(source, "is not a PNG image");
    const Pixels pixels = decode(source, bytes, info, STBI_rgb_alpha);
    RgbaImage image(static_cast<int>(info.width), static_cast<int>(info.height));
    const unsigned char* rgba = pixels.get();
    for (Rgba8& pixel : image) {
        pixel = {rgba[0], rgba[1], rgba[2], rgba[3]};
        rgba += 4;
    }
    return image;
}

GreyImage decode_grey(Bytes bytes, const std::string& source) {
    const RgbaImage stored = decode_rgba(bytes, source);
    GreyImage image(stored.width(), stored.height());
    auto value = image.begin();
    for (const Rgba8& pixel : stored) {
        if (pixel.r != pixel.g || pixel.g != pixel.b) invalid(source, "has colours; values must be grey");
        *value++ = pixel.a == 0 ? 0 : pixel.r;
    }
    return image;
}

RgbImage load_image(const std::filesystem::path& file, int min_side) {
    return decode_image(read_file(file), file.string(), min_side);
}

GreyImage load_grey(const std::filesystem::path& file) { return decode_grey(read_file(file), file.string()); }

} // namespace pantin
