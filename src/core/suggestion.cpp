// SPDX-License-Identifier: MIT
// An unknown word and the known ones in, a hint for the message out.
#include "core/suggestion.hpp"

#include <algorithm>

namespace pantin {

int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> before_last(width), last(width), row(width);
    for (std::size_t j = 0; j < width; ++j) row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j < width; ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row.back();
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
    const int most = std::clamp(static_cast<int>(word.size()) / 3, 1, 3);
    const std::string* nearest = nullptr;
    int smallest = most + 1;
    for (const std::string& candidate : known) {
        const int distance = edit_distance(word, candidate);
        if (distance >= smallest || distance >= static_cast<int>(candidate.size())) continue;
        smallest = distance;
        nearest = &candidate;
    }
    return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

} // namespace pantin
