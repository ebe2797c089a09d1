// SPDX-License-Identifier: MIT
// In come triangles with their neighbours; flips and splits keep the links and, as far as fixed edges let
// them, the Delaunay property (C. L. Lawson: Software for C¹ surface interpolation, 1977).
#include "geometry/triangle_links.hpp"

#include <algorithm>

namespace pantin {

TriangleLinks::TriangleLinks(std::vector<Point2i> p, std::vector<std::array<int, 3>> t,
                             std::vector<std::array<int, 3>> n)
    : points(std::move(p)), corners(std::move(t)), neighbours(std::move(n)), fixed(corners.size()),
      triangle_of_(points.size(), -1) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (const int corner : corners[i]) triangle_of_[corner] = static_cast<int>(i);
}

TriangleLinks::Side TriangleLinks::opposite(Side s) const {
    const int other = neighbours[s.triangle][s.corner];
    if (other < 0) return {};
    for (int i = 0; i < 3; ++i)
        if (corners[other][(i + 1) % 3] == to(s) && corners[other][(i + 2) % 3] == from(s)) return {other, i};
    return {};
}

std::vector<TriangleLinks::Side> TriangleLinks::around(int point) const {
    const auto side_at = [&](int t) {
        for (int i = 0; i < 3; ++i)
            if (corners[t][i] == point) return Side{t, i};
        return Side{};
    };
    const int first = triangle_of_[point];
    if (first < 0) return {};
    int begin = first; // as far clockwise as there are triangles
    for (;;) {
        const Side s = side_at(begin);
        const int before = neighbours[s.triangle][(s.corner + 2) % 3];
        if (before < 0 || before == first) break;
        begin = before;
    }
    std::vector<Side> fan;
    for (int t = begin; t >= 0;) {
        fan.push_back(side_at(t));
        t = neighbours[t][(fan.back().corner + 1) % 3];
        if (t == begin) break;
    }
    return fan;
}

TriangleLinks::Side TriangleLinks::find(int a, int b) const {
    for (const Side& s : around(a)) {
        if (from(s) == b) return {s.triangle, (s.corner + 2) % 3};
        if (to(s) == b) return {s.triangle, (s.corner + 1) % 3};
    }
    return {};
}

bool TriangleLinks::can_flip(Side s) const {
    const Side other = opposite(s);
    if (other.triangle < 0) return false;
    const int c = corners[s.triangle][s.corner], d = corners[other.triangle][other.corner];
    return positive(c, from(s), d) && positive(c, d, to(s));
}

void TriangleLinks::link(int triangle, int corner, int neighbour) {
    neighbours[triangle][corner] = neighbour;
    if (neighbour < 0) return;
    const Side s{triangle, corner};
    for (int i = 0; i < 3; ++i)
        if (corners[neighbour][(i + 1) % 3] == to(s) && corners[neighbour][(i + 2) % 3] == from(s))
            neighbours[neighbour][i] = triangle;
}

void TriangleLinks::flip(Side s) {
    const Side o = opposite(s);
    const int t = s.triangle, u = o.triangle;
    const int a = from(s), b = to(s), c = corners[t][s.corner], d = corners[u][o.corner];
    // Around the quadrilateral c, a, d, b.
    const int bc = neighbours[t][(s.corner + 1) % 3], ca = neighbours[t][(s.corner + 2) % 3];
    const int ad = neighbours[u][(o.corner + 1) % 3], db = neighbours[u][(o.corner + 2) % 3];
    const char fbc = fixed[t][(s.corner + 1) % 3], fca = fixed[t][(s.corner + 2) % 3];
    const char fad = fixed[u][(o.corner + 1) % 3], fdb = fixed[u][(o.corner + 2) % 3];
    const int i = s.corner, j = o.corner;
    corners[t][i] = c, corners[t][(i + 1) % 3] = a, corners[t][(i + 2) % 3] = d;
    corners[u][j] = d, corners[u][(j + 1) % 3] = b, corners[u][(j + 2) % 3] = c;
    fixed[t][i] = fad, fixed[t][(i + 1) % 3] = 0, fixed[t][(i + 2) % 3] = fca;
    fixed[u][j] = fbc, fixed[u][(j + 1) % 3] = 0, fixed[u][(j + 2) % 3] = fdb;
    neighbours[t][(i + 1) % 3] = u;
    neighbours[u][(j + 1) % 3] = t;
    link(t, i, ad), link(t, (i + 2) % 3, ca);
    link(u, j, bc), link(u, (j + 2) % 3, db);
    triangle_of_[a] = triangle_of_[c] = t;
    triangle_of_[b] = triangle_of_[d] = u;
}

