// SPDX-License-Identifier: MIT
// The lines of standard input, one at a time and as soon as they are there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace pantin {

struct Line {
    std::string text;      // without its end, LF or CR LF
    bool too_long = false; // then the text is only how it begins
};

class LineReader {
public:
    // Reads from an open file, pipe or terminal. Of a line at most `limit` bytes are kept in memory.
    LineReader(int descriptor, std::size_t limit) : descriptor_(descriptor), limit_(limit) {}

    // Waits for the next line; none after the last one, which need not be ended. Error(input) when the stream
    // cannot be read.
    std::optional<Line> next();
    std::uint64_t bytes() const { return bytes_; } // of the lines so far

private:
    bool fill(); // false at the end

    int descriptor_;
    std::size_t limit_;
    std::string block_;
    std::size_t at_ = 0; // in the block
    bool ended_ = false;
    std::uint64_t bytes_ = 0;
};

} // namespace pantin
