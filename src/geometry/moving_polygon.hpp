// SPDX-License-Identifier: MIT
// The polygon whose edges move inwards at unit speed, each along its own perpendicular: circular lists of
// corners (Felkel & Obdržálek 1998), and the part of the straight skeleton that they have traced so far.
#pragma once

#include <limits>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "geometry/clean_loops.hpp"
#include "pantin/straight_skeleton.hpp"

namespace pantin::wavefront {

inline constexpr double never = std::numeric_limits<double>::infinity();
inline constexpr double parallel = 1e-12; // sine of the angle between lines that count as parallel

struct Line { // of a moving edge: normal · p = offset + time
    Point2d normal, direction;
    double offset = 0;
};

// A piece of a moving edge: an edge is split into several.
struct Piece {
    int edge = 0, corner = 0; // corner: that begins it
    // Of the index (split_search.hpp): whatever becomes of the piece, it lies between begin − before · time
    // and end + after · time along the edge's direction, the time counted from that of the index.
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
};

struct MovingPolygon {
    MovingPolygon(const CleanLoops& clean, double tolerance);

    double diagonal = 0, small = 0; // of the polygon; lengths up to `small` count as zero
    double now = 0;                 // the time, which is the distance that the edges have moved
    std::vector<Line> lines;        // of the edges
    std::vector<Piece> pieces;
    std::vector<Corner> corners; // those that are gone included
    int alive = 0;               // corners
    StraightSkeleton skeleton;   // so far

    Point2d place_at(const Corner& corner, double time) const {
        return corner.flat ? corner.origin : corner.origin + (time - corner.time) * corner.velocity;
    }
    bool is_reflex(const Corner& corner) const {
        return !corner.flat && cross(lines[corner.left].direction, lines[corner.right].direction) < -parallel;
    }
    // The point equally far from three moving lines, and the time; false when they have none.
    bool meeting(int i, int j, int k, Point2d& place, double& time) const;

    int add_node(Point2d place, double time);
    // The corner begins the piece now.
    int add_corner(int left, int piece, int previous, int next, int node);
    // A new piece, for what lies beyond the place where the one that the corner begins is split.
    int split_piece(int corner);
    // The corner has gone; its piece, too, or it belongs to another corner.
    void end(int corner);
    // What the corner has traced up to the node where it ends.
    void add_arc(int corner, int node);

    // The corner of the edge's moving piece that holds the place and that the given corner may meet, or −1.
    // Of several, the one that was there first. in_order: the pieces of an edge are, up to rounding, which is
    // true of a polygon that does not cross itself.
    int corner_before(Point2d place, int edge, int corner, bool in_order);
    // Whether the two corners' loops are one, which a split divides.
    bool in_one_loop(int a, int b) const { return corners[a].loop == corners[b].loop; }
    // For loops of two corners that become one; and for one that became two, of the corners one and two.
    void join_loops(int a, int b);
    void divide_loop(int one, int two);

private:
    void add_loop(const std::vector<Point2d>& loop);
    void start(int corner);
    bool may_meet(int a, int b);
    int in_shorter_loop(int a, int b) const;
    void name_loop(int corner, int name);

    DisjointSets borders_;                   // the polygon's loops; those that have met are in one set
    int loops_ = 0;                          // names that loops of corners have had
    std::vector<std::vector<int>> segments_; // per edge: its moving pieces, in order, and some that are gone
    std::vector<bool> changed_;              // … where that is so
};

} // namespace pantin::wavefront
