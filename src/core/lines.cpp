// SPDX-License-Identifier: MIT
// A file descriptor in, lines of a bounded length out, each as soon as it is there (own; docs/batch.md).
#include "core/lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <unistd.h>

#include "pantin/error.hpp"

namespace pantin {

bool LineReader::fill() {
    constexpr std::size_t block_size = 65536;
    block_.resize(block_size);
    at_ = 0;
    ssize_t got = -1;
    do got = ::read(descriptor_, block_.data(), block_size);
    while (got < 0 && errno == EINTR);
    block_.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    if (got < 0)
        throw Error(ErrorKind::input, std::string("standard input: cannot be read: ") + std::strerror(errno));
    ended_ = got == 0; // also of a terminal, where reading on would wait for more
    return !ended_;
}

std::optional<Line> LineReader::next() {
    Line line;
    bool any = false;
    while (at_ < block_.size() || (!ended_ && fill())) {
        const std::size_t end = std::min(block_.find('\n', at_), block_.size());
        const std::size_t length = end - at_, space = limit_ - line.text.size();
        line.text.append(block_, at_, std::min(length, space));
        line.too_long = line.too_long || length > space;
        const bool whole = end < block_.size();
        bytes_ += length + (whole ? 1 : 0);
        at_ = end + (whole ? 1 : 0);
        any = true;
        if (whole) break;
    }
    if (!any) return std::nullopt;
    if (!line.too_long && line.text.ends_with('\r')) line.text.pop_back();
    return line;
}

} // namespace pantin
