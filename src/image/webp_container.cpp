// SPDX-License-Identifier: MIT
// The chunks of a WebP file: RFC 9649, sections 2.3–2.7 (container), 3 (lossless header) and RFC 6386,
// section 9.1 (lossy header).
#include "image/webp.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t side_mask = (1u << 14) - 1;

// The dimensions in a chunk that has some; the first such chunk says those of the whole picture.
void read_dimensions(ByteView type, ByteView data, ContainerInfo& info) {
    if (info.width != 0) return;
    Cursor cursor(data);
    if (has_at(type, 0, "VP8X")) {
        cursor.skip(4);
        info.width = cursor.u24() + 1;
        info.height = cursor.u24() + 1;
    } else if (has_at(type, 0, "VP8L") && has_at(data, 0, "\x2f")) {
        cursor.skip(1);
        const std::uint32_t bits = cursor.u32();
        info.width = (bits & side_mask) + 1;
        info.height = (bits >> 14 & side_mask) + 1;
    } else if (has_at(type, 0, "VP8 ") && has_at(data, 3, "\x9d\x01\x2a")) {
        cursor.skip(6);
        info.width = cursor.u16() & side_mask;
        info.height = cursor.u16() & side_mask;
    }
    if (cursor.ended()) info.width = info.height = 0;
}

// Some programs leave the name of a JPEG's segment before the structure.
ByteView tiff_of(ByteView data) {
    constexpr std::string_view name("Exif\0\0", 6);
    return has_at(data, 0, name) ? data.subspan(name.size()) : data;
}

} // namespace

ContainerInfo read_webp(ByteView bytes) {
    ContainerInfo info;
    info.kind = Container::webp;
    const auto ends_early = "the WebP ends early (truncated)";
    Cursor cursor(bytes);
    cursor.skip(4);
    const std::uint32_t size = cursor.u32(); // of what follows
    if (size < 4 || size > cursor.left()) return info.problem = ends_early, info;
    cursor = Cursor(bytes.first(8 + std::size_t{size}), 12);
    bool has_picture = false;
    while (cursor.left() > 0) {
        const ByteView type = cursor.take(4);
        const std::uint32_t length = cursor.u32();
        const ByteView data = cursor.take(length);
        if (length % 2 != 0 && cursor.left() > 0) cursor.skip(1);
        if (cursor.ended()) return info.problem = "the WebP is damaged (its chunks)", info;
        read_dimensions(type, data, info);
        has_picture |= has_at(type, 0, "VP8 ") || has_at(type, 0, "VP8L") || has_at(type, 0, "ANMF");
        if (has_at(type, 0, "EXIF")) info.orientation = exif_orientation(tiff_of(data));
    }
    if (!has_picture || info.width == 0) info.problem = "the WebP has no picture";
    return info;
}

} // namespace pantin
