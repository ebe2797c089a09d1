// SPDX-License-Identifier: MIT
// GIF bytes in, the first picture out (CompuServe, "Graphics Interchange Format, Version 89a", 1990). Ours,
// because stb_image's decoder takes data that end early for a whole picture, and exchanges red and blue of
// the background.
#include "image/gif.hpp"

#include <array>
#include <bit>
#include <optional>
#include <vector>

namespace pantin {

namespace {

constexpr int no_colour = -1;

struct GifFrame {
    std::uint32_t left = 0, top = 0, width = 0, height = 0;
    bool interlaced = false;
    ByteView palette; // red, green, blue of each colour
    int transparent = no_colour;
    std::uint32_t code_size = 0;
    std::size_t data_at = 0; // of the first block of data
};

std::size_t palette_bytes(std::uint32_t flags) {
    return (flags & 0x80) == 0 ? 0 : std::size_t{6} << (flags & 7);
}

void skip_blocks(Cursor& cursor) {
    while (const std::uint32_t length = cursor.u8()) cursor.skip(length);
}

struct GifScreen {
    std::uint32_t width = 0, height = 0;
    ByteView palette;
};
GifScreen read_screen(Cursor& cursor) {
    GifScreen screen;
    cursor.skip(6);
    screen.width = cursor.u16();
    screen.height = cursor.u16();
    const std::uint32_t flags = cursor.u8();
    cursor.skip(2);
    screen.palette = cursor.take(palette_bytes(flags));
    return screen;
}

// 0x2c was read.
GifFrame read_frame(Cursor& cursor, const GifScreen& screen) {
    GifFrame frame;
    frame.left = cursor.u16();
    frame.top = cursor.u16();
    frame.width = cursor.u16();
    frame.height = cursor.u16();
    const std::uint32_t flags = cursor.u8();
    frame.interlaced = (flags & 0x40) != 0;
    const ByteView own = cursor.take(palette_bytes(flags));
    frame.palette = own.empty() ? screen.palette : own;
    frame.code_size = cursor.u8();
    frame.data_at = cursor.at();
    skip_blocks(cursor);
    return frame;
}

// 0x21 was read. The transparent colour of the next frame, when it says one.
void read_extension(Cursor& cursor, int& transparent) {
    if (cursor.u8() == 0xf9) {
        Cursor control = cursor;
        if (control.u8() == 4) {
            const std::uint32_t flags = control.u8();
            control.skip(2);
            const auto colour = static_cast<int>(control.u8());
            transparent = (flags & 1) != 0 ? colour : no_colour;
        }
    }
    skip_blocks(cursor);
}

struct GifWalk {
    GifScreen screen;
    std::optional<GifFrame> first;
    std::string problem;
};
// All blocks up to the trailer.
GifWalk walk(ByteView bytes) {
    GifWalk result;
    Cursor cursor(bytes);
    result.screen = read_screen(cursor);
    int transparent = no_colour;
    while (!cursor.ended()) {
        const std::uint32_t kind = cursor.u8();
        if (cursor.ended()) break;
        if (kind == 0x3b) {
            if (!result.first) result.problem = "the GIF has no picture";
            return result;
        }
        if (kind == 0x21) {
            read_extension(cursor, transparent);
        } else if (kind == 0x2c) {
            GifFrame frame = read_frame(cursor, result.screen);
            frame.transparent = transparent;
            if (!result.first) result.first = frame;
        } else {
            return result.problem = "the GIF is damaged (an unknown block)", result;
        }
    }
    return result.problem = "the GIF ends early (truncated)", result;
}

// The bits of the data blocks, the lowest first.
class CodeReader {
public:
    CodeReader(ByteView bytes, std::size_t at) : cursor_(bytes, at) {}
    // Nothing when the data have ended.
    std::optional<std::uint32_t> next(std::uint32_t width) {
        while (held_ < width) {
            if (in_block_ == 0 && (in_block_ = cursor_.u8()) == 0) return std::nullopt;
            bits_ |= cursor_.u8() << held_;
            held_ += 8;
            --in_block_;
        }
        const std::uint32_t code = bits_ & ((1u << width) - 1);
        bits_ >>= width;
        held_ -= width;
        return code;
    }

private:
    Cursor cursor_;
    std::uint32_t in_block_ = 0, bits_ = 0, held_ = 0;
};

// The strings of colour numbers that codes stand for: one that was known, and one number behind it (89a,
// appendix F).
class CodeTable {
public:
    explicit CodeTable(std::uint32_t code_size) : clear_(1u << code_size) { reset(); }
    std::uint32_t clear() const { return clear_; }
    std::uint32_t end() const { return clear_ + 1; }
    std::uint32_t width() const { return width_; }
    void reset() {
        size_ = clear_ + 2;
        width_ = static_cast<std::uint32_t>(std::bit_width(clear_));
        before_ = none;
    }
    // Appends what the code stands for; false for a code that cannot be.
    bool expand(std::uint32_t code, std::vector<std::uint8_t>& numbers) {
        if (code > size_ || (before_ == none && code >= clear_)) return false;
        const std::size_t start = numbers.size();
        const bool is_new = code == size_; // the string before and its own first number
        append(is_new ? before_ : code, numbers);
        const std::uint8_t first = numbers[start];
        if (is_new) numbers.push_back(first);
        if (before_ != none && size_ < entries_.size()) {
            entries_[size_] = {before_, first, length(before_) + 1};
            ++size_;
            if (size_ == 1u << width_ && width_ < 12) ++width_;
        }
        before_ = code;
        return true;
    }

private:
    static constexpr std::uint32_t none = 4096; // no code is that large
    struct Entry {
        std::uint32_t before = 0;
        std::uint8_t last = 0;
        std::uint32_t length = 0;
    };
    std::uint32_t length(std::uint32_t code) const { return code < clear_ ? 1 : entries_[code].length; }
    void append(std::uint32_t code, std::vector<std::uint8_t>& numbers) const {
        std::size_t at = numbers.size() + length(code);
        numbers.resize(at);
        for (; code >= clear_; code = entries_[code].before) numbers[--at] = entries_[code].last;
        numbers[--at] = static_cast<std::uint8_t>(code);
    }
    std::uint32_t clear_, size_ = 0, width_ = 0;
    std::uint32_t before_ = none;
    std::array<Entry, 4096> entries_{};
};

// The colour numbers of the frame as they are stored; fewer when the data are damaged.
std::vector<std::uint8_t> colour_numbers(ByteView bytes, const GifFrame& frame) {
    const std::size_t count = std::size_t{frame.width} * frame.height;
    std::vector<std::uint8_t> numbers;
    numbers.reserve(count + 4096);
    CodeReader codes(bytes, frame.data_at);
    CodeTable table(frame.code_size);
    while (numbers.size() < count) {
        const std::optional<std::uint32_t> code = codes.next(table.width());
        if (!code || *code == table.end()) break;
        if (*code == table.clear())
            table.reset();
        else if (!table.expand(*code, numbers))
            break;
    }
    return numbers;
}

// Where the stored rows belong: an interlaced picture has every eighth row first, then those between.
std::vector<int> row_order(const GifFrame& frame) {
    const auto height = static_cast<int>(frame.height);
    std::vector<int> rows;
    struct Pass {
        int start, step;
    };
    const std::vector<Pass> passes =
        frame.interlaced ? std::vector<Pass>{{0, 8}, {4, 8}, {2, 4}, {1, 2}} : std::vector<Pass>{{0, 1}};
    for (const Pass& pass : passes)
        for (int row = pass.start; row < height; row += pass.step) rows.push_back(row);
    return rows;
}

Rgba8 colour_of(const GifFrame& frame, std::uint8_t number) {
    const std::size_t at = std::size_t{number} * 3;
    if (number == frame.transparent || at >= frame.palette.size()) return {0, 0, 0, 0};
    return {frame.palette[at], frame.palette[at + 1], frame.palette[at + 2], 255};
}

} // namespace

ContainerInfo read_gif(ByteView bytes) {
    const GifWalk result = walk(bytes);
    ContainerInfo info;
    info.kind = Container::gif;
    info.width = result.screen.width;
    info.height = result.screen.height;
    info.problem = result.problem;
    if (!info.problem.empty()) return info;
    const GifFrame& frame = *result.first;
    if (frame.left + frame.width > info.width || frame.top + frame.height > info.height ||
        frame.code_size < 1 || frame.code_size > 8 || frame.palette.empty())
        info.problem = "the GIF is damaged (its first picture)";
    return info;
}

RgbaImage decode_gif_picture(ByteView bytes) {
    const GifWalk result = walk(bytes);
    const GifFrame& frame = *result.first;
    const std::vector<std::uint8_t> numbers = colour_numbers(bytes, frame);
    if (numbers.size() < std::size_t{frame.width} * frame.height) return {};
    RgbaImage image(static_cast<int>(result.screen.width), static_cast<int>(result.screen.height),
                    Rgba8{0, 0, 0, 0});
    auto number = numbers.begin();
    for (const int row : row_order(frame))
        for (std::uint32_t x = 0; x < frame.width; ++x)
            image(static_cast<int>(frame.left + x), static_cast<int>(frame.top) + row) =
                colour_of(frame, *number++);
    return image;
}

} // namespace pantin
