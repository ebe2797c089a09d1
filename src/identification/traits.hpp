// SPDX-License-Identifier: MIT
// Traits: what the parts of a drawing say about how it moves, besides the distance of its skeleton (ERRATA
// 10).
#pragma once

#include <array>
#include <string_view>

#include "pantin/grid.hpp"
#include "pantin/identification.hpp"

namespace pantin {

// Each trait is a plain number, mostly in [0, 1] or [−1, 1], that does not depend on the size of the drawing
// or on which way it faces. Shares are of the silhouette's area; "low" is below the centre of the body,
// "high" above.
enum class Trait {
    wing_presence,    // share of wing, saturating at 3 %
    wing_share,       // square root of the share of wing
    tail_presence,    // share of tail, saturating at 1 %
    limb_share,       // square root of the share of limb
    head_share,       // square root of the share of head
    low_limb_pieces,  // number of limb pieces below, at most 4, / 4
    high_limb_pieces, // number of limb pieces beside or above, at most 2, / 2
    low_limb_ends,    // the same for the skeleton's limb ends
    high_limb_ends,   //
    leg_spread,       // width that the low limbs stand on / width of head and body, at most 1.5
    leg_length,       // how far the low limbs reach below the body / height of head and body, at most 1.5
    head_above,       // cosine of the direction from body to head with the upward direction
    upright,          // (height − width) / (height + width) of the box of head and body
    body_upright,     // the same of the body alone
};
inline constexpr int trait_count = 14;
inline constexpr std::array<std::string_view, trait_count> trait_names = {
    "wing_presence",   "wing_share",       "tail_presence", "limb_share",     "head_share",
    "low_limb_pieces", "high_limb_pieces", "low_limb_ends", "high_limb_ends", "leg_spread",
    "leg_length",      "head_above",       "upright",       "body_upright"};

using Traits = std::array<double, trait_count>;

// Numbers that a reference may need besides the traits (ReferenceNeed).
inline constexpr std::array<std::string_view, 2> count_names = {"limb_ends", "wing_ends"};
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