void TriangleLinks::legalise(std::vector<Side> pending) {
    while (!pending.empty()) {
        const Side s = pending.back();
        pending.pop_back();
        if (fixed[s.triangle][s.corner]) continue;
        const Side o = opposite(s);
        if (o.triangle < 0) continue;
        const auto& t = corners[s.triangle];
        if (in_circle(points[t[0]], points[t[1]], points[t[2]], points[corners[o.triangle][o.corner]]) <= 0)
            continue;
        if (!can_flip(s)) continue; // cocircular but for a rounding of the border
        flip(s);
        for (int i = 0; i < 3; ++i) {
            if (i != (s.corner + 1) % 3) pending.push_back({s.triangle, i});
            if (i != (o.corner + 1) % 3) pending.push_back({o.triangle, i});
        }
    }
}

void TriangleLinks::legalise_all() {
    std::vector<Side> all;
    for (int t = static_cast<int>(corners.size()) - 1; t >= 0; --t)
        for (int i = 2; i >= 0; --i) all.push_back({t, i});
    legalise(std::move(all));
}

TriangleLinks::Place TriangleLinks::locate(Point2i p, int start) const {
    int t = start;
    for (std::size_t step = 0; step < 3 * corners.size() + 3; ++step) {
        int next = -1, on = -1, out = -1;
        for (int i = 0; i < 3 && next < 0; ++i) {
            // Another side first at every step, so that the walk never turns in a circle for long.
            const int k = static_cast<int>((static_cast<std::size_t>(i) + step) % 3);
            const int turn = orientation(points[from({t, k})], points[to({t, k})], p);
            if (turn == 0) on = k;
            if (turn >= 0) continue;
            out = k;
            if (!fixed[t][k]) next = neighbours[t][k];
        }
        if (out >= 0 && next < 0) return {t, -1, out};
        if (out < 0) return {t, on, -1};
        t = next;
    }
    return {};
}

bool TriangleLinks::insert(Point2i p, const Place& place) {
    const int index = static_cast<int>(points.size());
    points.push_back(p);
    triangle_of_.push_back(place.triangle);
    std::vector<Side> changed;
    const bool done = place.on < 0 ? split_inside(place.triangle, index, changed)
                                   : split_side({place.triangle, place.on}, index, changed);
    if (!done) {
        points.pop_back();
        triangle_of_.pop_back();
        return false;
    }
    legalise(std::move(changed));
    return true;
}

bool TriangleLinks::split_inside(int t, int p, std::vector<Side>& changed) {
    const auto [a, b, c] = corners[t];
    if (!positive(a, b, p) || !positive(b, c, p) || !positive(c, a, p)) return false;
    const auto [na, nb, nc] = neighbours[t];
    const auto [fa, fb, fc] = fixed[t];
    const int u = static_cast<int>(corners.size()), v = u + 1;
    corners[t] = {a, b, p};
    corners.push_back({b, c, p});
    corners.push_back({c, a, p});
    neighbours[t] = {u, v, -1};
    neighbours.push_back({v, t, -1});
    neighbours.push_back({t, u, -1});
    fixed[t] = {0, 0, fc};
    fixed.push_back({0, 0, fa});
    fixed.push_back({0, 0, fb});
    link(t, 2, nc), link(u, 2, na), link(v, 2, nb);
    triangle_of_[c] = u;
    changed = {{t, 2}, {u, 2}, {v, 2}};
    return true;
}

// Each of the two triangles is halved at p: (c, a, b) becomes (c, a, p) and (c, p, b).
bool TriangleLinks::split_side(Side s, int p, std::vector<Side>& changed) {
    const Side o = opposite(s);
    const int a = from(s), b = to(s), c = corners[s.triangle][s.corner];
    if (!positive(c, a, p) || !positive(c, p, b)) return false;
    const int d = o.triangle >= 0 ? corners[o.triangle][o.corner] : -1;
    if (d >= 0 && (!positive(d, b, p) || !positive(d, p, a))) return false;
    const auto halve = [&](Side side, int first, int second) { // returns the new triangle, which has `second`
        const int t = side.triangle, i = side.corner, apex = corners[t][i],
                  u = static_cast<int>(corners.size());
        const int outer = neighbours[t][(i + 1) % 3];
        const char f = fixed[t][i], f_outer = fixed[t][(i + 1) % 3], f_inner = fixed[t][(i + 2) % 3];
        const int inner = neighbours[t][(i + 2) % 3];
        corners[t] = {apex, first, p};
        corners.push_back({apex, p, second});
        neighbours[t] = {-1, u, inner};
        neighbours.push_back({-1, -1, t});
        fixed[t] = {f, 0, f_inner};
        fixed.push_back({f, f_outer, 0});
        link(u, 1, outer);
        triangle_of_[second] = u;
        triangle_of_[first] = triangle_of_[apex] = t;
        changed.insert(changed.end(), {{t, 2}, {u, 1}});
        return u;
    };
    const int t = s.triangle;
    const int u = halve(s, a, b);
    if (d < 0) return true;
    const int w = halve(o, b, a);
    neighbours[t][0] = w, neighbours[w][0] = t;
    neighbours[u][0] = o.triangle, neighbours[o.triangle][0] = u;
    return true;
}

} // namespace pantin
