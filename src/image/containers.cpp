// SPDX-License-Identifier: MIT
// PNG: W3C "Portable Network Graphics (PNG) Specification (Third Edition)", sections 5.2–5.6, 11.3.2.5 (eXIf)
// and annex D (checksum). JPEG: ITU-T T.81 (1992), annex B (markers). EXIF: CIPA DC-008 (EXIF 2.3),
// section 4.6.
#include "image/containers.hpp"

#include <algorithm>
#include <array>

#include "image/bmp.hpp"
#include "image/bytes.hpp"
#include "image/gif.hpp"
#include "image/webp.hpp"

namespace pantin {

namespace {

// --- PNG ---------------------------------------------------------------------------------------------------

constexpr std::array<std::uint32_t, 256> make_crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int k = 0; k < 8; ++k) c = (c & 1) ? 0xedb88320u ^ (c >> 1) : c >> 1;
        table[n] = c;
    }
    return table;
}
constexpr std::array<std::uint32_t, 256> crc_table = make_crc_table();

std::uint32_t crc(ByteView bytes) {
    std::uint32_t c = 0xffffffffu;
    for (unsigned char byte : bytes) c = crc_table[(c ^ byte) & 0xff] ^ (c >> 8);
    return c ^ 0xffffffffu;
}

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

// Walks the chunks: length, type, data, checksum; the first is IHDR, the last IEND.
ContainerInfo read_png(ByteView bytes) {
    ContainerInfo info;
    info.kind = Container::png;
    std::size_t at = png_signature.size();
    bool first = true;
    while (true) {
        if (bytes.size() - at < 12) return info.problem = "the PNG ends early (truncated)", info;
        const std::size_t length = big_endian_32(bytes, at);
        const ByteView type = bytes.subspan(at + 4, 4);
        if (first) {
            if (!has_at(type, 0, "IHDR") || length != 13 || bytes.size() - at < 25)
                return info.problem = "the PNG has no header", info;
            info.width = big_endian_32(bytes, at + 8);
            info.height = big_endian_32(bytes, at + 12);
            first = false;
        }
        if (length > bytes.size() - at - 12) return info.problem = "the PNG ends early (truncated)", info;
        if (crc(bytes.subspan(at + 4, length + 4)) != big_endian_32(bytes, at + 8 + length))
            return info.problem = "the PNG is damaged (a checksum does not match)", info;
        if (has_at(type, 0, "IEND")) return info;
        if (has_at(type, 0, "eXIf")) info.orientation = exif_orientation(bytes.subspan(at + 8, length));
        at += length + 12;
    }
}

// --- JPEG --------------------------------------------------------------------------------------------------

bool is_restart(unsigned marker) { return marker >= 0xd0 && marker <= 0xd7; }
bool has_no_segment(unsigned marker) { return marker == 0xd8 || marker == 0x01 || is_restart(marker); }
bool is_frame_header(unsigned marker) {
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

// Whether a define-Huffman-table segment (B.2.4.2) holds whole tables of at most 256 codes. stb_image does
// not look before it writes them into arrays of that size.
bool huffman_tables_fit(ByteView segment) {
    while (!segment.empty()) {
        if (segment.size() < 17) return false;
        std::size_t codes = 0;
        for (std::size_t length = 1; length <= 16; ++length) codes += segment[length];
        if (codes > 256 || codes > segment.size() - 17) return false;
        segment = segment.subspan(17 + codes);
    }
    return true;
}

// Position of the next marker's 0xff at or after `at` (in entropy-coded data 0xff00 and restarts are no
// markers).
std::size_t next_marker(ByteView bytes, std::size_t at) {
    for (; at + 1 < bytes.size(); ++at)
        if (bytes[at] == 0xff && bytes[at + 1] != 0x00 && bytes[at + 1] != 0xff && !is_restart(bytes[at + 1]))
            return at;
    return bytes.size();
}

// Walks the markers up to the end-of-image marker; without it the file is truncated.
ContainerInfo read_jpeg(ByteView bytes) {
    ContainerInfo info;
    info.kind = Container::jpeg;
    bool oriented = false;
    std::size_t at = next_marker(bytes, 2);
    while (at < bytes.size()) {
        const unsigned marker = bytes[at + 1];
        at += 2;
        if (marker == 0xd9) {
            if (info.width == 0) info.problem = "the JPEG has no header";
            return info;
        }
        if (!has_no_segment(marker)) {
            const std::size_t left = bytes.size() - at;
            const std::size_t length = left < 2 ? 0 : big_endian_16(bytes, at);
            if (length < 2 || length > left) break;
            const ByteView segment = bytes.subspan(at + 2, length - 2);
            if (marker == 0xc4 && !huffman_tables_fit(segment))
                return info.problem = "the JPEG is damaged (a Huffman table)", info;
            if (is_frame_header(marker) && segment.size() >= 5 && info.width == 0) {
                info.height = big_endian_16(segment, 1);
                info.width = big_endian_16(segment, 3);
            }
            if (marker == 0xe1 && !oriented && has_at(segment, 0, std::string_view("Exif\0\0", 6))) {
                info.orientation = exif_orientation(segment.subspan(6));
                oriented = true;
            }
            at += length;
        }
        at = next_marker(bytes, at);
    }
    info.problem = "the JPEG ends early (truncated)";
    return info;
}

} // namespace

int exif_orientation(ByteView tiff) {
    if (tiff.size() < 8) return 1;
    const bool little = tiff[0] == 'I' && tiff[1] == 'I';
    if (!little && !(tiff[0] == 'M' && tiff[1] == 'M')) return 1;
    const auto read_16 = [&](std::size_t at) {
        return little ? std::uint32_t{tiff[at]} | (std::uint32_t{tiff[at + 1]} << 8)
                      : big_endian_16(tiff, at);
    };
    const auto read_32 = [&](std::size_t at) {
        return little ? read_16(at) | (read_16(at + 2) << 16) : big_endian_32(tiff, at);
    };
    if (read_16(2) != 42) return 1;
    const std::size_t directory = read_32(4);
    if (directory > tiff.size() - 2) return 1;
    const std::size_t count = read_16(directory);
    const std::size_t available = (tiff.size() - directory - 2) / 12;
    for (std::size_t i = 0; i < std::min(count, available); ++i) {
        const std::size_t entry = directory + 2 + 12 * i; // tag, type, count, value
        if (read_16(entry) != 0x0112) continue;
        const std::uint32_t value = read_16(entry + 8);
        const bool is_short = read_16(entry + 2) == 3 && read_32(entry + 4) == 1;
        return is_short && value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

ContainerInfo read_container(ByteView bytes) {
    if (has_at(bytes, 0, png_signature)) return read_png(bytes);
    if (has_at(bytes, 0, "\xff\xd8\xff")) return read_jpeg(bytes);
    if (has_at(bytes, 0, "RIFF") && has_at(bytes, 8, "WEBP")) return read_webp(bytes);
    if (has_at(bytes, 0, "GIF87a") || has_at(bytes, 0, "GIF89a")) return read_gif(bytes);
    if (is_bmp(bytes)) return read_bmp(bytes);
    return {};
}

} // namespace pantin
