// SPDX-License-Identifier: MIT
// A file's name in, a word of a command line out.
#include "core/shell_word.hpp"

#include <algorithm>
#include <string_view>

namespace pantin {

namespace {

bool is_plain(char c) {
    return static_cast<unsigned char>(c) >= 0x80 || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z') || std::string_view("/._-+,:@%=").find(c) != std::string_view::npos;
}

} // namespace

std::string shell_word(const std::string& text) {
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}

} // namespace pantin
