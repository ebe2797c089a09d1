// SPDX-License-Identifier: MIT
// Traits: what the parts of a drawing say about how it moves, besides the distance of its skeleton (ERRATA
// 10).
#pragma once

#include <array>
#include <string_view>

#include "pantin/grid.hpp"
#include "pantin/identification.hpp"
#include "reference/quantities.hpp"

namespace pantin {

using Traits = std::array<double, trait_count>;

// A trait or a count by its name.
double quantity(std::string_view name, const SkeletonGraph& graph, const Traits& traits);
Traits measure_traits(const SkeletonGraph& graph, const LabelMap& labels);

// A part of a label map: what remains of a label when specks are dropped.
struct PartRegion {
    double area = 0;                      // pixels in pieces
    std::vector<Point2d> centres;         // of the pieces
    Point2d centre;                       // of all of them
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1; // box, inclusive; empty when there is no piece
    bool empty() const { return area == 0; }
    double width() const { return x1 - x0 + 1; }
    double height() const { return y1 - y0 + 1; }
};
// The pieces (8-connected) of the pixels that carry one of the labels, specks below 0.3 % of the silhouette
// dropped.
PartRegion part_region(const LabelMap& labels, LabelSet parts);

} // namespace pantin
