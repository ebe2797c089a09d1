// SPDX-License-Identifier: MIT
// In come moving edges, out goes a binary tree of boxes around them that move and grow (S. Šaltenis et al.:
// Indexing the positions of continuously moving objects, 2000), halved where the edges' middles spread most.
#include "geometry/edge_index.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace pantin {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr Point2d most{never, never}, least{-never, -never};
constexpr std::size_t leaf = 8; // edges that are not worth another division

Point2d lower(Point2d a, Point2d b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
Point2d upper(Point2d a, Point2d b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

// In the frame whose x axis is the unit vector.
Point2d turned(Point2d p, Point2d axis) { return {dot(axis, p), cross(axis, p)}; }

} // namespace

EdgeIndex::EdgeIndex(std::vector<MovingEdge> edges, double time, double margin)
    : time_(time), margin_(margin) {
    if (!edges.empty()) build(edges);
}

// Adds the node of these edges and all below it; reorders the edges.
void EdgeIndex::build(std::span<MovingEdge> edges) {
    const std::size_t index = nodes_.size(), half = edges.size() / 2;
    nodes_.push_back(node_around(edges));
    if (edges.size() <= leaf) {
        nodes_[index].begin = static_cast<int>(numbers_.size());
        for (const MovingEdge& edge : edges) numbers_.push_back(edge.number);
        nodes_[index].end = static_cast<int>(numbers_.size());
        return;
    }
    const Point2d along = dividing_direction(edges, nodes_[index]);
    const auto key = [&](const MovingEdge& e) {
        return std::make_tuple(dot(e.from + e.to, along), e.number);
    };
    std::nth_element(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(half), edges.end(),
                     [&](const MovingEdge& a, const MovingEdge& b) { return key(a) < key(b); });
    build(edges.first(half));
    nodes_[index].second = static_cast<int>(nodes_.size());
    build(edges.subspan(half));
}

// The box lies along the longest edge: long edges side by side, like the teeth of a comb, have narrow boxes.
EdgeIndex::Node EdgeIndex::node_around(std::span<const MovingEdge> edges) const {
    Node node;
    double longest = 0;
    for (const MovingEdge& edge : edges) {
        const Point2d along = edge.to - edge.from;
        const double l = length(along);
        if (l > longest) node.axis = (1 / l) * along, longest = l;
    }
    node.low = node.low_rate = most;
    node.high = node.high_rate = least;
    for (const MovingEdge& edge : edges) {
        const Point2d from = turned(edge.from, node.axis), to = turned(edge.to, node.axis);
        const Point2d from_velocity = turned(edge.from_velocity, node.axis),
                      to_velocity = turned(edge.to_velocity, node.axis);
        node.low = lower(node.low, lower(from, to));
        node.high = upper(node.high, upper(from, to));
        node.low_rate = lower(node.low_rate, lower(from_velocity, to_velocity));
        node.high_rate = upper(node.high_rate, upper(from_velocity, to_velocity));
    }
    node.low = node.low - Point2d{margin_, margin_};
    node.high = node.high + Point2d{margin_, margin_};
    return node;
}

// The side of the box along which the edges' middles spread most, as a part of its length: so the halves'
// boxes are smallest.
Point2d EdgeIndex::dividing_direction(std::span<const MovingEdge> edges, const Node& node) {
    Point2d low = most, high = least;
    for (const MovingEdge& edge : edges) {
        const Point2d twice_middle = turned(edge.from + edge.to, node.axis);
        low = lower(low, twice_middle);
        high = upper(high, twice_middle);
    }
    const Point2d spread = high - low, size = node.high - node.low;
    return spread.x * size.y > spread.y * size.x ? node.axis : Point2d{-node.axis.y, node.axis.x};
}

// Whether the point, from the time on, is ever in the node's box; puts the time forward to when it first is.
bool EdgeIndex::enters(const Node& node, const MovingPoint& point, double& time) const {
    double begin = time - point.time, end = never;      // after the point's time
    const auto clip = [&](double inside, double rate) { // to when inside + rate · time ≥ 0
        if (rate > 0)
            begin = std::max(begin, -inside / rate);
        else if (rate < 0)
            end = std::min(end, -inside / rate);
        else if (inside < 0)
            end = -never;
    };
    const double age = point.time - time_; // of the box, then
    const Point2d low = node.low + age * node.low_rate, high = node.high + age * node.high_rate;
    const Point2d place = turned(point.place, node.axis), velocity = turned(point.velocity, node.axis);
    clip(place.x - low.x, velocity.x - node.low_rate.x);
    clip(place.y - low.y, velocity.y - node.low_rate.y);
    clip(high.x - place.x, node.high_rate.x - velocity.x);
    clip(high.y - place.y, node.high_rate.y - velocity.y);
    time = point.time + begin;
    return begin <= end;
}

} // namespace pantin
