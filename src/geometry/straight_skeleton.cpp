// This work is based on:
// P. Felkel, Š. Obdržálek, Straight skeleton implementation, 1998: circular lists of corners and a queue of events. Differences: a
// split event is judged when its time has come, by the moving edges as they are then, not when its corner is made; and where two
// opposite edges meet along their length, the nearer end goes first.
#include "pantin/straight_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "geometry/extent.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr double tolerance = 1e-9;      // of the diagonal
constexpr double parallel = 1e-12;      // sine of the angle between lines that count as parallel
constexpr std::size_t batch = 24;       // split candidates that a corner keeps at a time
constexpr double never = std::numeric_limits<double>::infinity();

struct Line { // of a moving edge: normal · p = offset + time
    Point2d normal, direction;
    double offset = 0;
};

struct Corner {
    int left = 0, right = 0; // edges
    int previous = 0, next = 0;
    int node = 0; // where it comes from
    int border = 0; // of the polygon: index of its loop
    double time = 0;
    Point2d origin, velocity;
    bool alive = true, flat = false; // flat: its edges move against each other, it has no velocity
    struct Candidate {
        double time = 0;
        int edge = 0;
        bool operator<(const Candidate& c) const { return std::tie(time, edge) < std::tie(c.time, c.edge); }
    };
    std::vector<Candidate> candidates; // of a reflex corner: the next lines that it reaches, latest first
    double searched = -1;              // all earlier candidates have been looked at
    int searched_edge = -1;
};

struct Event {
    double time = 0;
    int kind = 0; // 0 edge event, 1 split event
    int corner = 0, other = 0; // edge event: the corners that meet; split event: the corner and the edge
    Point2d place;
    bool operator>(const Event& e) const {
        return std::tie(time, kind, corner, other) > std::tie(e.time, e.kind, e.corner, e.other);
    }
};

[[noreturn]] void fail(const std::string& what) { throw Error(ErrorKind::input, "straight skeleton: " + what); }

class Wavefront {
public:
    explicit Wavefront(const std::vector<std::vector<Point2d>>& loops) {
        measure(loops);
        for (std::size_t l = 0; l < loops.size(); ++l) add_loop(loops[l], l == 0);
    }

