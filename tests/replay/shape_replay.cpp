// SPDX-License-Identifier: MIT
// Silhouette and borders (thesis 4.4; Suzuki & Abe 1985), by flooding regions and counting.
#include <algorithm>
#include <cstdlib>

#include "replay/stored.hpp"

namespace pantin::test::replay {
namespace {

// The largest component of the labelled pixels; holes filled up to the preset's share of its area.
Mask silhouette_of(const Stored& s) {
    Mask mask(s.width, s.height);
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) mask(x, y) = s.labels(x, y) != 0;
    const Regions parts = regions_of(mask, true, true);
    if (parts.area.empty()) return mask;
    const auto largest = std::max_element(parts.area.begin(), parts.area.end());
    const int id = static_cast<int>(largest - parts.area.begin()) + 1;
    for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] = parts.id.data()[i] == id;
    const long limit = s.thesis ? 0 : static_cast<long>(0.02 * static_cast<double>(*largest));
    const Regions gaps = regions_of(mask, false, false);
    std::vector<bool> open(gaps.area.size() + 1, false);
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x)
            if (x == 0 || y == 0 || x == s.width - 1 || y == s.height - 1) open[gaps.id(x, y)] = true;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const int gap = gaps.id.data()[i];
        if (gap > 0 && !open[gap] && gaps.area[gap - 1] <= limit) mask.data()[i] = 1;
    }
    return mask;
}

constexpr int around_x[8] = {0, 1, 1, 1, 0, -1, -1, -1}, around_y[8] = {-1, -1, 0, 1, 1, 1, 0, -1};

// How often the border between the mask and the background region passes the pixel: the runs of background
// around it that hold an edge neighbour of that region.
int passes(const Grid<int>& gap, Point2i p, int region) {
    int first = 0; // after a foreground neighbour
    while (first < 8 && gap(p.x + around_x[first], p.y + around_y[first]) != 0) ++first;
    if (first == 8) return gap(p.x, p.y - 1) == region;
    int count = 0;
    bool in_run = false;
    for (int k = 1; k <= 8; ++k) {
        const int i = (first + k) % 8, id = gap(p.x + around_x[i], p.y + around_y[i]);
        if (id == 0) in_run = false;
        if (i % 2 == 0 && id == region && !in_run) ++count, in_run = true;
    }
    return count;
}

bool steps_are_neighbours(const std::vector<Point2i>& points) {
    for (std::size_t i = 0; i < points.size() && points.size() > 1; ++i) {
        const Point2i a = points[i], b = points[(i + 1) % points.size()];
        if (std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) != 1) return false;
    }
    return true;
}

using Key = std::pair<int, int>;

// Per background region: pixel to number of passes.
std::vector<std::map<Key, int>> expected_borders(const Mask& mask) {
    Mask framed(mask.width() + 2, mask.height() + 2);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) framed(x + 1, y + 1) = mask(x, y);
    const Regions gaps = regions_of(framed, false, false);
    std::vector<std::map<Key, int>> borders(gaps.area.size());
    for (int y = 1; y <= mask.height(); ++y)
        for (int x = 1; x <= mask.width(); ++x)
            for (int region = 1; framed(x, y) && region <= std::ssize(borders); ++region)
                if (const int n = passes(gaps.id, {x, y}, region)) borders[region - 1][{x - 1, y - 1}] = n;
    return borders;
}

} // namespace

void replay_shape(const Stored& s, Tally& tally) {
    tally.add("silhouette", silhouette_of(s) == s.silhouette);
    std::vector<std::map<Key, int>> expected = expected_borders(s.silhouette), found;
    bool chained = true;
    for (const auto& border : s.borders) {
        std::map<Key, int>& passed = found.emplace_back();
        for (const Point2i p : border) ++passed[{p.x, p.y}];
        chained = chained && steps_are_neighbours(border);
    }
    const bool outer = std::count(s.outer.begin(), s.outer.end(), true) == 1 && s.outer.at(0);
    const bool first = !found.empty() && found[0] == expected[0]; // the outer region is met first
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    tally.add("borders: pixels and passes", found == expected && first && outer);
    tally.add("borders: every step to a neighbour", chained);
}

} // namespace pantin::test::replay
