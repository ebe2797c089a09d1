// SPDX-License-Identifier: MIT
// This work is based on:
// P. Felkel, Š. Obdržálek, Straight skeleton implementation, 1998: circular lists of corners and a queue of
// events. Differences: a split event is decided on when its time has come, by the moving edges as they are
// then, not when its corner is made; and where two opposite edges meet along their length, the nearer end
// goes first.
//
// In come loops, out goes the skeleton: clean_loops.cpp makes them fit, moving_polygon.cpp holds the corners,
// split_search.cpp finds the edges that a corner may split, and here is what happens when.
#include "pantin/straight_skeleton.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/split_search.hpp"

namespace pantin {
namespace wavefront {
namespace {

constexpr double tolerance = 1e-9; // of the diagonal

enum class EventKind { edge, split }; // in the order in which they are taken at one time

struct Event {
    double time = 0;
    EventKind kind = EventKind::edge;
    int corner = 0, other = 0; // edge event: the corners that meet; split event: the corner and the edge
    Point2d place;
    bool operator>(const Event& e) const {
        return std::tie(time, kind, corner, other) > std::tie(e.time, e.kind, e.corner, e.other);
    }
};

// When the edge after the corner vanishes, if it does; neither of its corners is flat.
std::optional<Event> vanishing(const MovingPolygon& polygon, int c) {
    const Corner &u = polygon.corners[c], &v = polygon.corners[u.next];
    const Point2d direction = polygon.lines[u.right].direction;
    Event event{never, EventKind::edge, c, u.next, {}};
    const double gap = dot(polygon.place_at(v, polygon.now) - polygon.place_at(u, polygon.now), direction);
    const double closing = dot(u.velocity - v.velocity, direction);
    if (!polygon.meeting(u.left, u.right, v.right, event.place, event.time)) {
        if (closing <= parallel) return std::nullopt;
        event.time = polygon.now + gap / closing;
        event.place = polygon.place_at(u, event.time);
    }
    // Corners that drift apart met in the past.
    const double small = polygon.small;
    if (event.time < polygon.now - small || (closing <= 0 && event.time < polygon.now + small && gap > small))
        return std::nullopt;
    event.time = std::max(event.time, polygon.now);
    return event;
}

// Two edges meet along their length at a flat corner: the end that is nearer goes first.
Event collapse(const MovingPolygon& polygon, int c) {
    const Corner& corner = polygon.corners[c];
    const Point2d before = polygon.place_at(polygon.corners[corner.previous], polygon.now),
                  after = polygon.place_at(polygon.corners[corner.next], polygon.now);
    const bool forward = distance(after, corner.origin) <= distance(before, corner.origin);
    const int from = forward ? c : corner.previous, to = forward ? corner.next : c;
    return {polygon.now, EventKind::edge, from, to, forward ? after : before};
}

// The events of one polygon in the order of time.
class Wavefront {
public:
    Wavefront(const CleanLoops& loops, std::set<int> unindexed)
        : polygon_(loops, tolerance), search_(std::move(unindexed)) {}

    // Right if it finds no more edges that cannot be in the index.
    StraightSkeleton shrink() {
        const int count = static_cast<int>(polygon_.corners.size());
        search_.make_index(polygon_);
        for (int c = 0; c < count; ++c) {
            schedule_edge(c);
            schedule_split(c);
        }
        while (!queue_.empty()) {
            const Event event = queue_.top();
            queue_.pop();
            polygon_.now = std::max(polygon_.now, event.time);
            if (search_.is_outdated(polygon_)) search_.make_index(polygon_);
            if (event.kind == EventKind::edge)
                edge_event(event);
            else
                split_event(event);
        }
        search_.check_reaches(polygon_);
        return std::move(polygon_.skeleton);
    }
    const std::set<int>& unindexed() const { return search_.unindexed(); }

private:
    // --- what will happen to a corner ---

