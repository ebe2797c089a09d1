// SPDX-License-Identifier: MIT
// Bytes of a file as numbers. Whoever calls the first functions has seen to it that the bytes are there; a
// cursor sees to it itself.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace pantin {

using ByteView = std::span<const unsigned char>;

inline std::uint32_t big_endian_16(ByteView b, std::size_t at) {
    return (std::uint32_t{b[at]} << 8) | b[at + 1];
}
inline std::uint32_t big_endian_32(ByteView b, std::size_t at) {
    return (big_endian_16(b, at) << 16) | big_endian_16(b, at + 2);
}

// Whether these characters stand at that place.
inline bool has_at(ByteView bytes, std::size_t at, std::string_view text) {
    return bytes.size() >= at && bytes.size() - at >= text.size() &&
           std::memcmp(bytes.data() + at, text.data(), text.size()) == 0;
}

// Reads on, the lowest byte first. Past the end every byte is 0, and ended() says so.
class Cursor {
public:
    explicit Cursor(ByteView bytes, std::size_t at = 0) : bytes_(bytes) { skip(at); }
    std::size_t at() const { return at_; }
    bool ended() const { return ended_; }
    std::size_t left() const { return bytes_.size() - at_; }
    void skip(std::size_t count) { take(count); }
    // The next bytes; none when there are not so many.
    ByteView take(std::size_t count) {
        if (count > left()) {
            ended_ = true;
            at_ = bytes_.size();
            return {};
        }
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }
    std::uint32_t u8() { return number(1); }
    std::uint32_t u16() { return number(2); }
    std::uint32_t u24() { return number(3); }
    std::uint32_t u32() { return number(4); }

private:
    std::uint32_t number(std::size_t count) {
        const ByteView taken = take(count);
        std::uint32_t value = 0;
        for (std::size_t i = taken.size(); i-- > 0;) value = value << 8 | taken[i];
        return value;
    }
    ByteView bytes_;
    std::size_t at_ = 0;
    bool ended_ = false;
};

} // namespace pantin
