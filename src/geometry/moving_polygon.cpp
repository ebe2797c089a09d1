// SPDX-License-Identifier: MIT
// In come clean loops; corners and pieces come and go as the straight skeleton's events say (P. Felkel, Š.
// Obdržálek, Straight skeleton implementation, 1998).
#include "geometry/moving_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pantin::wavefront {

MovingPolygon::MovingPolygon(const CleanLoops& clean, double tolerance)
    : diagonal(clean.diagonal), small(tolerance * clean.diagonal) {
    for (const std::vector<Point2d>& loop : clean.loops) add_loop(loop);
    for (int c = 0; c < std::ssize(corners); ++c) start(c);
}

void MovingPolygon::add_loop(const std::vector<Point2d>& loop) {
    const int first = static_cast<int>(corners.size()), n = static_cast<int>(loop.size()),
              border = borders_.add();
    loops_ = border + 1;
    for (int i = 0; i < n; ++i) {
        const Point2d from = loop[i], to = loop[(i + 1) % n];
        const Point2d direction = (1 / distance(from, to)) * (to - from), normal{-direction.y, direction.x};
        lines.push_back({normal, direction, dot(normal, from)});
        pieces.push_back({first + i, first + i});
        segments_.push_back({first + i});
        changed_.push_back(false);
        skeleton.corners.push_back(from);
        skeleton.next.push_back(first + (i + 1) % n);
        skeleton.nodes.push_back({from, 0});
        Corner corner;
        corner.left = first + (i + n - 1) % n;
        corner.right = first + i;
        corner.previous = corner.left;
        corner.next = first + (i + 1) % n;
        corner.piece = first + i;
        corner.node = first + i;
        corner.border = corner.loop = border;
        corners.push_back(corner);
    }
    alive += n;
}

// Origin and velocity of a new corner.
void MovingPolygon::start(int c) {
    Corner& corner = corners[c];
    const Line &a = lines[corner.left], &b = lines[corner.right];
    corner.origin = skeleton.nodes[corner.node].place;
    corner.time = skeleton.nodes[corner.node].time;
    const double sine = cross(a.normal, b.normal), cosine = dot(a.normal, b.normal);
    if (std::abs(sine) > parallel)
        corner.velocity = {(b.normal.y - a.normal.y) / sine, (a.normal.x - b.normal.x) / sine};
    else if (cosine > 0)
        corner.velocity = a.normal;
    else
        corner.flat = true;
}

bool MovingPolygon::meeting(int i, int j, int k, Point2d& place, double& time) const {
    const Line &a = lines[i], &b = lines[j], &c = lines[k];
    const Point2d u = b.normal - a.normal, v = c.normal - b.normal;
    const double determinant = cross(u, v);
    if (std::abs(determinant) <= parallel) return false;
    const double f = b.offset - a.offset, g = c.offset - b.offset;
    place = {(f * v.y - g * u.y) / determinant, (u.x * g - v.x * f) / determinant};
    time = dot(b.normal, place) - b.offset;
    return true;
}

// --- corners and pieces ------------------------------------------------------------------------------------

int MovingPolygon::add_node(Point2d place, double time) {
    skeleton.nodes.push_back({place, time});
    return static_cast<int>(skeleton.nodes.size()) - 1;
}

int MovingPolygon::add_corner(int left, int piece, int previous, int next, int node) {
    const int c = static_cast<int>(corners.size());
    Corner corner;
    corner.left = left;
    corner.right = pieces[piece].edge;
    corner.piece = piece;
    corner.previous = previous;
    corner.next = next;
    corner.node = node;
    corner.border = corners[previous].border;
    corner.loop = corners[previous].loop;
    corners.push_back(corner);
    corners[previous].next = c;
    corners[next].previous = c;
    pieces[piece].corner = c;
    start(c);
    ++alive;
    return c;
}

int MovingPolygon::split_piece(int corner) {
    const int piece = static_cast<int>(pieces.size());
    pieces.push_back(Piece(pieces[corners[corner].piece]));
    std::vector<int>& list = segments_[corners[corner].right];
    list.insert(std::find(list.begin(), list.end(), corners[corner].piece) + 1, piece);
    return piece;
}

void MovingPolygon::end(int corner) {
    corners[corner].alive = false;
    changed_[corners[corner].right] = true;
    --alive;
}

void MovingPolygon::add_arc(int corner, int node) {
    const Corner& c = corners[corner];
    if (c.node != node) skeleton.arcs.push_back({c.node, node, c.left, c.right});
}

int MovingPolygon::corner_before(Point2d place, int edge, int corner, bool in_order) {
    std::vector<int>& list = segments_[edge];
    const auto begin = [&](int piece) { return pieces[piece].corner; };
    if (changed_[edge]) std::erase_if(list, [&](int piece) { return !corners[begin(piece)].alive; });
    changed_[edge] = false;
    const auto along = [&](int c) { return dot(lines[edge].direction, place_at(corners[c], now)); };
    const double s = dot(lines[edge].direction, place);
    auto i = list.begin(), last = list.end();
    if (in_order) {
        i = std::partition_point(i, last,
                                 [&](int p) { return along(corners[begin(p)].next) < s - 2 * small; });
        last = std::find_if(i, last, [&](int p) { return along(begin(p)) > s + 2 * small; });
    }
    int found = -1;
    for (; i != last; ++i) {
        const int a = begin(*i), b = corners[a].next;
        if (a == corner || b == corner || (found >= 0 && found < a)) continue;
        if (s >= along(a) - small && s <= along(b) + small && may_meet(corner, a)) found = a;
    }
    return found;
}

// --- loops of corners --------------------------------------------------------------------------------------

// Whether the two corners may meet: in one loop, or in loops that come from borders that have not met. Loops
// that were split touch at the places where they were, and nowhere else.
bool MovingPolygon::may_meet(int a, int b) {
    return in_one_loop(a, b) || borders_.find(corners[a].border) != borders_.find(corners[b].border);
}

// The one of two corners whose loop has fewer corners; takes as long as walking along that loop.
int MovingPolygon::in_shorter_loop(int a, int b) const {
    for (int i = corners[a].next, k = corners[b].next;; i = corners[i].next, k = corners[k].next) {
        if (i == a) return a;
        if (k == b) return b;
    }
}

void MovingPolygon::name_loop(int corner, int name) {
    for (int i = corner; corners[i].loop != name; i = corners[i].next) corners[i].loop = name;
}

void MovingPolygon::join_loops(int a, int b) {
    const int renamed = in_shorter_loop(a, b);
    name_loop(renamed, corners[renamed == a ? b : a].loop);
    borders_.unite(corners[a].border, corners[b].border);
}

void MovingPolygon::divide_loop(int one, int two) { name_loop(in_shorter_loop(one, two), loops_++); }

} // namespace pantin::wavefront