    void schedule_edge(int c) {
        Corner& corner = polygon_.corners[c];
        corner.vanishes = never;
        if (corner.flat || polygon_.corners[corner.next].flat) {
            queue_.push(collapse(polygon_, corner.flat ? c : corner.next));
        } else if (const std::optional<Event> event = vanishing(polygon_, c)) {
            corner.vanishes = event->time;
            queue_.push(*event);
        }
    }
    void schedule_split(int c) {
        if (!polygon_.is_reflex(polygon_.corners[c])) return;
        if (const std::optional<Candidate> candidate = search_.next(polygon_, c))
            queue_.push({std::max(candidate->time, polygon_.now), EventKind::split, c, candidate->edge, {}});
    }
    void schedule_around(int c) {
        if (polygon_.corners[c].flat) {
            queue_.push(collapse(polygon_, c));
        } else {
            schedule_edge(polygon_.corners[c].previous);
            schedule_edge(c);
            schedule_split(c);
        }
    }

    // --- what happens ---

    // The corner ends at the node.
    void finish(int c, int node) {
        search_.check_reach(polygon_, c);
        polygon_.end(c);
        polygon_.add_arc(c, node);
    }
    // A loop of two corners has no area any more.
    bool close_if_empty(int c, int node) {
        const int other = polygon_.corners[c].next;
        if (other != c && polygon_.corners[other].next != c) return false;
        if (other != c) finish(other, node);
        polygon_.end(c);
        return true;
    }

    void edge_event(const Event& event) {
        const int u = event.corner, v = event.other;
        const std::vector<Corner>& corners = polygon_.corners;
        if (!corners[u].alive || !corners[v].alive || corners[u].next != v) return;
        const int node = polygon_.add_node(event.place, event.time);
        finish(u, node);
        finish(v, node);
        const int previous = corners[u].previous, next = corners[v].next;
        if (previous == v) return; // the loop was these two
        const int c = polygon_.add_corner(corners[u].left, corners[v].piece, previous, next, node);
        if (!close_if_empty(c, node)) schedule_around(c);
    }

    void split_event(const Event& event) {
        const int v = event.corner, edge = event.other;
        const Corner& corner = polygon_.corners[v];
        if (!corner.alive) return;
        if (edge == no_edge) {
            schedule_split(v);
            return;
        }
        Point2d place;
        double ignored = 0;
        if (!polygon_.meeting(corner.left, corner.right, edge, place, ignored))
            place = polygon_.place_at(corner, event.time);
        const int a = polygon_.corner_before(place, edge, v, search_.unindexed().empty());
        if (a < 0)
            schedule_split(v);
        else
            split(v, a, polygon_.add_node(place, event.time));
    }

    // The corner meets the piece that another one begins.
    void split(int v, int a, int node) {
        const std::vector<Corner>& corners = polygon_.corners;
        const bool divides = polygon_.in_one_loop(v, a);
        if (!divides) polygon_.join_loops(v, a);
        finish(v, node);
        const int before = corners[v].previous, after = corners[v].next, b = corners[a].next,
                  left = corners[v].left;
        const int one = polygon_.add_corner(left, polygon_.split_piece(a), before, b, node);
        const int two = polygon_.add_corner(corners[a].right, corners[v].piece, a, after, node);
        if (divides) polygon_.divide_loop(one, two);
        const bool one_closed = close_if_empty(one, node), two_closed = close_if_empty(two, node);
        if (!one_closed) schedule_around(one);
        if (!two_closed) schedule_around(two);
    }

    MovingPolygon polygon_;
    SplitSearch search_;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
};

} // namespace
} // namespace wavefront

StraightSkeleton straight_skeleton(const std::vector<std::vector<Point2d>>& loops) {
    const CleanLoops clean = clean_loops(loops, wavefront::tolerance);
    // Edges that reach farther than the index has them are left out of it, until none is found any more.
    for (std::set<int> unindexed;;) {
        wavefront::Wavefront wavefront(clean, unindexed);
        StraightSkeleton result = wavefront.shrink();
        if (wavefront.unindexed().size() == unindexed.size()) return result;
        unindexed = wavefront.unindexed();
    }
}

} // namespace pantin
