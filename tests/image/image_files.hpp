// SPDX-License-Identifier: MIT
// Builders of image files for the tests: PNG of any colour type, JPEG with an EXIF segment.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "pantin/grid.hpp"

namespace pantin::test {

using Bytes = std::vector<unsigned char>;

inline void append(Bytes& to, const Bytes& from) { to.insert(to.end(), from.begin(), from.end()); }
inline void append_32(Bytes& to, std::uint32_t v) {
    for (int shift : {24, 16, 8, 0}) to.push_back(static_cast<unsigned char>(v >> shift));
}

// Bitwise, unlike the table of the program.
inline std::uint32_t slow_crc(const Bytes& bytes) {
    std::uint32_t c = 0xffffffffu;
    for (unsigned char byte : bytes) {
        c ^= byte;
        for (int k = 0; k < 8; ++k) c = (c & 1) ? 0xedb88320u ^ (c >> 1) : c >> 1;
    }
    return ~c;
}

inline Bytes chunk(const std::string& type, const Bytes& data) {
    Bytes body(type.begin(), type.end());
    append(body, data);
    Bytes out;
    append_32(out, static_cast<std::uint32_t>(data.size()));
    append(out, body);
    append_32(out, slow_crc(body));
    return out;
}

// zlib stream of stored blocks.
inline Bytes stored_zlib(const Bytes& raw) {
    Bytes out{0x78, 0x01};
    std::uint32_t a = 1, b = 0;
    for (unsigned char byte : raw) a = (a + byte) % 65521, b = (b + a) % 65521;
    std::size_t at = 0;
    do {
        const std::size_t n = std::min<std::size_t>(65535, raw.size() - at);
        out.push_back(at + n == raw.size() ? 1 : 0);
        for (unsigned v : {static_cast<unsigned>(n), ~static_cast<unsigned>(n)})
            out.push_back(static_cast<unsigned char>(v)), out.push_back(static_cast<unsigned char>(v >> 8));
        out.insert(out.end(), raw.begin() + at, raw.begin() + at + n);
        at += n;
    } while (at < raw.size());
    append_32(out, (b << 16) | a);
    return out;
}

inline Bytes png_header(std::uint32_t width, std::uint32_t height, int depth, int colour_type) {
    Bytes header;
    append_32(header, width);
    append_32(header, height);
    append(header, {static_cast<unsigned char>(depth), static_cast<unsigned char>(colour_type), 0, 0, 0});
    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append(out, chunk("IHDR", header));
    return out;
}

// `rows`: the samples of each row without filter byte; `extra`: chunks between header and data (palette …).
inline Bytes make_png(std::uint32_t width, const std::vector<Bytes>& rows, int depth, int colour_type,
                      const Bytes& extra = {}) {
    Bytes raw;
    for (const Bytes& row : rows) {
        raw.push_back(0);
        append(raw, row);
    }
    Bytes out = png_header(width, static_cast<std::uint32_t>(rows.size()), depth, colour_type);
    append(out, extra);
    append(out, chunk("IDAT", stored_zlib(raw)));
    append(out, chunk("IEND", {}));
    return out;
}

Bytes make_jpeg(const RgbImage& image, int quality);

// Puts an APP1 segment with that orientation behind the first marker of a JPEG.
inline Bytes with_orientation(const Bytes& jpeg, int orientation, bool little) {
    Bytes tiff;
    const auto put = [&](std::uint32_t v, int bytes) {
        for (int i = 0; i < bytes; ++i)
            tiff.push_back(static_cast<unsigned char>(v >> (8 * (little ? i : bytes - 1 - i))));
    };
    append(tiff, little ? Bytes{'I', 'I'} : Bytes{'M', 'M'});
    put(42, 2), put(8, 4), put(2, 2);
    put(0x010f, 2), put(2, 2), put(4, 4), put(0, 4);
    put(0x0112, 2), put(3, 2), put(1, 4), put(static_cast<std::uint32_t>(orientation), 2), put(0, 2);
    put(0, 4);
    Bytes segment{'E', 'x', 'i', 'f', 0, 0};
    append(segment, tiff);
    Bytes out{0xff, 0xd8, 0xff, 0xe1};
    const auto length = static_cast<unsigned>(segment.size() + 2);
    append(out, {static_cast<unsigned char>(length >> 8), static_cast<unsigned char>(length)});
    append(out, segment);
    out.insert(out.end(), jpeg.begin() + 2, jpeg.end());
    return out;
}

// A folder of its own that disappears with the object.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const Bytes& bytes) const {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return file;
    }

private:
    std::filesystem::path path_;
};

} // namespace pantin::test
