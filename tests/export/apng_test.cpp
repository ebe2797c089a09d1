// SPDX-License-Identifier: MIT
// APNG: chunks, checksums, times and pixels, decoded by the test itself.
#include <catch2/catch.hpp>

#include <cstdint>
#include <string>

#include "pantin/error.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"

using namespace pantin;

namespace {

struct Chunk {
    std::string type, data;
    bool sound = false; // its checksum is right
};

std::uint32_t number_at(const std::string& bytes, std::size_t at, int count = 4) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    return value;
}

// Bit by bit, as the PNG specification defines it.
std::uint32_t crc_of(const std::string& bytes) {
    std::uint32_t crc = ~0u;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

std::vector<Chunk> chunks_of(const std::vector<unsigned char>& file) {
    const std::string bytes(file.begin(), file.end());
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < bytes.size();) {
        const std::size_t size = number_at(bytes, at);
        const std::string body = bytes.substr(at + 4, size + 4);
        chunks.push_back(
            {body.substr(0, 4), body.substr(4), crc_of(body) == number_at(bytes, at + 8 + size)});
        at += size + 12;
    }
    return chunks;
}

std::string pixels_of(const RgbaImage& image) {
    std::string data;
    for (const Chunk& chunk : chunks_of(encode_png(image)))
        if (chunk.type == "IDAT") data += chunk.data;
    return data;
}

std::vector<RgbaImage> shades(int count) {
    std::vector<RgbaImage> frames;
    for (int i = 0; i < count; ++i) {
        RgbaImage frame(23, 17, Rgba8{0, 0, 0, 0});
        for (int x = 0; x < 23; ++x)
            frame(x, (x + i) % 17) = {static_cast<std::uint8_t>(10 * x), 7, 200,
                                      static_cast<std::uint8_t>(255 - i)};
        frames.push_back(frame);
    }
    return frames;
}

} // namespace

TEST_CASE("An APNG holds the PNG stream of every frame, numbered, and loops for ever", "[export]") {
    const std::vector<RgbaImage> frames = shades(5);
    const std::vector<Chunk> chunks = chunks_of(encode_apng(frames, 30));
    std::vector<std::string> types, pixels;
    std::uint32_t sequence = 0, milliseconds = 0;
    for (const Chunk& chunk : chunks) {
        CHECK(chunk.sound);
        types.push_back(chunk.type);
        if (chunk.type == "acTL") {
            CHECK(number_at(chunk.data, 0) == 5);
            CHECK(number_at(chunk.data, 4) == 0);
        }
        if (chunk.type == "fcTL") {
            CHECK(number_at(chunk.data, 0) == sequence++);
            CHECK(number_at(chunk.data, 4) == 23);
            CHECK(number_at(chunk.data, 8) == 17);
            milliseconds += number_at(chunk.data, 20, 2);
            CHECK(number_at(chunk.data, 22, 2) == 1000);
        }
        if (chunk.type == "IDAT") pixels.push_back(chunk.data);
        if (chunk.type == "fdAT") {
            CHECK(number_at(chunk.data, 0) == sequence++);
            pixels.push_back(chunk.data.substr(4));
        }
    }
    CHECK(types == std::vector<std::string>{"IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT",
                                            "fcTL", "fdAT", "fcTL", "fdAT", "IEND"});
    CHECK(milliseconds == 167); // 5/30 s
    REQUIRE(pixels.size() == frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) CHECK(pixels[i] == pixels_of(frames[i]));
}

TEST_CASE("An animation without frames is an error in every format", "[export]") {
    CHECK_THROWS_AS(encode_apng({}, 25), Error);
    CHECK_THROWS_AS(write_mp4("nowhere.mp4", {}, 25), Error);
}