    StraightSkeleton shrink() {
        const int count = static_cast<int>(corners_.size());
        for (int c = 0; c < count; ++c) start(c);
        for (int c = 0; c < count; ++c) {
            schedule_edge(c);
            schedule_split(c);
        }
        while (!queue_.empty()) {
            const Event event = queue_.top();
            queue_.pop();
            now_ = std::max(now_, event.time);
            if (event.kind == 0)
                edge_event(event);
            else
                split_event(event);
        }
        return std::move(result_);
    }

private:
    void measure(const std::vector<std::vector<Point2d>>& loops) {
        Point2d low{never, never}, high{-never, -never};
        for (const auto& loop : loops)
            for (const Point2d& p : loop) {
                if (!std::isfinite(p.x) || !std::isfinite(p.y)) fail("a coordinate is not a number");
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        if (loops.empty() || low.x > high.x) fail("there is no corner");
        small_ = tolerance * distance(low, high);
    }

    // Without doubles and points on straight lines, the interior on the left.
    std::vector<Point2d> cleaned(std::vector<Point2d> loop, bool outer) const {
        for (bool changed = true; changed && loop.size() >= 3;) {
            changed = false;
            for (std::size_t i = 0; i < loop.size() && loop.size() >= 3;) {
                const Point2d before = loop[(i + loop.size() - 1) % loop.size()], after = loop[(i + 1) % loop.size()];
                const Point2d u = loop[i] - before, v = after - loop[i];
                const bool twice = length(u) <= small_;
                const bool straight = !twice && length(v) > small_ && std::abs(cross(u, v)) <= small_ * std::max(length(u), length(v)) && dot(u, v) > 0;
                if (twice || straight) {
                    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
                    changed = true;
                } else {
                    ++i;
                }
            }
        }
        if (loop.size() < 3) fail("a loop has fewer than three corners");
        const double area = area_of(loop);
        if (area == 0) fail("a loop has no area");
        if ((area > 0) != outer) std::reverse(loop.begin(), loop.end());
        return loop;
    }

    void add_loop(const std::vector<Point2d>& raw, bool outer) {
        const std::vector<Point2d> loop = cleaned(raw, outer);
        const int first = static_cast<int>(corners_.size()), n = static_cast<int>(loop.size());
        for (int i = 0; i < n; ++i) {
            const Point2d from = loop[i], to = loop[(i + 1) % n];
            const Point2d direction = (1 / distance(from, to)) * (to - from), normal{-direction.y, direction.x};
            lines_.push_back({normal, direction, dot(normal, from)});
            segments_.push_back({first + i});
            result_.corners.push_back(from);
            result_.next.push_back(first + (i + 1) % n);
            result_.nodes.push_back({from, 0});
            Corner corner;
            corner.left = first + (i + n - 1) % n;
            corner.right = first + i;
            corner.previous = corner.left;
            corner.next = first + (i + 1) % n;
            corner.node = first + i;
            corner.border = static_cast<int>(borders_.size());
            corners_.push_back(corner);
        }
        borders_.push_back(static_cast<int>(borders_.size()));
    }

    // Origin and velocity of a new corner.
    void start(int c) {
        Corner& corner = corners_[c];
        const Line &a = lines_[corner.left], &b = lines_[corner.right];
        corner.origin = result_.nodes[corner.node].place;
        corner.time = result_.nodes[corner.node].time;
        const double sine = cross(a.normal, b.normal), cosine = dot(a.normal, b.normal);
        if (std::abs(sine) > parallel)
            corner.velocity = {(b.normal.y - a.normal.y) / sine, (a.normal.x - b.normal.x) / sine};
        else if (cosine > 0)
            corner.velocity = a.normal;
        else
            corner.flat = true;
    }
    Point2d place_at(const Corner& corner, double time) const {
        return corner.flat ? corner.origin : corner.origin + (time - corner.time) * corner.velocity;
    }
    bool is_reflex(const Corner& corner) const {
        return !corner.flat && cross(lines_[corner.left].direction, lines_[corner.right].direction) < -parallel;
    }

    // The point equally far from three moving lines, and the time; false when they have none.
    bool meeting(int i, int j, int k, Point2d& place, double& time) const {
        const Line &a = lines_[i], &b = lines_[j], &c = lines_[k];
        const Point2d u = b.normal - a.normal, v = c.normal - b.normal;
        const double determinant = cross(u, v);
        if (std::abs(determinant) <= parallel) return false;
        const double f = b.offset - a.offset, g = c.offset - b.offset;
        place = {(f * v.y - g * u.y) / determinant, (u.x * g - v.x * f) / determinant};
        time = dot(b.normal, place) - b.offset;
        return true;
    }

    // When the edge after the corner vanishes.
    void schedule_edge(int c) {
        const Corner &u = corners_[c], &v = corners_[u.next];
        Event event{never, 0, c, u.next, {}};
        if (u.flat || v.flat) {
            schedule_flat(u.flat ? c : u.next);
            return;
        }
        const double gap = dot(place_at(v, now_) - place_at(u, now_), lines_[u.right].direction);
        const double closing = dot(u.velocity - v.velocity, lines_[u.right].direction);
        if (!meeting(u.left, u.right, v.right, event.place, event.time)) {
            if (closing <= parallel) return;
            event.time = now_ + gap / closing;
            event.place = place_at(u, event.time);
        }
        // Corners that drift apart met in the past.
        if (event.time < now_ - small_ || (closing <= 0 && event.time < now_ + small_ && gap > small_)) return;
        event.time = std::max(event.time, now_);
        queue_.push(event);
    }

    // Two edges meet along their length: the end that is nearer goes first.
    void schedule_flat(int c) {
        const Corner& corner = corners_[c];
        const Point2d before = place_at(corners_[corner.previous], now_), after = place_at(corners_[corner.next], now_);
        const bool forward = distance(after, corner.origin) <= distance(before, corner.origin);
        const int from = forward ? c : corner.previous, to = forward ? corner.next : c;
        queue_.push({now_, 0, from, to, forward ? after : before});
    }

    // The next lines that a reflex corner reaches: a heap of the earliest ones, the latest of them on top.
    void search(Corner& corner) const {
        std::vector<Corner::Candidate> found;
        const Corner::Candidate last{corner.searched, corner.searched_edge};
        double latest = never;
        for (int e = 0; e < static_cast<int>(lines_.size()); ++e) {
            const Line& line = lines_[e];
            const double height = dot(line.normal, corner.origin) - line.offset - corner.time;
            const double closing = 1 - dot(line.normal, corner.velocity);
            if (closing <= parallel || height < -small_ || height > (latest - corner.time) * closing) continue;
            if (e == corner.left || e == corner.right) continue;
            const Corner::Candidate candidate{corner.time + std::max(0.0, height) / closing, e};
            if (!(last < candidate)) continue;
            found.push_back(candidate);
            std::push_heap(found.begin(), found.end());
            if (found.size() <= batch) continue;
            std::pop_heap(found.begin(), found.end());
            found.pop_back();
            latest = found.front().time;
        }
        std::sort_heap(found.begin(), found.end());
        std::reverse(found.begin(), found.end());
        corner.candidates = std::move(found);
    }

    void schedule_split(int c) {
        Corner& corner = corners_[c];
        if (!is_reflex(corner)) return;
        if (corner.candidates.empty()) search(corner);
        if (corner.candidates.empty()) return;
        const Corner::Candidate candidate = corner.candidates.back();
        corner.candidates.pop_back();
        corner.searched = candidate.time;
        corner.searched_edge = candidate.edge;
        queue_.push({std::max(candidate.time, now_), 1, c, candidate.edge, {}});
    }

    int add_node(Point2d place, double time) {
        result_.nodes.push_back({place, time});
        return static_cast<int>(result_.nodes.size()) - 1;
    }
    // The corner ends at the node.
    void finish(int c, int node) {
        Corner& corner = corners_[c];
        corner.alive = false;
        if (corner.node != node) result_.arcs.push_back({corner.node, node, corner.left, corner.right});
    }
    int add_corner(int left, int right, int previous, int next, int node) {
        const int c = static_cast<int>(corners_.size());
        Corner corner;
        corner.left = left;
        corner.right = right;
        corner.previous = previous;
        corner.next = next;
        corner.node = node;
        corner.border = corners_[previous].border;
        corners_.push_back(corner);
        corners_[previous].next = c;
        corners_[next].previous = c;
        segments_[right].push_back(c);
        start(c);
        return c;
    }
    // A loop of two corners has no area any more.
    bool close_if_empty(int c, int node) {
        const int other = corners_[c].next;
        if (other != c && corners_[other].next != c) return false;
        if (other != c) finish(other, node);
        corners_[c].alive = false;
        return true;
    }
    void schedule_around(int c) {
        if (corners_[c].flat) {
            schedule_flat(c);
        } else {
            schedule_edge(corners_[c].previous);
            schedule_edge(c);
            schedule_split(c);
        }
    }

    void edge_event(const Event& event) {
        const int u = event.corner, v = event.other;
        if (!corners_[u].alive || !corners_[v].alive || corners_[u].next != v) return;
        const int node = add_node(event.place, event.time);
        finish(u, node);
        finish(v, node);
        const int previous = corners_[u].previous, next = corners_[v].next;
        if (previous == v) return; // the loop was these two
        const int c = add_corner(corners_[u].left, corners_[v].right, previous, next, node);
        if (!close_if_empty(c, node)) schedule_around(c);
    }

    int border_of(int corner) {
        int b = corners_[corner].border;
        while (borders_[b] != b) b = borders_[b];
        return b;
    }
    // Whether the two corners may meet: in one loop, or in loops that come from borders that have not met. Loops that were split
    // touch at the places where they were, and nowhere else.
    bool may_meet(int a, int b) {
        if (border_of(a) != border_of(b)) return true;
        for (int c = corners_[a].next; c != a; c = corners_[c].next)
            if (c == b) return true;
        return false;
    }

    // The corner of the edge's moving segment that holds the place, or −1.
    int segment_at(int edge, int corner, Point2d place) {
        std::vector<int>& list = segments_[edge];
        std::erase_if(list, [&](int c) { return !corners_[c].alive || corners_[c].right != edge; });
        const double s = dot(lines_[edge].direction, place);
        for (const int a : list) {
            const int b = corners_[a].next;
            if (a == corner || b == corner) continue;
            const double from = dot(lines_[edge].direction, place_at(corners_[a], now_));
            const double to = dot(lines_[edge].direction, place_at(corners_[b], now_));
            if (s >= from - small_ && s <= to + small_ && may_meet(corner, a)) return a;
        }
        return -1;
    }

    void split_event(const Event& event) {
        const int v = event.corner, edge = event.other;
        if (!corners_[v].alive) return;
        Point2d place;
        double ignored = 0;
        if (!meeting(corners_[v].left, corners_[v].right, edge, place, ignored)) place = place_at(corners_[v], event.time);
        const int a = segment_at(edge, v, place);
        if (a < 0) {
            schedule_split(v);
            return;
        }
        borders_[border_of(v)] = border_of(a);
        const int node = add_node(place, event.time), b = corners_[a].next;
        finish(v, node);
        const int before = corners_[v].previous, after = corners_[v].next, left = corners_[v].left, right = corners_[v].right;
        const int one = add_corner(left, edge, before, b, node);
        const int two = add_corner(edge, right, a, after, node);
        const bool one_closed = close_if_empty(one, node), two_closed = close_if_empty(two, node);
        if (!one_closed) schedule_around(one);
        if (!two_closed) schedule_around(two);
    }

    double small_ = 0, now_ = 0;
    std::vector<Line> lines_; // of the edges
    std::vector<std::vector<int>> segments_; // per edge: corners that begin a moving piece of it, and some that are gone
    std::vector<Corner> corners_;
    std::vector<int> borders_; // union-find over the polygon's loops
    std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
    StraightSkeleton result_;
};

} // namespace

StraightSkeleton straight_skeleton(const std::vector<std::vector<Point2d>>& loops) { return Wavefront(loops).shrink(); }

} // namespace pantin
