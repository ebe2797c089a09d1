// SPDX-License-Identifier: MIT
// True labels and a skeleton's ends in, how many parts have an end out.
#include "evaluation/end_effectors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "image/label_map.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

constexpr double least_piece = 0.01; // of the figure: smaller pieces of a part need no end-effector

struct Pieces {
    Components components;
    std::vector<int> ids; // of those that are large enough
};

Pieces pieces_of(const LabelMap& labels, Label label, double area) {
    Pieces pieces{connected_components(part_mask(labels, {label})), {}};
    for (const Component& piece : pieces.components.list)
        if (piece.area >= least_piece * area) pieces.ids.push_back(piece.id);
    return pieces;
}

// Every piece within reach of a place, with its squared distance.
std::map<int, double> pieces_near(const Pieces& pieces, Point2d place, double reach) {
    std::map<int, double> near;
    const int x = static_cast<int>(std::rint(place.x)), y = static_cast<int>(std::rint(place.y)),
              r = static_cast<int>(reach);
    for (int dy = -r; dy <= r; ++dy)
        for (int dx = -r; dx <= r; ++dx) {
            const int id = pieces.components.ids.value_or(x + dx, y + dy, 0);
            const double d = dx * dx + dy * dy;
            if (d > reach * reach || std::find(pieces.ids.begin(), pieces.ids.end(), id) == pieces.ids.end())
                continue;
            const auto [at, fresh] = near.emplace(id, d);
            if (!fresh) at->second = std::min(at->second, d);
        }
    return near;
}

// Pieces that have an end; one end may do for two that lie close together.
int pieces_reached(const Pieces& pieces, Label label, const std::vector<SkeletonEnd>& ends, double reach) {
    std::map<int, double> met;
    for (const SkeletonEnd& end : ends)
        if (end.label == label) met.merge(pieces_near(pieces, end.place, reach));
    return static_cast<int>(met.size());
}

int limbs_reached(const Pieces& pieces, const std::vector<SkeletonEnd>& ends, int limbs, double reach) {
    std::map<int, int> count; // piece → ends
    for (const SkeletonEnd& end : ends) {
        if (end.label != Label::limb) continue;
        const auto near = pieces_near(pieces, end.place, reach);
        const auto nearest =
            std::min_element(near.begin(), near.end(), [](auto& a, auto& b) { return a.second < b.second; });
        if (nearest != near.end()) ++count[nearest->first];
    }
    const int most = std::max(1, limbs - static_cast<int>(pieces.ids.size()) + 1);
    int reached = 0;
    for (const auto& [piece, number] : count) reached += std::min(number, most);
    return std::min(reached, limbs);
}

} // namespace

EndCount count_ends(const LabelMap& labels, const std::vector<SkeletonEnd>& ends, int limbs, double reach) {
    EndCount result;
    result.limbs_known = limbs >= 0;
    const double area = static_cast<double>(
        std::count_if(labels.begin(), labels.end(), [](std::uint8_t v) { return v != 0; }));
    for (const Label label : part_labels) {
        if (role_of(label) == PartRole::trunk) continue;
        const Pieces pieces = pieces_of(labels, label, area);
        if (pieces.ids.empty()) continue;
        const bool counted = label == Label::limb && limbs > 0;
        result.parts += counted ? limbs : static_cast<int>(pieces.ids.size());
        result.reached +=
            counted ? limbs_reached(pieces, ends, limbs, reach) : pieces_reached(pieces, label, ends, reach);
    }
    return result;
}

} // namespace pantin
