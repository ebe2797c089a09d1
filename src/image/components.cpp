// SPDX-License-Identifier: MIT
// Connected components in two passes with union–find (Rosenfeld & Pfaltz 1966; the smaller label becomes the
// root, so that final ids follow the raster order of each component's first pixel).
#include <algorithm>

#include "core/disjoint_sets.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// Provisional labels, 1-based (label 0 of the union–find stands for the pixels that do not count).
Grid<int> provisional_labels(const Mask& mask, std::uint8_t value, bool diagonals, DisjointSets& sets) {
    const int w = mask.width(), h = mask.height();
    Grid<int> ids(w, h, 0);
    for (int y = 0; y < h; ++y) {
        const std::uint8_t* in = mask.row(y);
        int* out = ids.row(y);
        const int* above = y > 0 ? ids.row(y - 1) : nullptr;
        for (int x = 0; x < w; ++x) {
            if (in[x] != value) continue;
            int id = x > 0 ? out[x - 1] : 0;
            const auto join = [&](int other) {
                if (other != 0 && other != id) id = id == 0 ? other : sets.unite(id, other);
            };
            if (above) {
                join(above[x]);
                if (diagonals && x > 0) join(above[x - 1]);
                if (diagonals && x + 1 < w) join(above[x + 1]);
            }
            out[x] = id != 0 ? id : sets.add();
        }
    }
    return ids;
}

Components components_of(const Mask& mask, std::uint8_t value, bool diagonals) {
    DisjointSets sets;
    sets.add();
    Components result;
    result.ids = provisional_labels(mask, value, diagonals, sets);
    std::vector<int> final_id(static_cast<std::size_t>(sets.size()), 0);
    int count = 0;
    for (int label = 1; label < sets.size(); ++label) {
        const int root = sets.find(label); // root ≤ label: already numbered
        final_id[label] = root == label ? ++count : final_id[root];
    }
    result.list.resize(static_cast<std::size_t>(count));
    std::vector<Point2i> low(result.list.size(), {mask.width(), mask.height()}),
        high(result.list.size(), {-1, -1});
    for (int y = 0; y < mask.height(); ++y) {
        int* row = result.ids.row(y);
        for (int x = 0; x < mask.width(); ++x) {
            if (row[x] == 0) continue;
            const int id = row[x] = final_id[row[x]];
            ++result.list[id - 1].area;
            low[id - 1] = {std::min(low[id - 1].x, x), std::min(low[id - 1].y, y)};
            high[id - 1] = {std::max(high[id - 1].x, x), y};
        }
    }
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
    for (std::size_t i = 0; i < out.size(); ++i) out.data()[i] = components.ids.data()[i] == id;
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
    for (std::size_t i = 0; i < out.size(); ++i) {
        const int id = background.ids.data()[i];
        if (id == 0) continue;
        const Component& region = background.list[id - 1];
        if (region.area <= max_area && !touches_border(region, mask.width(), mask.height()))
            out.data()[i] = 1;
    }
    return out;
}

} // namespace pantin
