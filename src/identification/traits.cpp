// SPDX-License-Identifier: MIT
// Traits of a labelled drawing (ERRATA 10): labels and skeleton graph in, presence, number and place of parts
// out. Our own.
#include "identification/traits.hpp"

#include <algorithm>

#include "image/label_map.hpp"

namespace pantin {
namespace {

constexpr double speck_share = 0.003;

double silhouette_area(const LabelMap& labels) {
    return static_cast<double>(labels.size() - std::count(labels.begin(), labels.end(), 0));
}

// The middle of the figure: the body, or what stands for it in a drawing without one.
PartRegion trunk_of(const LabelMap& labels) {
    PartRegion body = part_region(labels, {Label::body});
    if (body.empty()) body = part_region(labels, {Label::body, Label::head});
    if (body.empty()) body = part_region(labels, all_parts);
    return body;
}

struct Limbs {
    int low = 0, high = 0;
};
Limbs count_limbs(const std::vector<Point2d>& places, double middle) {
    Limbs limbs;
    for (const Point2d& p : places) ++(p.y > middle ? limbs.low : limbs.high);
    return limbs;
}

std::vector<Point2d> limb_ends(const SkeletonGraph& graph) {
    std::vector<Point2d> ends;
    for (const SkeletonVertex& v : graph.vertices)
        if (v.end && v.label == Label::limb) ends.push_back({v.x, v.y});
    return ends;
}

// Box of the limb pixels below the middle of the body.
PartRegion low_limbs(const LabelMap& labels, double middle) {
    LabelMap low = labels;
    for (int y = 0; y < low.height() && y <= middle; ++y)
        for (int x = 0; x < low.width(); ++x)
            if (low(x, y) != 0) low(x, y) = static_cast<std::uint8_t>(Label::body);
    return part_region(low, {Label::limb});
}

double slenderness(const PartRegion& region) {
    return region.empty() ? 0 : (region.height() - region.width()) / (region.height() + region.width());
}

double at(int count, int most) { return static_cast<double>(std::min(count, most)) / most; }

} // namespace

PartRegion part_region(const LabelMap& labels, LabelSet parts) {
    const double smallest = speck_share * silhouette_area(labels);
    PartRegion region;
    Point2d total;
    for (const LabelPiece& piece : pieces_of(part_mask(labels, parts))) {
        if (piece.area() < smallest) continue;
        const Box& b = piece.box;
        region.x0 = region.empty() ? b.x : std::min(region.x0, b.x);
        region.y0 = region.empty() ? b.y : std::min(region.y0, b.y);
        region.x1 = std::max(region.x1, b.x + b.width - 1);
        region.y1 = std::max(region.y1, b.y + b.height - 1);
        region.area += piece.area();
        Point2d sum;
        for (const Point2i p : piece.pixels) sum = sum + to_double(p);
        region.centres.push_back((1.0 / piece.area()) * sum);
        total = total + sum;
    }
    if (!region.empty()) region.centre = (1 / region.area) * total;
    return region;
}

Traits measure_traits(const SkeletonGraph& graph, const LabelMap& labels) {
    const double silhouette = std::max(1.0, silhouette_area(labels));
    const PartRegion head = part_region(labels, {Label::head}), limb = part_region(labels, {Label::limb});
    const PartRegion tail = part_region(labels, {Label::tail}), wing = part_region(labels, {Label::wing});
    const PartRegion trunk = trunk_of(labels), core = part_region(labels, {Label::body, Label::head});
    const double middle = trunk.centre.y;
    const Limbs pieces = count_limbs(limb.centres, middle), ends = count_limbs(limb_ends(graph), middle);
    const PartRegion legs = low_limbs(labels, middle);

    Traits traits{};
    const auto set = [&traits](Trait trait, double value) { traits[static_cast<int>(trait)] = value; };
    set(Trait::wing_presence, std::min(1.0, wing.area / silhouette / 0.03));
    set(Trait::wing_share, std::sqrt(wing.area / silhouette));
    set(Trait::tail_presence, std::min(1.0, tail.area / silhouette / 0.01));
    set(Trait::limb_share, std::sqrt(limb.area / silhouette));
    set(Trait::head_share, std::sqrt(head.area / silhouette));
    set(Trait::low_limb_pieces, at(pieces.low, 4));
    set(Trait::high_limb_pieces, at(pieces.high, 2));
    set(Trait::low_limb_ends, at(ends.low, 4));
    set(Trait::high_limb_ends, at(ends.high, 2));
    if (!legs.empty() && !core.empty()) {
        set(Trait::leg_spread, std::min(1.5, legs.width() / core.width()));
        set(Trait::leg_length, std::clamp((legs.y1 - trunk.y1) / core.height(), 0.0, 1.5));
    }
    const double reach = distance(head.centre, trunk.centre);
    if (!head.empty() && reach > 0) set(Trait::head_above, (trunk.centre.y - head.centre.y) / reach);
    set(Trait::upright, slenderness(core));
    set(Trait::body_upright, slenderness(trunk));
    return traits;
}

double quantity(std::string_view name, const SkeletonGraph& graph, const Traits& traits) {
    const auto trait = std::find(trait_names.begin(), trait_names.end(), name);
    if (trait != trait_names.end()) return traits[static_cast<std::size_t>(trait - trait_names.begin())];
    const Label wanted = name == "limb_ends" ? Label::limb : Label::wing;
    return static_cast<double>(
        std::count_if(graph.vertices.begin(), graph.vertices.end(),
                      [wanted](const SkeletonVertex& v) { return v.end && v.label == wanted; }));
}

} // namespace pantin
