// SPDX-License-Identifier: MIT
// A name in, its words out.
#include "core/name_words.hpp"

namespace pantin {
namespace {

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

} // namespace

std::vector<std::string> words_of(const std::string& name) {
    std::vector<std::string> words;
    bool open = false;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool capital = is_capital(c);
        if (!capital && !is_small(c)) {
            open = false;
            continue;
        }
        const bool hump =
            capital && i > 0 && (is_small(name[i - 1]) || (i + 1 < name.size() && is_small(name[i + 1])));
        if (!open || hump) words.emplace_back();
        open = true;
        words.back() += capital ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return words;
}

} // namespace pantin
