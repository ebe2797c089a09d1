// SPDX-License-Identifier: MIT
// Connected components of the runs of each row with union–find (Rosenfeld & Pfaltz 1966; the smaller label
// becomes the root, so that final ids follow the raster order of each component's first pixel).
#include <algorithm>
#include <array>
#include <cstring>

#include "core/disjoint_sets.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// The pixels first … end − 1 of a row have the value, the one before and the one after do not.
struct Run {
    int y, first, end;
};

// The first pixel from x on that has another value.
int end_of_run(const std::uint8_t* row, int x, int width, std::uint8_t value) {
    std::array<std::uint8_t, 16> equal;
    equal.fill(value);
    while (x + 16 <= width && std::memcmp(row + x, equal.data(), equal.size()) == 0) x += 16;
    while (x < width && row[x] == value) ++x;
    return x;
}

// In raster order.
std::vector<Run> runs_of(const Mask& mask, std::uint8_t value) {
    std::vector<Run> runs;
    const int w = mask.width();
    for (int y = 0; y < mask.height(); ++y) {
        const std::uint8_t* row = mask.row(y);
        for (int x = 0; x < w;) {
            const void* found = std::memchr(row + x, value, static_cast<std::size_t>(w - x));
            if (found == nullptr) break;
            const int first = static_cast<int>(static_cast<const std::uint8_t*>(found) - row);
            x = end_of_run(row, first, w, value);
            runs.push_back({y, first, x});
        }
    }
    return runs;
}

// Joins runs of neighbouring rows that touch.
DisjointSets united(const std::vector<Run>& runs, bool diagonals) {
    DisjointSets sets(runs.size());
    const int reach = diagonals ? 1 : 0;
    std::size_t above = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Run& run = runs[i];
        // The last run above may reach on to the next one of this row.
        while (runs[above].y < run.y - 1 ||
               (runs[above].y == run.y - 1 && runs[above].end + reach <= run.first))
            ++above;
        for (std::size_t k = above; runs[k].y == run.y - 1 && runs[k].first < run.end + reach; ++k)
            sets.unite(static_cast<int>(k), static_cast<int>(i));
    }
    return sets;
}

Components components_of(const Mask& mask, std::uint8_t value, bool diagonals) {
    const std::vector<Run> runs = runs_of(mask, value);
    DisjointSets sets = united(runs, diagonals);
    Components result;
    result.ids = Grid<int>(mask.width(), mask.height(), 0);
    std::vector<int> ids(runs.size());
    std::vector<Point2i> low, high;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto [y, first, end] = runs[i];
        const auto root = static_cast<std::size_t>(sets.find(static_cast<int>(i))); // ≤ i: already numbered
        if (root == i) {
            result.list.emplace_back();
            low.push_back({first, y});
            high.push_back({end - 1, y});
            ids[i] = static_cast<int>(result.list.size());
        }
        const int id = ids[i] = ids[root];
        std::fill(result.ids.row(y) + first, result.ids.row(y) + end, id);
        result.list[id - 1].area += end - first;
        low[id - 1].x = std::min(low[id - 1].x, first);
        high[id - 1] = {std::max(high[id - 1].x, end - 1), y};
    }
    const int count = static_cast<int>(result.list.size());
    for (int i = 0; i < count; ++i) {
        result.list[i].id = i + 1;
        result.list[i].box = {low[i].x, low[i].y, high[i].x - low[i].x + 1, high[i].y - low[i].y + 1};
    }
    return result;
}

} // namespace

Components connected_components(const Mask& mask) { return components_of(mask, 1, true); }

Components background_components(const Mask& mask) { return components_of(mask, 0, false); }

Mask foreground(const LabelMap& labels) {
    Mask mask(labels.width(), labels.height());
    for (std::size_t i = 0; i < labels.size(); ++i) mask.data()[i] = labels.data()[i] != 0;
    return mask;
}

Mask component_mask(const Components& components, int id) {
    Mask out(components.ids.width(), components.ids.height());
    const Box& box = components.list[id - 1].box;
    for (int y = box.y; y < box.y + box.height; ++y)
        std::transform(components.ids.row(y) + box.x, components.ids.row(y) + box.x + box.width,
                       out.row(y) + box.x, [&](int other) -> std::uint8_t { return other == id; });
    return out;
}

Mask largest_component(const Mask& mask) {
    const Components components = connected_components(mask);
    const auto largest =
        std::max_element(components.list.begin(), components.list.end(),
                         [](const Component& a, const Component& b) { return a.area < b.area; });
    return largest == components.list.end() ? mask : component_mask(components, largest->id);
}

bool touches_border(const Component& component, int width, int height) {
    const Box& box = component.box;
    return box.x == 0 || box.y == 0 || box.x + box.width == width || box.y + box.height == height;
}

Mask fill_holes(const Mask& mask, long max_area) {
    const Components background = background_components(mask);
    Mask out = mask;
    for (const Component& region : background.list) {
        if (region.area > max_area || touches_border(region, mask.width(), mask.height())) continue;
        const Box& box = region.box;
        for (int y = box.y; y < box.y + box.height; ++y)
            for (int x = box.x; x < box.x + box.width; ++x) out(x, y) |= background.ids(x, y) == region.id;
    }
    return out;
}

} // namespace pantin
