// SPDX-License-Identifier: MIT
// The bytes of a picture file in, pixels out: checked by containers.cpp, decoded by stb_image (PNG, JPEG),
// libwebp or our own code (GIF, BMP), turned by its EXIF orientation.
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "core/file.hpp"
#include "image/bmp.hpp"
#include "image/bytes.hpp"
#include "image/containers.hpp"
#include "image/gif.hpp"
#include "image/other_formats.hpp"
#include "image/stb.hpp"
#include "image/webp.hpp"
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

[[noreturn]] void invalid(const std::string& source, const std::string& fact) {
    throw Error(ErrorKind::input, source + ": " + fact);
}

// Everything that can be known before a pixel is decoded: kind, dimensions, completeness.
ContainerInfo check_container(const std::string& source, ByteView bytes, int min_side) {
    if (bytes.empty()) invalid(source, "is empty");
    const ContainerInfo info = read_container(bytes);
    if (info.kind == Container::unknown) {
        const std::string known = other_format(bytes, source);
        invalid(source, known.empty() ? "is neither a PNG, JPEG, WebP, GIF nor BMP image" : known);
    }
    const std::string size = std::to_string(info.width) + "x" + std::to_string(info.height);
    const auto side_limit = static_cast<std::uint32_t>(max_image_side);
    if (info.width > side_limit || info.height > side_limit)
        invalid(source, "is " + size + " pixels; the limit is " + std::to_string(max_image_side) + " a side");
    if (std::uint64_t{info.width} * info.height > static_cast<std::uint64_t>(max_image_pixels))
        invalid(source, "is " + size + " pixels; the limit is " +
                            std::to_string(max_image_pixels / 1'000'000) + " megapixels");
    if (info.kind == Container::webp && !webp_pictures_available())
        invalid(source, "is a WebP image, and this pantin was built without WebP (make WEBP=1); " +
                            convert_it("dwebp IN -o OUT", source));
    if (!info.problem.empty()) invalid(source, info.problem);
    const auto smallest = static_cast<std::uint32_t>(min_side);
    if (info.width < smallest || info.height < smallest)
        invalid(source, "is " + size + " pixels; the smallest side allowed is " + std::to_string(min_side));
    return info;
}

// stb_image: 16-bit samples keep their high byte, palettes are looked up.
RgbaImage decode_png_or_jpeg(const std::string& source, ByteView bytes) {
    int width = 0, height = 0, in_file = 0;
    stbi__g_failure_reason = nullptr; // not that of the picture before
    const Pixels pixels(stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height,
                                              &in_file, STBI_rgb_alpha));
    if (!pixels) {
        const char* reason = stbi_failure_reason(); // null where the decoder gives none
        invalid(source, std::string("cannot be decoded: ") + (reason ? reason : "its data is damaged"));
    }
    RgbaImage image(width, height);
    std::memcpy(image.data(), pixels.get(), image.size() * sizeof(Rgba8));
    return image;
}

// The picture as it is stored; its container was checked.
RgbaImage decode(const std::string& source, ByteView bytes, const ContainerInfo& info) {
    RgbaImage image;
    if (info.kind == Container::webp)
        image = decode_webp_picture(bytes);
    else if (info.kind == Container::gif)
        image = decode_gif_picture(bytes);
    else if (info.kind == Container::bmp)
        image = decode_bmp_picture(bytes);
    else
        image = decode_png_or_jpeg(source, bytes);
    if (image.size() == 0) invalid(source, "cannot be decoded: its data is damaged");
    if (static_cast<std::uint32_t>(image.width()) != info.width ||
        static_cast<std::uint32_t>(image.height()) != info.height)
        invalid(source, "cannot be decoded: its headers disagree on the dimensions");
    return image;
}

std::uint8_t over_white(unsigned value, unsigned alpha) {
    return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
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
RgbImage inverted(RgbImage image) {
    for (Rgb8& p : image)
        p = {static_cast<std::uint8_t>(255 - p.r), static_cast<std::uint8_t>(255 - p.g),
             static_cast<std::uint8_t>(255 - p.b)};
    return image;
}
GreyImage inverted(GreyImage image) {
    for (std::uint8_t& value : image) value = static_cast<std::uint8_t>(255 - value);
    return image;
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

namespace {
RgbaImage decode_upright(ByteView bytes, const std::string& source, int min_side) {
    const ContainerInfo info = check_container(source, bytes, min_side);
    return apply_orientation(decode(source, bytes, info), info.orientation);
}
} // namespace

RgbImage decode_image(ByteView bytes, const std::string& source, int min_side) {
    return composite_on_white(decode_upright(bytes, source, min_side));
}

RgbaImage decode_rgba(ByteView bytes, const std::string& source) {
    const ContainerInfo info = check_container(source, bytes, 1);
    if (info.kind != Container::png) invalid(source, "is not a PNG image");
    return decode(source, bytes, info);
}

GreyImage decode_grey(ByteView bytes, const std::string& source) {
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

RgbaImage load_rgba(const std::filesystem::path& file, int min_side) {
    return decode_upright(read_file(file), file.string(), min_side);
}

GreyImage load_grey(const std::filesystem::path& file) { return decode_grey(read_file(file), file.string()); }

} // namespace pantin
