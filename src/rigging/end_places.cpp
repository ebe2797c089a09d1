// SPDX-License-Identifier: MIT
// In come a skeleton graph, its ends and the box of its body; out go the ends' places in shares of boxes and
// their bearings. Our own: the thesis (4.6) compares paths alone (ERRATA 19).
#include "rigging/end_places.hpp"

#include <algorithm>

#include "core/math.hpp"
#include "identification/traits.hpp"
#include "rigging/reference_shape.hpp"

namespace pantin {
namespace {

constexpr double frame_reach = 0.75; // of the box's sides: places farther outside are clamped to it
constexpr double least_trunk = 0.04; // of the silhouette

// Mean place of the junctions, those of the body where there are any; the middle of the box without
// junctions.
Point2d middle_of(const SkeletonGraph& graph, const LabelledGraph& box) {
    for (const bool body_only : {true, false}) {
        Point2d sum;
        int count = 0;
        for (std::size_t i = 0; i < box.positions.size(); ++i) {
            if (graph.vertices[i].end || (body_only && box.labels[i] != Label::body)) continue;
            sum = sum + box.positions[i];
            ++count;
        }
        if (count > 0) return (1.0 / count) * sum;
    }
    return {0.5, 0.5};
}

} // namespace

Point2d Frame::place(Point2d p) const {
    const auto share = [](double v, double a, double b) {
        return std::clamp((v - a) / (b - a), -frame_reach, 1 + frame_reach);
    };
    return {share(p.x, low.x, high.x), share(p.y, low.y, high.y)};
}

Frame trunk_of(const LabelMap& labels) {
    const PartRegion body = part_region(labels, {Label::body});
    const double area = static_cast<double>(labels.size() - std::count(labels.begin(), labels.end(), 0));
    if (body.empty() || body.area < least_trunk * area) return {};
    return {to_double({body.x0, body.y0}), to_double({body.x1, body.y1})};
}

Frame trunk_of(const SkeletonGraph& drawn, const ReferenceSkeleton& reference) {
    Frame frame;
    bool first = true;
    for (std::size_t i = 0; i < reference.nodes.size(); ++i) {
        const ReferenceNode& node = reference.nodes[i];
        if (node.label != Label::body) continue;
        const Point2d c = position_of(drawn.vertices[i]), r = reference_span * node.r * Point2d{1, 1};
        const Point2d low = c - r, high = c + r;
        frame.low = first ? low : Point2d{std::min(low.x, frame.low.x), std::min(low.y, frame.low.y)};
        frame.high = first ? high : Point2d{std::max(high.x, frame.high.x), std::max(high.y, frame.high.y)};
        first = false;
    }
    return frame;
}

EndPlaces places_of(const SkeletonGraph& graph, const std::vector<int>& ends, const Frame& trunk) {
    const LabelledGraph box = normalised(to_labelled_graph(graph));
    EndPlaces places;
    places.middle = middle_of(graph, box);
    for (const int e : ends) {
        const Point2d d = box.positions[e] - places.middle;
        const double angle = math::atan2(d.x, -d.y);
        places.ends.push_back(box.positions[e]);
        places.bearings.push_back(angle < 0 ? angle + 2 * math::pi : angle);
        if (!trunk.empty()) places.beside_trunk.push_back(trunk.place(position_of(graph.vertices[e])));
    }
    return places;
}

} // namespace pantin
