// SPDX-License-Identifier: MIT
// Animated PNG (W3C PNG, third edition, 11.3.5): the frames' own PNG streams, taken apart and numbered.
// Readers that do not know the animation chunks show the first frame.
#include <array>
#include <cstdint>
#include <string_view>

#include "core/thread_pool.hpp"
#include "export/frame_times.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::size_t signature_size = 8, chunk_overhead = 12; // length, type and checksum of a chunk

std::uint32_t big_endian_at(const Bytes& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) << 24 | static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

void put(Bytes& out, std::uint32_t value, int bytes = 4) {
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
        out.push_back(static_cast<unsigned char>(value >> shift));
}

// CRC-32 of ISO 3309, as PNG wants it.
std::uint32_t checksum(const unsigned char* bytes, std::size_t count) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> values{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            values[n] = n;
            for (int k = 0; k < 8; ++k)
                values[n] = values[n] & 1 ? 0xedb88320u ^ values[n] >> 1 : values[n] >> 1;
        }
        return values;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 0; i < count; ++i) crc = table[(crc ^ bytes[i]) & 255] ^ crc >> 8;
    return ~crc;
}

void put_chunk(Bytes& out, std::string_view type, const Bytes& data) {
    put(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), data.begin(), data.end());
    put(out, checksum(out.data() + begin, out.size() - begin));
}

// The contents of all chunks of a type, one after the other.
Bytes contents(const Bytes& png, std::string_view type) {
    Bytes data;
    for (std::size_t at = signature_size; at + chunk_overhead <= png.size();) {
        const std::size_t size = big_endian_at(png, at);
        const auto* name = reinterpret_cast<const char*>(png.data() + at + 4);
        if (std::string_view(name, 4) == type)
            data.insert(data.end(), png.begin() + static_cast<std::ptrdiff_t>(at + 8),
                        png.begin() + static_cast<std::ptrdiff_t>(at + 8 + size));
        at += chunk_overhead + size;
    }
    return data;
}

// Size, place and duration of a frame that replaces the one before it.
Bytes frame_control(std::uint32_t number, const RgbaImage& frame, int delay) {
    Bytes data;
    put(data, number);
    put(data, static_cast<std::uint32_t>(frame.width()));
    put(data, static_cast<std::uint32_t>(frame.height()));
    put(data, 0);
    put(data, 0);
    put(data, static_cast<std::uint32_t>(delay), 2);
    put(data, 1000, 2);
    put(data, 0, 1); // dispose: none
    put(data, 0, 1); // blend: source
    return data;
}

} // namespace

std::vector<unsigned char> encode_apng(const std::vector<RgbaImage>& frames, double fps, int threads) {
    if (frames.empty()) throw Error(ErrorKind::internal, "an animation without frames");
    std::vector<Bytes> pictures(frames.size());
    parallel_for(threads, static_cast<int>(frames.size()), [&](int frame) {
        const auto i = static_cast<std::size_t>(frame);
        pictures[i] = encode_png(frames[i]);
    });
    Bytes out;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Bytes& png = pictures[i];
        if (i == 0) {
            out.assign(png.begin(), png.begin() + signature_size);
            put_chunk(out, "IHDR", contents(png, "IHDR"));
            Bytes control;
            put(control, static_cast<std::uint32_t>(frames.size()));
            put(control, 0); // loops for ever
            put_chunk(out, "acTL", control);
        }
        put_chunk(out, "fcTL",
                  frame_control(number++, frames[i], milliseconds(i + 1, fps) - milliseconds(i, fps)));
        Bytes data;
        if (i > 0) put(data, number++);
        const Bytes pixels = contents(png, "IDAT");
        data.insert(data.end(), pixels.begin(), pixels.end());
        put_chunk(out, i == 0 ? "IDAT" : "fdAT", data);
    }
    put_chunk(out, "IEND", {});
    return out;
}

} // namespace pantin
