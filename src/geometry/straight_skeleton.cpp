// SPDX-License-Identifier: MIT
// This work is based on:
// P. Felkel, Š. Obdržálek, Straight skeleton implementation, 1998: circular lists of corners and a queue of
// events. Differences: a split event is judged when its time has come, by the moving edges as they are then,
// not when its corner is made; and where two opposite edges meet along their length, the nearer end goes
// first. The edges that a corner may split are found by an index of the moving edges, which is made anew as
// corners go.
#include "pantin/straight_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/extent.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-9; // of the diagonal
constexpr double parallel = 1e-12; // sine of the angle between lines that count as parallel
constexpr double margin =
    1e-6; // of the diagonal: how far pieces of edges may be from where the index has them
constexpr double leeway =
    margin / 64; // of the diagonal: how much farther than they should they may reach, each time
constexpr double remaining = 0.9,
                 patience = 32; // an index is made anew when no more corners than this part are left, and the
                                // searches have looked at this many pieces for each
constexpr int nothing = std::numeric_limits<int>::max(); // no edge: a corner is to search on

struct Line { // of a moving edge: normal · p = offset + time
    Point2d normal, direction;
    double offset = 0;
};

struct Candidate { // for a split: when a reflex corner reaches the line of an edge
    double time = -1;
    int edge = -1;
    bool operator<(const Candidate& c) const { return std::tie(time, edge) < std::tie(c.time, c.edge); }
};

// A piece of a moving edge. The index has it, and whatever becomes of it, from begin − before · time to end +
// after · time along the edge's direction, the time counted from that of the index.
struct Piece {
    int edge = 0, corner = 0; // corner: that begins it
    double begin = -never, end = never, before = never, after = never;
};

struct Corner {
    int left = 0, right = 0; // edges
    int previous = 0, next = 0;
    int piece = 0;  // that it begins, of its right edge
    int node = 0;   // where it comes from
    int border = 0; // of the polygon: index of its loop
    int loop = 0;   // of corners that it is in now
    double time = 0;
    Point2d origin, velocity;
    bool alive = true, flat = false; // flat: its edges move against each other, it has no velocity
    double vanishes = never;         // when its piece will, as things are
    // Of a reflex corner: the last candidate that was looked at, the next ones, latest first, and how many
    // the next search keeps.
    Candidate searched;
    std::vector<Candidate> candidates;
    std::size_t batch = 1;
};

struct Event {
    double time = 0;
    int kind = 0;              // 0 edge event, 1 split event
    int corner = 0, other = 0; // edge event: the corners that meet; split event: the corner and the edge
    Point2d place;
    bool operator>(const Event& e) const {
        return std::tie(time, kind, corner, other) > std::tie(e.time, e.kind, e.corner, e.other);
    }
};

[[noreturn]] void fail(const std::string& what) {
    throw Error(ErrorKind::input, "straight skeleton: " + what);
}

class Wavefront {
public:
    Wavefront(const std::vector<std::vector<Point2d>>& loops, const std::set<int>& strays) : strays_(strays) {
        measure(loops);
        for (std::size_t l = 0; l < loops.size(); ++l) add_loop(loops[l], l == 0);
    }

    // Edges that reached farther than they should, those that were given included. The index does not have
    // them: every corner looks at them.
    const std::set<int>& strays() const { return strays_; }

    // Right if it finds no more strays.
    StraightSkeleton shrink() {
        const int count = static_cast<int>(corners_.size());
        for (int c = 0; c < count; ++c) start(c);
        make_index();
        for (int c = 0; c < count; ++c) {
            schedule_edge(c);
            schedule_split(c);
        }
        while (!queue_.empty()) {
            const Event event = queue_.top();
            queue_.pop();
            now_ = std::max(now_, event.time);
            if (alive_ < remaining * indexed_ && looks_ > patience * alive_) make_index();
            if (event.kind == 0)
                edge_event(event);
            else
                split_event(event);
        }
        check_reaches();
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
        diagonal_ = distance(low, high);
        small_ = tolerance * diagonal_;
    }

