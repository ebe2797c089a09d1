// SPDX-License-Identifier: MIT
// Constrained Delaunay triangulation of a polygon's inside: the Delaunay triangulation of its corners, into
// which the edges of its loops are brought by flips (Sloan, A fast algorithm for generating constrained
// Delaunay triangulations, 1993).
#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "geometry/triangle_links.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

using Side = TriangleLinks::Side;

struct Corners {
    std::vector<Point2i> points;
    std::vector<std::pair<int, int>> edges;
};

// Equal corners become one, edges without length are left out.
Corners corners_of(const std::vector<std::vector<Point2i>>& loops) {
    Corners result;
    std::map<std::pair<int, int>, int> known;
    for (const std::vector<Point2i>& loop : loops) {
        std::vector<int> numbers;
        for (const Point2i p : loop) {
            const auto [at, added] = known.try_emplace({p.x, p.y}, static_cast<int>(result.points.size()));
            if (added) result.points.push_back(p);
            numbers.push_back(at->second);
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const int a = numbers[i], b = numbers[(i + 1) % numbers.size()];
            if (a != b) result.edges.emplace_back(a, b);
        }
    }
    return result;
}

class EdgeInserter {
public:
    explicit EdgeInserter(TriangleLinks& links) : links_(links) {}

    // Corners on the way divide the edge.
    void insert(int a, int b) {
        while (a != b) {
            if (const Side s = links_.find(a, b); s.triangle >= 0) return fix(s);
            std::deque<std::pair<int, int>> crossed;
            const int end = cross(a, b, crossed);
            if (end < 0) return; // cannot happen between corners of one triangulation
            flip_away(a, end, crossed);
            if (const Side s = links_.find(a, end); s.triangle >= 0) fix(s);
            a = end;
        }
    }

private:
    int turn(int a, int b, int p) const {
        return orientation(links_.points[a], links_.points[b], links_.points[p]);
    }
    bool ahead(int a, int b, int p) const {
        const Point2d from = to_double(links_.points[a]);
        return dot(to_double(links_.points[b]) - from, to_double(links_.points[p]) - from) > 0;
    }
    void fix(Side s) {
        links_.fixed[s.triangle][s.corner] = 1;
        if (const Side o = links_.opposite(s); o.triangle >= 0) links_.fixed[o.triangle][o.corner] = 1;
    }

    // The edges that a → b crosses up to the first corner on it, which is returned.
    int cross(int a, int b, std::deque<std::pair<int, int>>& crossed) const {
        Side s;
        for (const Side& side : links_.around(a)) {
            const int p = links_.from(side), q = links_.to(side);
            const int turn_p = turn(a, b, p), turn_q = turn(a, b, q);
            if (turn_p == 0 && ahead(a, b, p)) return p;
            if (turn_q == 0 && ahead(a, b, q)) return q;
            if (turn_p < 0 && turn_q > 0) s = side;
        }
        while (s.triangle >= 0) {
            crossed.emplace_back(links_.from(s), links_.to(s));
            const Side o = links_.opposite(s);
            if (o.triangle < 0) return -1;
            const int apex = links_.corners[o.triangle][o.corner];
            const int side = turn(a, b, apex);
            if (side == 0) return apex;
            // `o` runs from the left corner to the right one; the way goes on between the apex and one of
            // them.
            s = side > 0 ? Side{o.triangle, (o.corner + 1) % 3} : Side{o.triangle, (o.corner + 2) % 3};
            if (turn(a, b, links_.from(s)) > 0)
                s = side > 0 ? Side{o.triangle, (o.corner + 2) % 3} : Side{o.triangle, (o.corner + 1) % 3};
        }
        return -1;
    }

    void flip_away(int a, int b, std::deque<std::pair<int, int>>& crossed) {
        while (!crossed.empty()) {
            const auto [p, q] = crossed.front();
            crossed.pop_front();
            const Side s = links_.find(p, q);
            if (!links_.can_flip(s)) {
                crossed.emplace_back(p, q);
                continue;
            }
            links_.flip(s);
            const Side made{s.triangle, (s.corner + 1) % 3};
            const int u = links_.from(made), v = links_.to(made);
            if (u != a && u != b && v != a && v != b && turn(a, b, u) * turn(a, b, v) < 0)
                crossed.emplace_back(u, v);
        }
    }

    TriangleLinks& links_;
};

// Inside is where an odd number of fixed edges lies between a triangle and the hull.
std::vector<char> inside_of(const TriangleLinks& links) {
    const int count = static_cast<int>(links.corners.size());
    std::vector<char> inside(links.corners.size(), 2);
    std::vector<int> open;
    for (int t = 0; t < count; ++t)
        for (int i = 0; i < 3; ++i)
            if (links.neighbours[t][i] < 0 && inside[t] == 2) {
                inside[t] = links.fixed[t][i];
                open.push_back(t);
            }
    while (!open.empty()) {
        const int t = open.back();
        open.pop_back();
        for (int i = 0; i < 3; ++i) {
            const int n = links.neighbours[t][i];
            if (n < 0 || inside[n] != 2) continue;
            inside[n] = static_cast<char>(inside[t] ^ links.fixed[t][i]);
            open.push_back(n);
        }
    }
    return inside;
}

Triangulation inner_part(const TriangleLinks& links) {
    const std::vector<char> inside = inside_of(links);
    Triangulation result;
    result.points = links.points;
    std::vector<int> number(inside.size(), -1);
    int count = 0;
    for (std::size_t t = 0; t < inside.size(); ++t)
        if (inside[t]) number[t] = count++;
    for (std::size_t t = 0; t < inside.size(); ++t) {
        if (!inside[t]) continue;
        result.triangles.push_back(links.corners[t]);
        std::array<int, 3> around{};
        for (int i = 0; i < 3; ++i) {
            const int n = links.neighbours[t][i];
            around[i] = n < 0 || links.fixed[t][i] ? -1 : number[n];
        }
        result.neighbours.push_back(around);
    }
    return result;
}

} // namespace

Triangulation constrained_delaunay(const std::vector<std::vector<Point2i>>& loops) {
    const Corners corners = corners_of(loops);
    Delaunay free = delaunay(corners.points);
    TriangleLinks links(corners.points, std::move(free.triangles), std::move(free.neighbours));
    EdgeInserter inserter(links);
    if (!links.corners.empty())
        for (const auto& [a, b] : corners.edges) inserter.insert(a, b);
    links.legalise_all();
    Triangulation result = inner_part(links);
    if (result.triangles.empty()) throw Error(ErrorKind::input, "triangulation: the polygon has no inside");
    return result;
}

} // namespace pantin
