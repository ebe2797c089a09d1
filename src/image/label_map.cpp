// SPDX-License-Identifier: MIT
// Label maps (thesis 4.3): in comes a part label per pixel, out go the connected pieces of parts, and a map
// in which every pixel has a label.
#include "image/label_map.hpp"

#include <algorithm>
#include <utility>

#include "pantin/image.hpp"

namespace pantin {

std::array<long, label_count> part_areas(const LabelMap& labels) {
    std::array<long, label_count> areas{};
    for (const std::uint8_t label : labels)
        if (label < label_count) ++areas[label];
    return areas;
}

Mask part_mask(const LabelMap& labels, LabelSet parts) {
    Mask mask(labels.width(), labels.height());
    std::transform(labels.begin(), labels.end(), mask.begin(),
                   [parts](std::uint8_t label) { return parts.contains(static_cast<Label>(label)); });
    return mask;
}

std::vector<LabelPiece> pieces_of(const Mask& mask, int least_area) {
    const Components components = connected_components(mask);
    std::vector<LabelPiece> pieces;
    std::vector<int> index(components.list.size() + 1, -1); // of a component's piece, by its id
    for (const Component& component : components.list) {
        if (component.area < least_area) continue;
        index[component.id] = static_cast<int>(pieces.size());
        pieces.push_back({{}, component.box});
        pieces.back().pixels.reserve(component.area);
    }
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (const int piece = index[components.ids(x, y)]; piece >= 0)
                pieces[piece].pixels.push_back({x, y});
    return pieces;
}

Mask cropped_mask(const LabelPiece& piece) {
    Mask mask(piece.box.width, piece.box.height);
    for (const Point2i p : piece.pixels) mask(p.x - piece.box.x, p.y - piece.box.y) = 1;
    return mask;
}

LabelMap nearest_labels(const LabelMap& labels) {
    const Grid<int> nearest = nearest_seed(foreground(labels));
    LabelMap filled = labels;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (nearest.data()[i] >= 0) filled.data()[i] = labels.data()[nearest.data()[i]];
    return filled;
}

} // namespace pantin