    // Whether a corner is the same as the one before, or on the straight line between its neighbours.
    bool is_idle(Point2d before, Point2d corner, Point2d after) const {
        const Point2d u = corner - before, v = after - corner;
        if (length(u) <= small_) return true;
        return length(v) > small_ && std::abs(cross(u, v)) <= small_ * std::max(length(u), length(v)) &&
               dot(u, v) > 0;
    }

    // Leaves out idle corners, once around; those that stay move to the front.
    void clean_once(std::vector<Point2d>& loop) const {
        std::size_t kept = 0, i = 0;
        for (; i < loop.size() && kept + loop.size() - i >= 3; ++i) {
            const Point2d before = kept > 0 ? loop[kept - 1] : loop.back();
            const Point2d after = i + 1 < loop.size() ? loop[i + 1] : loop.front();
            if (!is_idle(before, loop[i], after)) loop[kept++] = loop[i];
        }
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(kept),
                   loop.begin() + static_cast<std::ptrdiff_t>(i));
    }

    // Without doubles and points on straight lines, the interior on the left.
    std::vector<Point2d> cleaned(std::vector<Point2d> loop, bool outer) const {
        for (std::size_t before = 0; loop.size() != before && loop.size() >= 3;) {
            before = loop.size();
            clean_once(loop);
        }
        if (loop.size() < 3) fail("a loop has fewer than three corners");
        const double area = area_of(loop);
        if (area == 0) fail("a loop has no area");
        if ((area > 0) != outer) std::reverse(loop.begin(), loop.end());
        return loop;
    }

    void add_loop(const std::vector<Point2d>& raw, bool outer) {
        const std::vector<Point2d> loop = cleaned(raw, outer);
        const int first = static_cast<int>(corners_.size()), n = static_cast<int>(loop.size()),
                  border = borders_.add();
        loops_ = border + 1;
        for (int i = 0; i < n; ++i) {
            const Point2d from = loop[i], to = loop[(i + 1) % n];
            const Point2d direction = (1 / distance(from, to)) * (to - from),
                          normal{-direction.y, direction.x};
            lines_.push_back({normal, direction, dot(normal, from)});
            pieces_.push_back({first + i, first + i});
            segments_.push_back({first + i});
            changed_.push_back(false);
            result_.corners.push_back(from);
            result_.next.push_back(first + (i + 1) % n);
            result_.nodes.push_back({from, 0});
            Corner corner;
            corner.left = first + (i + n - 1) % n;
            corner.right = first + i;
            corner.previous = corner.left;
            corner.next = first + (i + 1) % n;
            corner.piece = first + i;
            corner.node = first + i;
            corner.border = corner.loop = border;
            corners_.push_back(corner);
        }
        alive_ += n;
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
        return !corner.flat &&
               cross(lines_[corner.left].direction, lines_[corner.right].direction) < -parallel;
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
        corners_[c].vanishes = never;
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
        if (event.time < now_ - small_ || (closing <= 0 && event.time < now_ + small_ && gap > small_))
            return;
        event.time = std::max(event.time, now_);
        corners_[c].vanishes = event.time;
        queue_.push(event);
    }

    // Two edges meet along their length: the end that is nearer goes first.
    void schedule_flat(int c) {
        const Corner& corner = corners_[c];
        const Point2d before = place_at(corners_[corner.previous], now_),
                      after = place_at(corners_[corner.next], now_);
        const bool forward = distance(after, corner.origin) <= distance(before, corner.origin);
        const int from = forward ? c : corner.previous, to = forward ? corner.next : c;
        queue_.push({now_, 0, from, to, forward ? after : before});
    }

    // When the corner reaches the line of the edge; false when it never does.
    bool reaches_line(const Corner& corner, int edge, double& time) const {
        const Line& line = lines_[edge];
        const double height = dot(line.normal, corner.origin) - line.offset - corner.time;
        const double closing = 1 - dot(line.normal, corner.velocity);
        if (closing <= parallel || height < -small_ || edge == corner.left || edge == corner.right)
            return false;
        time = corner.time + std::max(0.0, height) / closing;
        return true;
    }

    // Looks for the corner's next candidates whose edges can be there.
    void search(Corner& corner) {
        const double from = std::max(corner.searched.time, corner.time);
        const double end = std::min(corner.vanishes, corners_[corner.previous].vanishes);
        const double until =
            end > from ? end : never; // most corners end with one of their edges: no need to look farther
        std::vector<Candidate> found; // a heap of the earliest ones, the latest of them on top
        Candidate limit{until, nothing};
        const auto look = [&](int number) {
            ++looks_;
            const Piece& piece = pieces_[number];
            Candidate c{0, piece.edge};
            if (!reaches_line(corner, piece.edge, c.time) || !(c < limit) || !(corner.searched < c))
                return limit.time;
            const Point2d place = place_at(corner, c.time);
            if (!begins_before(piece, place, c.time, margin) || !ends_after(piece, place, c.time, margin))
                return limit.time;
            found.push_back(c);
            std::push_heap(found.begin(), found.end());
            if (found.size() > corner.batch) {
                std::pop_heap(found.begin(), found.end());
                found.pop_back();
            }
            if (found.size() == corner.batch) limit = found.front();
            return limit.time;
        };
        for (const int piece : loose_) look(piece);
        index_.search({corner.origin, corner.velocity, corner.time}, from, limit.time, look);
        std::sort_heap(found.begin(), found.end());
        if (found.size() == corner.batch)
            corner.batch *= 4; // most corners need no more, but those that do may need many
        else if (until < never)
            found.push_back({until, nothing});
        corner.candidates.assign(found.rbegin(), found.rend());
    }

    void schedule_split(int c) {
        Corner& corner = corners_[c];
        if (!is_reflex(corner)) return;
        for (;;) {
            if (corner.candidates.empty()) search(corner);
            if (corner.candidates.empty()) return;
            const Candidate candidate = corner.candidates.back();
            corner.candidates.pop_back();
            if (!(corner.searched < candidate)) continue; // the same edge again, by another piece
            corner.searched = candidate;
            queue_.push({std::max(candidate.time, now_), 1, c, candidate.edge, {}});
            return;
        }
    }

    // Makes the index, of all pieces as they are now. None will ever reach farther than the corners at its
    // ends would take it, were they to go on: an edge only vanishes where the corners at its ends turn left
    // by more than right, and so the one that takes their place turns left; and where reflex corners meet,
    // the new ones are less sharp than they were.
    void make_index() {
        check_reaches();
        index_time_ = now_;
        indexed_ = alive_;
        looks_ = 0;
        loose_.clear();
        std::vector<MovingEdge> edges;
        for (const Corner& from : corners_) {
            if (!from.alive) continue;
            Piece& piece = pieces_[from.piece];
            if (strays_.contains(piece.edge)) {
                piece.begin = -never, piece.end = never, piece.before = piece.after = 0;
                loose_.push_back(from.piece);
                continue;
            }
            const Corner& to = corners_[from.next];
            const Point2d normal = lines_[piece.edge].normal, along = lines_[piece.edge].direction;
            const Point2d begin = place_at(from, now_), end = place_at(to, now_);
            piece.begin = dot(along, begin);
            piece.end = dot(along, end);
            piece.before = std::min(piece.before, std::max(0.0, -dot(along, from.velocity)));
            piece.after = std::min(piece.after, std::max(0.0, dot(along, to.velocity)));
            edges.push_back(
                {from.piece, begin, end, normal - piece.before * along, normal + piece.after * along});
        }
        index_ = EdgeIndex(std::move(edges), now_, margin * diagonal_);
    }
    // Whether the piece, with an allowance, begins before the place; whether it ends after it.
    bool begins_before(const Piece& piece, Point2d place, double time, double allowance) const {
        const double s = dot(lines_[piece.edge].direction, place) + allowance * diagonal_;
        return s >= piece.begin - (time - index_time_) * piece.before;
    }
    bool ends_after(const Piece& piece, Point2d place, double time, double allowance) const {
        const double s = dot(lines_[piece.edge].direction, place) - allowance * diagonal_;
        return s <= piece.end + (time - index_time_) * piece.after;
    }
    // That no piece reaches too far is a theorem about simple polygons and exact numbers. Edges for which it
    // is not true are found out here, by the whole way of every corner: what holds at two times holds between
    // them.
    void check_reach(int c) {
        const Corner& corner = corners_[c];
        const Piece &left = pieces_[corners_[corner.previous].piece], &right = pieces_[corner.piece];
        for (const double time : {std::max(corner.time, index_time_), now_}) {
            const Point2d place = place_at(corner, time);
            if (!begins_before(right, place, time, leeway)) strays_.insert(right.edge);
            if (!ends_after(left, place, time, leeway)) strays_.insert(left.edge);
        }
    }
    void check_reaches() {
        if (indexed_ == 0) return; // there is no index yet
        for (int c = 0; c < static_cast<int>(corners_.size()); ++c)
            if (corners_[c].alive) check_reach(c);
    }

    int add_node(Point2d place, double time) {
        result_.nodes.push_back({place, time});
        return static_cast<int>(result_.nodes.size()) - 1;
    }
    void end(int c) {
        corners_[c].alive = false;
        changed_[corners_[c].right] = true;
        --alive_;
    }
    // The corner ends at the node.
    void finish(int c, int node) {
        const Corner& corner = corners_[c];
        check_reach(c);
        end(c);
        if (corner.node != node) result_.arcs.push_back({corner.node, node, corner.left, corner.right});
    }
    // A new piece, for what lies beyond the place where the one that the corner begins is split.
    int split_piece(int a) {
        const int piece = static_cast<int>(pieces_.size());
        pieces_.push_back(Piece(pieces_[corners_[a].piece]));
        std::vector<int>& list = segments_[corners_[a].right];
        list.insert(std::find(list.begin(), list.end(), corners_[a].piece) + 1, piece);
        return piece;
    }
    // The corner begins the piece now.
    int add_corner(int left, int piece, int previous, int next, int node) {
        const int c = static_cast<int>(corners_.size());
        Corner corner;
        corner.left = left;
        corner.right = pieces_[piece].edge;
        corner.piece = piece;
        corner.previous = previous;
        corner.next = next;
        corner.node = node;
        corner.border = corners_[previous].border;
        corner.loop = corners_[previous].loop;
        corners_.push_back(corner);
        corners_[previous].next = c;
        corners_[next].previous = c;
        pieces_[piece].corner = c;
        start(c);
        ++alive_;
        return c;
    }
    // A loop of two corners has no area any more.
    bool close_if_empty(int c, int node) {
        const int other = corners_[c].next;
        if (other != c && corners_[other].next != c) return false;
        if (other != c) finish(other, node);
        end(c);
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
        const int c = add_corner(corners_[u].left, corners_[v].piece, previous, next, node);
        if (!close_if_empty(c, node)) schedule_around(c);
    }

    // Whether the two corners may meet: in one loop, or in loops that come from borders that have not met.
    // Loops that were split touch at the places where they were, and nowhere else.
    bool may_meet(int a, int b) {
        return corners_[a].loop == corners_[b].loop ||
               borders_.find(corners_[a].border) != borders_.find(corners_[b].border);
    }
    // The one of two corners whose loop has fewer corners; takes as long as walking along that loop.
    int in_shorter_loop(int a, int b) const {
        for (int i = corners_[a].next, k = corners_[b].next;; i = corners_[i].next, k = corners_[k].next) {
            if (i == a) return a;
            if (k == b) return b;
        }
    }
    void name_loop(int c, int name) {
        for (int i = c; corners_[i].loop != name; i = corners_[i].next) corners_[i].loop = name;
    }

    // The corner of the edge's moving segment that holds the place, or −1. Of several, the one that was there
    // first.
    int segment_at(int edge, int corner, Point2d place) {
        std::vector<int>& list = segments_[edge];
        const auto begin = [&](int piece) { return pieces_[piece].corner; };
        if (changed_[edge]) std::erase_if(list, [&](int piece) { return !corners_[begin(piece)].alive; });
        changed_[edge] = false;
        const auto along = [&](int c) { return dot(lines_[edge].direction, place_at(corners_[c], now_)); };
        const double s = dot(lines_[edge].direction, place);
        auto i = list.begin(), last = list.end();
        if (strays_.empty()) { // the pieces are in order, up to rounding, unless the polygon crosses itself
            i = std::partition_point(i, last,
                                     [&](int p) { return along(corners_[begin(p)].next) < s - 2 * small_; });
            last = std::find_if(i, last, [&](int p) { return along(begin(p)) > s + 2 * small_; });
        }
        int found = -1;
        for (; i != last; ++i) {
            const int a = begin(*i), b = corners_[a].next;
            if (a == corner || b == corner || (found >= 0 && found < a)) continue;
            if (s >= along(a) - small_ && s <= along(b) + small_ && may_meet(corner, a)) found = a;
        }
        return found;
    }

    // For loops of two corners that become one.
    void join_loops(int v, int a) {
        const int renamed = in_shorter_loop(v, a);
        name_loop(renamed, corners_[renamed == v ? a : v].loop);
        borders_.unite(corners_[v].border, corners_[a].border);
    }

    void split_event(const Event& event) {
        const int v = event.corner, edge = event.other;
        if (!corners_[v].alive) return;
        if (edge == nothing) {
            schedule_split(v);
            return;
        }
        Point2d place;
        double ignored = 0;
        if (!meeting(corners_[v].left, corners_[v].right, edge, place, ignored))
            place = place_at(corners_[v], event.time);
        const int a = segment_at(edge, v, place);
        if (a < 0)
            schedule_split(v);
        else
            split(v, a, add_node(place, event.time));
    }

    // The corner meets the piece that another one begins.
    void split(int v, int a, int node) {
        const bool divides = corners_[v].loop == corners_[a].loop;
        if (!divides) join_loops(v, a);
        finish(v, node);
        const int before = corners_[v].previous, after = corners_[v].next, b = corners_[a].next,
                  left = corners_[v].left;
        const int one = add_corner(left, split_piece(a), before, b, node);
        const int two = add_corner(corners_[a].right, corners_[v].piece, a, after, node);
        if (divides) name_loop(in_shorter_loop(one, two), loops_++);
        const bool one_closed = close_if_empty(one, node), two_closed = close_if_empty(two, node);
        if (!one_closed) schedule_around(one);
        if (!two_closed) schedule_around(two);
    }

    double diagonal_ = 0, small_ = 0, now_ = 0;
    std::vector<Line> lines_; // of the edges
    std::vector<std::vector<int>>
        segments_;              // per edge: its moving pieces, in order, and some that are gone where
    std::vector<bool> changed_; // that is so
    std::vector<Piece> pieces_;
    std::vector<Corner> corners_;
    DisjointSets borders_;        // the polygon's loops; those that have met are in one set
    int loops_ = 0;               // names that loops of corners have had
    int alive_ = 0, indexed_ = 0; // corners: now, and when the index was made
    EdgeIndex index_;
    double index_time_ = 0;  // when that was
    double looks_ = 0;       // of searches at pieces, since then
    std::vector<int> loose_; // pieces of strays
    std::set<int> strays_;   // edges
    std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
    StraightSkeleton result_;
};

} // namespace

StraightSkeleton straight_skeleton(const std::vector<std::vector<Point2d>>& loops) {
    for (std::set<int> strays;;) {
        Wavefront wavefront(loops, strays);
        StraightSkeleton result = wavefront.shrink();
        if (wavefront.strays().size() == strays.size()) return result;
        strays = wavefront.strays();
    }
}

} // namespace pantin
