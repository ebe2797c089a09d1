// SPDX-License-Identifier: MIT
#include "detection/joining.hpp"

#include <algorithm>
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

// Share of a box that lies inside another.
double share_inside(const Box& part, const Box& whole) {
    const int width = std::min(part.x + part.width, whole.x + whole.width) - std::max(part.x, whole.x);
    const int height = std::min(part.y + part.height, whole.y + whole.height) - std::max(part.y, whole.y);
    return width <= 0 || height <= 0
               ? 0
               : static_cast<double>(Box{0, 0, width, height}.area()) / static_cast<double>(part.area());
}

// Per group, the group that it belongs to: itself, or the whole whose part it is.
std::vector<std::size_t> find_wholes(const Grouping& grouping, const DetectionOptions& options) {
    const std::map<std::pair<int, int>, int> contacts = count_contacts(grouping.groups);
    const std::vector<Box>& boxes = grouping.boxes;
    std::vector<std::size_t> whole(boxes.size());
    std::iota(whole.begin(), whole.end(), std::size_t{0});
    std::vector<int> most(boxes.size(), 0);
    for (const auto& [pair, pixels] : contacts) {
        auto part = static_cast<std::size_t>(pair.first), other = static_cast<std::size_t>(pair.second);
        if (boxes[part].area() == boxes[other].area()) continue;
        if (boxes[part].area() > boxes[other].area()) std::swap(part, other);
        if (grouping.scores[part] >= options.part_score || pixels <= most[part] ||
            share_inside(boxes[part], boxes[other]) < options.part_overlap)
            continue;
        most[part] = pixels;
        whole[part] = other;
    }
    // The whole of a part is larger, so this ends.
    for (std::size_t& group : whole)
        while (whole[group] != group) group = whole[group];
    return whole;
}

} // namespace

Grouping join_pieces(Grouping grouping, const DetectionOptions& options) {
    if (grouping.scores.empty() || options.part_score <= 0) return grouping;
    const std::vector<std::size_t> whole = find_wholes(grouping, options);
    Grouping result{std::move(grouping.groups), {}, {}, {}};
    std::vector<int> number(whole.size(), 0); // of the groups that stay, from 1
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (whole[i] != i) continue;
        result.boxes.push_back(grouping.boxes[i]);
        result.scores.push_back(grouping.scores[i]);
        if (!grouping.detections.empty()) result.detections.push_back(grouping.detections[i]);
        number[i] = static_cast<int>(result.boxes.size());
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (whole[i] == i) continue;
        number[i] = number[whole[i]];
        Box& box = result.boxes[static_cast<std::size_t>(number[i]) - 1];
        box = united(box, grouping.boxes[i]);
    }
    for (int& group : result.groups)
        if (group != 0) group = number[static_cast<std::size_t>(group) - 1];
    return result;
}

} // namespace pantin
