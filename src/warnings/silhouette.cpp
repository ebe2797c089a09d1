// SPDX-License-Identifier: MIT
// Crop, mask and part labels to what is wrong with the silhouette: it fills the crop, or leaves ink outside
// (docs/warnings.md). Own.
#include <algorithm>

#include "pantin/image.hpp"
#include "pantin/warnings.hpp"

namespace pantin {

namespace {

constexpr float least_darkness = 0.2F; // of a pixel that counts as ink: light colours do, noise does not

// The pieces of ink that belong to the character.
Mask own_ink(const Mask& ink, const Mask& mask) {
    const Components pieces = connected_components(ink);
    std::vector<std::uint8_t> own(pieces.list.size() + 1, 0);
    for (const Component& piece : pieces.list)
        own[piece.id] = !touches_border(piece, ink.width(), ink.height());
    for (std::size_t i = 0; i < ink.size(); ++i)
        if (mask.data()[i]) own[pieces.ids.data()[i]] = 1;
    own[0] = 0;
    Mask result(ink.width(), ink.height());
    std::transform(pieces.ids.begin(), pieces.ids.end(), result.begin(),
                   [&](int id) -> std::uint8_t { return own[id]; });
    return result;
}

// What mesh and texture reach.
Mask held_pixels(const LabelMap& labels) {
    return dilate_disc(foreground(labels), ink_margin(labels.width(), labels.height()));
}

} // namespace

double filled_crop(const LabelMap& labels) {
    if (labels.empty()) return 0;
    const auto paper = std::count(labels.begin(), labels.end(), 0);
    return 1 - static_cast<double>(paper) / static_cast<double>(labels.size());
}

double lost_ink(const Grid<float>& ink, const Mask& mask, const LabelMap& labels) {
    Mask inked(ink.width(), ink.height());
    std::transform(ink.begin(), ink.end(), inked.begin(),
                   [](float darkness) -> std::uint8_t { return darkness >= least_darkness; });
    const Mask own = own_ink(inked, mask), held = held_pixels(labels);
    double all = 0, lost = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (!own.data()[i]) continue;
        all += ink.data()[i];
        if (!held.data()[i]) lost += ink.data()[i];
    }
    return all > 0 ? lost / all : 0;
}

double lost_mask(const Mask& mask, const LabelMap& labels) {
    const Mask held = held_pixels(labels);
    long all = 0, lost = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        all += mask.data()[i];
        lost += mask.data()[i] && !held.data()[i];
    }
    return all > 0 ? static_cast<double>(lost) / static_cast<double>(all) : 0;
}

} // namespace pantin
