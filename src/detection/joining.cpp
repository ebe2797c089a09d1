// SPDX-License-Identifier: MIT
#include "detection/joining.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace pantin {
namespace {

// Per pair of groups (from 0, the lower one first): how many pixels of theirs are neighbours, diagonal ones,
// too.
std::map<std::pair<int, int>, int> count_contacts(const Grid<int>& groups) {
    std::map<std::pair<int, int>, int> contacts;
    constexpr int dx[] = {1, -1, 0, 1}, dy[] = {0, 1, 1, 1};
    for (int y = 0; y < groups.height(); ++y)
        for (int x = 0; x < groups.width(); ++x) {
            const int a = groups(x, y);
            if (a == 0) continue;
            for (int k = 0; k < 4; ++k) {
                const int b = groups.value_or(x + dx[k], y + dy[k], 0);
                if (b != 0 && b != a) ++contacts[{std::min(a, b) - 1, std::max(a, b) - 1}];
            }
        }
    return contacts;
}

Box united(const Box& a, const Box& b) {
    const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
            std::max(a.y + a.height, b.y + b.height) - top};
}

} // namespace

Grouping join_pieces(Grouping grouping, const std::function<bool(int group)>& is_figure) {
    const std::map<std::pair<int, int>, int> contacts = count_contacts(grouping.groups);
    if (contacts.empty()) return grouping;
    const int count = static_cast<int>(grouping.boxes.size());
    const auto area = [&](int i) {
        const Box& box = grouping.boxes[static_cast<std::size_t>(i)];
        return std::int64_t{box.width} * box.height;
    };
    std::vector<int> order(static_cast<std::size_t>(count)), joined(order.size());
    std::iota(order.begin(), order.end(), 0);
    std::iota(joined.begin(), joined.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return area(a) < area(b); });
    for (const int part : order) {
        int whole = -1, most = 0;
        for (const auto& [pair, pixels] : contacts) {
            if (pair.first != part && pair.second != part) continue;
            const int other = pair.first == part ? pair.second : pair.first;
            if (area(other) > area(part) && pixels > most) whole = other, most = pixels;
        }
        if (whole >= 0 && !is_figure(part)) joined[static_cast<std::size_t>(part)] = whole;
    }
    // A part of a part belongs to the whole: larger groups come last.
    for (auto part = order.rbegin(); part != order.rend(); ++part) {
        int& whole = joined[static_cast<std::size_t>(*part)];
        whole = joined[static_cast<std::size_t>(whole)];
    }
    Grouping result{std::move(grouping.groups), {}, {}};
    std::vector<int> number(order.size(), 0); // of the groups that stay
    for (std::size_t i = 0; i < joined.size(); ++i) {
        if (joined[i] != static_cast<int>(i)) continue;
        result.boxes.push_back(grouping.boxes[i]);
        if (!grouping.scores.empty()) result.scores.push_back(grouping.scores[i]);
        number[i] = static_cast<int>(result.boxes.size());
    }
    for (std::size_t i = 0; i < joined.size(); ++i) {
        if (joined[i] == static_cast<int>(i)) continue;
        const auto whole = static_cast<std::size_t>(joined[i]);
        number[i] = number[whole];
        Box& box = result.boxes[static_cast<std::size_t>(number[whole]) - 1];
        box = united(box, grouping.boxes[i]);
    }
    for (int& group : result.groups)
        if (group != 0) group = number[static_cast<std::size_t>(group) - 1];
    return result;
}

} // namespace pantin
