// SPDX-License-Identifier: MIT
// This work is based on: J. Ruppert, A Delaunay refinement algorithm for quality 2-dimensional mesh
// generation, 1995. Here a point of the border is added when a circumcentre is hidden by an edge of the
// border or when a new triangle's corner encroaches upon one; edges at the shortest length are left as they
// are, so it ends at sharp corners, too.
#include <algorithm>
#include <cmath>
#include <deque>

#include "geometry/triangle_links.hpp"
#include "image/nearest_pixel.hpp"

namespace pantin {
namespace {

using Side = TriangleLinks::Side;

class Refinement {
public:
    Refinement(TriangleLinks& links, const TriangleQuality& quality) : links_(links), quality_(quality) {}

    void run() {
        for (int t = 0; t < count(); ++t) look_at(t);
        while (!bad_.empty() && std::ssize(links_.points) < quality_.most_points) {
            const Bad bad = bad_.front();
            bad_.pop_front();
            if (links_.corners[bad.triangle] == bad.corners) improve(bad.triangle);
        }
    }

private:
    struct Bad {
        int triangle;
        std::array<int, 3> corners; // it may be another triangle by now
    };

    int count() const { return static_cast<int>(links_.corners.size()); }
    Point2d at(int point) const { return to_double(links_.points[point]); }
    double length_of(Side s) const { return distance(at(links_.from(s)), at(links_.to(s))); }
    bool on_border(Side s) const { return links_.neighbours[s.triangle][s.corner] < 0; }
    bool can_split(Side s) const { return length_of(s) >= 2 * quality_.shortest_edge; }

    bool encroached(Side s) const {
        const Point2d apex = at(links_.corners[s.triangle][s.corner]);
        return dot(at(links_.from(s)) - apex, at(links_.to(s)) - apex) < 0;
    }
    bool must_split(Side s) const {
        return on_border(s) && can_split(s) &&
               (encroached(s) || (quality_.longest_edge > 0 && length_of(s) > quality_.longest_edge));
    }

    struct Shape {
        double shortest, longest, circumradius;
        Point2d centre;
    };
    Shape shape_of(int t) const {
        const Point2d a = at(links_.corners[t][0]), b = at(links_.corners[t][1]) - a,
                      c = at(links_.corners[t][2]) - a;
        const double twice = 2 * cross(b, c), bb = dot(b, b), cc = dot(c, c);
        const Point2d centre{(c.y * bb - b.y * cc) / twice, (b.x * cc - c.x * bb) / twice};
        const double sides[3] = {length(b), length(c), length(c - b)};
        return {*std::min_element(sides, sides + 3), *std::max_element(sides, sides + 3), length(centre),
                a + centre};
    }
    bool is_bad(const Shape& s) const {
        if (s.shortest < 1) return false;
        if (quality_.longest_edge > 0 && s.longest > quality_.longest_edge) return true;
        return s.circumradius > quality_.ratio * s.shortest && s.circumradius > 2 * quality_.shortest_edge;
    }

    void look_at(int t) {
        bool bad = is_bad(shape_of(t));
        for (int i = 0; i < 3; ++i) bad = bad || must_split({t, i});
        if (bad) bad_.push_back({t, links_.corners[t]});
    }

    void improve(int t) {
        for (int i = 0; i < 3; ++i)
            if (must_split({t, i})) return halve({t, i});
        const Shape shape = shape_of(t);
        if (!is_bad(shape)) return;
        const Point2i centre = pixel_at_or_after(shape.centre);
        const TriangleLinks::Place place = links_.locate(centre, t);
        if (place.behind >= 0) {
            const Side border{place.triangle, place.behind};
            if (can_split(border)) halve(border);
            return;
        }
        if (place.triangle < 0) return;
        for (const int corner :
             links_.corners[place.triangle]) // close to a corner it would only make shorter edges
            if (distance(at(corner), to_double(centre)) < quality_.shortest_edge) return;
        add(centre, place);
    }

    void halve(Side s) {
        const Point2i a = links_.points[links_.from(s)], b = links_.points[links_.to(s)];
        add({(a.x + b.x) / 2, (a.y + b.y) / 2}, {s.triangle, s.corner, -1});
    }

    void add(Point2i p, const TriangleLinks::Place& place) {
        if (!links_.insert(p, place)) return;
        for (const Side& s : links_.around(static_cast<int>(links_.points.size()) - 1)) look_at(s.triangle);
    }

    TriangleLinks& links_;
    const TriangleQuality& quality_;
    std::deque<Bad> bad_;
};

std::vector<char> border_points(const TriangleLinks& links) {
    std::vector<char> on(links.points.size());
    for (int t = 0; t < std::ssize(links.corners); ++t)
        for (int i = 0; i < 3; ++i)
            if (links.neighbours[t][i] < 0) on[links.from({t, i})] = on[links.to({t, i})] = 1;
    return on;
}

// Edges inside between two points of the border get a point in their middle, without flips, so that none
// comes back.
void split_chords(TriangleLinks& links) {
    const std::vector<char> border = border_points(links);
    const auto on_border = [&](int p) { return p < std::ssize(border) && border[p]; };
    for (auto& sides : links.fixed) sides = {1, 1, 1};
    for (int t = 0; t < std::ssize(links.corners); ++t)
        for (int i = 0; i < 3; ++i) {
            const Side s{t, i};
            if (links.neighbours[t][i] < 0 || !on_border(links.from(s)) || !on_border(links.to(s))) continue;
            const Point2i a = links.points[links.from(s)], b = links.points[links.to(s)];
            links.insert({(a.x + b.x) / 2, (a.y + b.y) / 2}, {t, i, -1});
        }
}

} // namespace

Triangulation refined(const Triangulation& triangulation, const TriangleQuality& quality) {
    TriangleLinks links(triangulation.points, triangulation.triangles, triangulation.neighbours);
    for (std::size_t t = 0; t < links.corners.size(); ++t)
        for (int i = 0; i < 3; ++i) links.fixed[t][i] = links.neighbours[t][i] < 0;
    Refinement(links, quality).run();
    if (quality.free_chords) split_chords(links);
    return {std::move(links.points), std::move(links.corners), std::move(links.neighbours)};
}

} // namespace pantin
