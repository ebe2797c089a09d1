// SPDX-License-Identifier: MIT
// Label maps as pieces of parts, and the part nearest to a pixel.
#pragma once

#include <array>
#include <vector>

#include "pantin/grid.hpp"
#include "pantin/label.hpp"
#include "pantin/point.hpp"

namespace pantin {

// A connected piece of a part.
struct LabelPiece {
    std::vector<Point2i> pixels; // in raster order
    Box box;
    int area() const { return static_cast<int>(pixels.size()); }
};

// Pixels of each label, background to wing; other values do not count.
std::array<long, label_count> part_areas(const LabelMap& labels);

// Where the map has one of the labels.
Mask part_mask(const LabelMap& labels, LabelSet parts);

// The 8-connected pieces of the mask with at least `least_area` pixels, in the raster order of their first
// pixels.
std::vector<LabelPiece> pieces_of(const Mask& mask, int least_area = 1);

// The pixels of the piece alone, in a grid of its own whose origin is the corner of its box.
Mask cropped_mask(const LabelPiece& piece);

// Every pixel gets the label of the nearest labelled pixel (the first in raster order among equals, see
// nearest_seed); a map without labels stays.
LabelMap nearest_labels(const LabelMap& labels);

} // namespace pantin
