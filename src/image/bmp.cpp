// SPDX-License-Identifier: MIT
// BMP bytes in, pixels out: 1, 4, 8 (palette), 16, 24 and 32 bits, uncompressed (Microsoft, "Bitmap Storage",
// headers BITMAPCOREHEADER to BITMAPV5HEADER). Ours, because stb_image's decoder shows memory that nothing
// wrote where a pixel's number lies beyond the palette.
#include "image/bmp.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace pantin {

namespace {

constexpr std::uint32_t file_header = 14, core_header = 12;

struct BmpHeader {
    std::uint32_t offset = 0, size = 0; // of the pixels; of the second header
    std::uint32_t width = 0, height = 0, planes = 0, depth = 0, compression = 0, colours = 0;
    bool top_down = false;
    std::array<std::uint32_t, 4> masks{}; // red, green, blue, alpha
    std::uint64_t row_bytes() const { return (std::uint64_t{width} * depth + 31) / 32 * 4; }
};

void read_masks(Cursor& cursor, BmpHeader& header) {
    if (header.compression == 0 && header.depth == 16) header.masks = {31u << 10, 31u << 5, 31u, 0};
    if (header.compression == 0 && header.depth == 32) header.masks = {255u << 16, 255u << 8, 255u, 0};
    if (header.compression != 3 && header.compression != 6) return;
    const bool has_alpha = header.size >= 56 || header.compression == 6;
    for (std::size_t i = 0; i < (has_alpha ? 4u : 3u); ++i) header.masks[i] = cursor.u32();
}

BmpHeader read_header(Cursor& cursor) {
    BmpHeader header;
    cursor.skip(10);
    header.offset = cursor.u32();
    header.size = cursor.u32();
    if (header.size == core_header) {
        header.width = cursor.u16();
        header.height = cursor.u16();
    } else {
        header.width = cursor.u32();
        const std::uint32_t height = cursor.u32();
        header.top_down = (height >> 31) != 0;
        header.height = header.top_down ? 0u - height : height;
    }
    header.planes = cursor.u16();
    header.depth = cursor.u16();
    if (header.size == core_header) return header;
    header.compression = cursor.u32();
    cursor.skip(12);
    header.colours = cursor.u32();
    cursor.skip(4);
    read_masks(cursor, header);
    return header;
}

// The bits of a mask must be neighbours.
bool is_usable(std::uint32_t mask) {
    const std::uint32_t bits = mask == 0 ? 0 : mask >> std::countr_zero(mask);
    return (bits & (bits + 1)) == 0;
}

// One channel of a pixel as 0 … 255.
std::uint8_t channel(std::uint32_t pixel, std::uint32_t mask) {
    if (mask == 0) return 0;
    const int shift = std::countr_zero(mask);
    const std::uint64_t largest = mask >> shift, value = (pixel & mask) >> shift;
    return static_cast<std::uint8_t>((value * 255 + largest / 2) / largest);
}

// As many colours as there can be; those that the file does not have are black.
std::vector<Rgba8> read_palette(ByteView bytes, const BmpHeader& header) {
    const std::size_t entry = header.size == core_header ? 3 : 4, start = file_header + header.size;
    std::vector<Rgba8> palette(std::size_t{1} << header.depth, Rgba8{0, 0, 0, 255});
    const std::size_t fit = (header.offset - start) / entry;
    const std::size_t said = header.colours == 0 ? palette.size() : header.colours;
    Cursor cursor(bytes, start);
    for (std::size_t i = 0; i < std::min({palette.size(), fit, said}); ++i) {
        const ByteView bgr = cursor.take(entry);
        palette[i] = {bgr[2], bgr[1], bgr[0], 255};
    }
    return palette;
}

Rgba8 pixel_of(const BmpHeader& header, const std::vector<Rgba8>& palette, ByteView row, std::size_t x) {
    if (header.depth <= 8) {
        const std::size_t bit = x * header.depth;
        const auto in_byte = static_cast<unsigned>(bit % 8), depth = header.depth;
        return palette[(row[bit / 8] >> (8 - depth - in_byte)) & ((1u << depth) - 1)];
    }
    Cursor cursor(row, x * header.depth / 8);
    if (header.depth == 24) {
        const ByteView bgr = cursor.take(3);
        return {bgr[2], bgr[1], bgr[0], 255};
    }
    const std::uint32_t value = header.depth == 16 ? cursor.u16() : cursor.u32();
    const auto& [red, green, blue, alpha] = header.masks;
    return {channel(value, red), channel(value, green), channel(value, blue),
            alpha == 0 ? std::uint8_t{255} : channel(value, alpha)};
}

// Programs that know no alpha leave it 0 everywhere.
void show_what_is_all_transparent(RgbaImage& image) {
    if (std::any_of(image.begin(), image.end(), [](const Rgba8& pixel) { return pixel.a != 0; })) return;
    for (Rgba8& pixel : image) pixel.a = 255;
}

} // namespace

bool is_bmp(ByteView bytes) {
    Cursor cursor(bytes);
    const BmpHeader header = read_header(cursor);
    const std::array<std::uint32_t, 7> sizes = {12, 40, 52, 56, 64, 108, 124};
    return has_at(bytes, 0, "BM") && bytes.size() >= 18 &&
           std::find(sizes.begin(), sizes.end(), header.size) != sizes.end();
}

ContainerInfo read_bmp(ByteView bytes) {
    Cursor cursor(bytes);
    const BmpHeader header = read_header(cursor);
    ContainerInfo info;
    info.kind = Container::bmp;
    const auto ends_early = "the BMP ends early (truncated)", damaged = "the BMP is damaged (its header)";
    if (cursor.ended()) return info.problem = ends_early, info;
    info.width = header.width;
    info.height = header.height;
    if (header.planes != 1 || header.offset < file_header + header.size || header.compression > 6)
        return info.problem = damaged, info;
    if (header.compression != 0 && header.compression != 3 && header.compression != 6)
        return info.problem = "is a compressed BMP, which is not read; save it without compression", info;
    const bool masked = header.compression != 0;
    const bool known =
        header.depth == 16 || header.depth == 32 ||
        (!masked && (header.depth == 1 || header.depth == 4 || header.depth == 8 || header.depth == 24));
    if (!known || !std::all_of(header.masks.begin(), header.masks.end(), is_usable))
        return info.problem = damaged, info;
    if (header.offset > bytes.size() ||
        header.row_bytes() > (bytes.size() - header.offset) / std::max(header.height, 1u))
        info.problem = ends_early;
    return info;
}

RgbaImage decode_bmp_picture(ByteView bytes) {
    Cursor cursor(bytes);
    const BmpHeader header = read_header(cursor);
    const std::vector<Rgba8> palette = header.depth <= 8 ? read_palette(bytes, header) : std::vector<Rgba8>{};
    RgbaImage image(static_cast<int>(header.width), static_cast<int>(header.height));
    for (int y = 0; y < image.height(); ++y) {
        const int stored = header.top_down ? y : image.height() - 1 - y;
        const ByteView row = bytes.subspan(
            header.offset + static_cast<std::size_t>(stored) * header.row_bytes(), header.row_bytes());
        for (int x = 0; x < image.width(); ++x)
            image(x, y) = pixel_of(header, palette, row, static_cast<std::size_t>(x));
    }
    show_what_is_all_transparent(image);
    return image;
}

} // namespace pantin
