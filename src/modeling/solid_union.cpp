// SPDX-License-Identifier: MIT
// Two closed surfaces in, the surface of their union out (Edelsbrunner & Mücke 1990; Smith & Dodgson 2007).
#include "modeling/solid_union.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/wide_integer.hpp"
#include "modeling/face_loops.hpp"

namespace pantin {
namespace {

// --- predicates --------------------------------------------------------------------------------------------
// Differences are below 2^38 + 1, products of three below 2^117.

struct Wide3 {
    WideInteger x, y, z;
};

GridPoint operator-(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Wide3 cross(GridPoint a, GridPoint b) {
    const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
        return WideInteger(p) * WideInteger(q) - WideInteger(r) * WideInteger(s);
    };
    return {minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x)};
}
WideInteger dot(const Wide3& a, GridPoint b) {
    return a.x * WideInteger(b.x) + a.y * WideInteger(b.y) + a.z * WideInteger(b.z);
}
int sign(WideInteger value) { return (value > WideInteger(0)) - (value < WideInteger(0)); }
// Of the scalar product with (ε, ε², ε³).
int sign_by_shift(const Wide3& v) {
    for (const WideInteger& part : {v.x, v.y, v.z})
        if (const int s = sign(part); s != 0) return s;
    return 0;
}

struct Corners {
    GridPoint a, b, c;
};

// On which side of the triangle the point lies (1: outside), and how far, in a unit of the triangle. shift:
// 1 when the point's surface is the one that counts as moved, −1 when the triangle's is.
struct Side {
    int sign;
    double far;
};
Side side_of(const Corners& t, GridPoint p, int shift) {
    const Wide3 normal = cross(t.b - t.a, t.c - t.a);
    const WideInteger value = dot(normal, p - t.a);
    const int s = sign(value);
    return {s != 0 ? s : shift * sign_by_shift(normal), static_cast<double>(value)};
}
// How the line p q runs around the line a b.
int turn_around(GridPoint p, GridPoint q, GridPoint a, GridPoint b, int shift) {
    const Wide3 m = cross(b - a, q - p);
    const int s = sign(dot(m, a - p));
    return s != 0 ? s : shift * sign_by_shift(m);
}

struct Pierced {
    int sign;  // 1: the way from p to q leads in
    double at; // share of the way
};
std::optional<Pierced> pierce(GridPoint p, GridPoint q, const Corners& t, int shift) {
    const Side from = side_of(t, p, shift), to = side_of(t, q, shift);
    if (from.sign == to.sign) return std::nullopt;
    const int u = turn_around(p, q, t.a, t.b, -shift);
    if (u != turn_around(p, q, t.b, t.c, -shift) || u != turn_around(p, q, t.c, t.a, -shift))
        return std::nullopt;
    const double all = from.far - to.far;
    return Pierced{from.sign, all != 0 ? std::clamp(from.far / all, 0.0, 1.0) : 0.5};
}

GridPoint between(GridPoint p, GridPoint q, double t) {
    const auto place = [t](std::int64_t a, std::int64_t b) {
        return a + static_cast<std::int64_t>(std::floor(t * static_cast<double>(b - a) + 0.5));
    };
    return {place(p.x, q.x), place(p.y, q.y), place(p.z, q.z)};
}

// --- surfaces ----------------------------------------------------------------------------------------------

GridBox box_of(const GridPoint& p) {
    GridBox box;
    box.include(std::array{p.x, p.y, p.z});
    return box;
}
GridBox box_of(const Corners& t) {
    GridBox box = box_of(t.a);
    box.include(box_of(t.b)), box.include(box_of(t.c));
    return box;
}

GridBox box_of(const GridSurface& surface, std::size_t t) {
    const auto& [a, b, c] = surface.triangles[t];
    return box_of(Corners{surface.points[a], surface.points[b], surface.points[c]});
}
GridBox all_of(const std::vector<GridBox>& boxes) {
    GridBox all;
    for (const GridBox& box : boxes) all.include(box);
    return all;
}

// Triangles of a surface that may meet the other one, with their edges.
struct Operand {
    struct Edge {
        int low, high;                    // points
        std::array<int, 2> faces{-1, -1}; // of triangles: along it from low to high, and back
    };
    std::vector<GridPoint> points;
    std::vector<int> number; // of each point, in the union
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> whole; // of each triangle, in the surface
    std::vector<Edge> edges;
    std::vector<std::array<int, 3>> edges_of; // of each triangle: from corner k to the next
    std::vector<int> winding;                 // of the other surface around each point

    Operand(const GridSurface& surface, const std::vector<int>& chosen, int first_number) : whole(chosen) {
        std::vector<int> used;
        for (const int t : chosen)
            used.insert(used.end(), surface.triangles[t].begin(), surface.triangles[t].end());
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        for (const int p : used) points.push_back(surface.points[p]), number.push_back(first_number + p);
        for (const int t : chosen) {
            std::array<int, 3> corners{};
            for (int k = 0; k < 3; ++k)
                corners[k] = static_cast<int>(
                    std::lower_bound(used.begin(), used.end(), surface.triangles[t][k]) - used.begin());
            triangles.push_back(corners);
        }
        find_edges();
    }
    Corners corners(int t) const {
        const auto& [a, b, c] = triangles[t];
        return {points[a], points[b], points[c]};
    }
    bool runs_up(int t, int k) const { return triangles[t][k] < triangles[t][(k + 1) % 3]; }

private:
    void find_edges() {
        std::vector<std::tuple<int, int, int, int>> sides; // low, high, triangle, corner
        for (int t = 0; t < std::ssize(triangles); ++t)
            for (int k = 0; k < 3; ++k) {
                const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
                sides.emplace_back(std::min(a, b), std::max(a, b), t, k);
            }
        std::sort(sides.begin(), sides.end());
        edges_of.resize(triangles.size());
        for (const auto& [low, high, t, k] : sides) {
            if (edges.empty() || edges.back().low != low || edges.back().high != high)
                edges.push_back({low, high});
            edges.back().faces[runs_up(t, k) ? 0 : 1] = t;
            edges_of[t][k] = static_cast<int>(edges.size()) - 1;
        }
    }
};

// An edge of one surface crosses a triangle of the other one.
struct Crossing {
    int edge, triangle, sign;
    double at;
    int vertex; // of the union
};
// Where two triangles cut each other.
struct CutEnd {
    int first, second; // triangles
    bool begins;       // the cut runs from here, seen in the first one
    int vertex;
    auto operator<=>(const CutEnd&) const = default;
};
using Way = std::pair<int, int>; // from a vertex of the union to another one

constexpr int unknown = INT32_MIN;

class Uniter {
public:
    Uniter(GridSurface& all, const GridSurface& part) : all_(all), part_(part) {}

    bool unite() {
        const std::size_t first = all_.points.size();
        all_.points.insert(all_.points.end(), part_.points.begin(), part_.points.end());
        if (try_unite(static_cast<int>(first))) return true;
        all_.points.resize(first);
        return false;
    }

private:
    struct Result {
        std::vector<std::array<int, 3>> triangles;
        std::vector<int> parts;
    };

    bool try_unite(int first) {
        std::vector<int> every(part_.triangles.size());
        std::iota(every.begin(), every.end(), 0);
        Operand near(all_, near_triangles(), 0), added(part_, every, first);
        find_crossings(near, added);
        if (!wind(near, part_, near_crossings_, -1) || !wind(added, all_, added_crossings_, 1)) return false;
        if (!find_cuts(near, added)) return false;
        Result kept;
        if (!keep(near, all_, near_crossings_, near_cuts_, kept) ||
            !keep(added, part_, added_crossings_, added_cuts_, kept))
            return false;
        write(near, kept);
        return true;
    }

    std::vector<int> near_triangles() const {
        const GridBox box = all_of(part_.boxes);
        std::vector<int> near;
        for (int t = 0; t < std::ssize(all_.triangles); ++t)
            if (box.meets(all_.boxes[t])) near.push_back(t);
        return near;
    }

    void find_crossings(const Operand& near, const Operand& added) {
        std::vector<GridBox> boxes;
        for (const int t : near.whole) boxes.push_back(all_.boxes[t]);
        const BoxTree tree(std::move(boxes));
        for (int b = 0; b < std::ssize(added.triangles); ++b)
            tree.each(part_.boxes[b], [&](int a) {
                cross_edges(near, a, added, b, -1, near_crossings_);
                cross_edges(added, b, near, a, 1, added_crossings_);
            });
        for (auto* crossings : {&near_crossings_, &added_crossings_})
            std::sort(crossings->begin(), crossings->end(), [](const Crossing& a, const Crossing& b) {
                return std::tie(a.edge, a.at, a.triangle) < std::tie(b.edge, b.at, b.triangle);
            });
    }
    void cross_edges(const Operand& of, int t, const Operand& other, int at, int shift,
                     std::vector<Crossing>& crossings) {
        for (int k = 0; k < 3; ++k) {
            const int e = of.edges_of[t][k];
            const Operand::Edge& edge = of.edges[e];
            if ((edge.faces[0] >= 0 ? edge.faces[0] : edge.faces[1]) != t) continue; // once for both
            const GridPoint p = of.points[edge.low], q = of.points[edge.high];
            if (const auto found = pierce(p, q, other.corners(at), shift)) {
                crossings.push_back({e, at, found->sign, found->at, static_cast<int>(all_.points.size())});
                all_.points.push_back(between(p, q, found->at));
            }
        }
    }

    // How often the other surface goes around each point: counted along a ray for one of them, and on along
    // the edges. Whether all are outside (0) or inside (1).
    bool wind(Operand& of, const GridSurface& other, const std::vector<Crossing>& crossings,
              int shift) const {
        std::vector<int> change(of.edges.size(), 0);
        for (const Crossing& c : crossings) change[c.edge] += c.sign;
        std::vector<std::vector<std::pair<int, int>>> ways(of.points.size()); // point, change
        for (std::size_t e = 0; e < of.edges.size(); ++e) {
            ways[of.edges[e].low].emplace_back(of.edges[e].high, change[e]);
            ways[of.edges[e].high].emplace_back(of.edges[e].low, -change[e]);
        }
        const GridBox box = all_of(other.boxes);
        of.winding.assign(of.points.size(), unknown);
        for (std::size_t start = 0; start < of.points.size(); ++start) {
            if (of.winding[start] != unknown) continue;
            const GridPoint p = of.points[start];
            of.winding[start] = box.meets(box_of(p)) ? winding_by_ray(p, other, box, shift) : 0;
            std::vector<int> open{static_cast<int>(start)};
            while (!open.empty()) {
                const int at = open.back();
                open.pop_back();
                for (const auto& [next, by] : ways[at])
                    if (of.winding[next] == unknown) {
                        of.winding[next] = of.winding[at] + by;
                        open.push_back(next);
                    }
            }
        }
        return std::all_of(of.winding.begin(), of.winding.end(), [](int w) { return w == 0 || w == 1; });
    }
    static int winding_by_ray(GridPoint p, const GridSurface& other, const GridBox& box, int shift) {
        const GridPoint far{box.high[0] + 1, p.y, p.z};
        const GridBox way = [&] {
            GridBox both = box_of(p);
            both.include(box_of(far));
            return both;
        }();
        int winding = 0;
        for (std::size_t i = 0; i < other.triangles.size(); ++i) {
            if (!way.meets(other.boxes[i])) continue;
            const auto& [a, b, c] = other.triangles[i];
            const Corners t{other.points[a], other.points[b], other.points[c]};
            if (const auto found = pierce(p, far, t, shift)) winding -= found->sign;
        }
        return winding;
    }

    // In each of two triangles that cut each other the cut has what is kept on its left.
    bool find_cuts(const Operand& near, const Operand& added) {
        std::vector<CutEnd> ends;
        const auto collect = [&](const Operand& of, const std::vector<Crossing>& crossings, bool is_near) {
            for (const Crossing& c : crossings)
                for (int way = 0; way < 2; ++way) {
                    const int t = of.edges[c.edge].faces[way];
                    if (t < 0) return false;
                    const bool leads_in = (way == 0 ? c.sign : -c.sign) > 0;
                    ends.push_back(is_near ? CutEnd{t, c.triangle, leads_in, c.vertex}
                                           : CutEnd{c.triangle, t, !leads_in, c.vertex});
                }
            return true;
        };
        if (!collect(near, near_crossings_, true) || !collect(added, added_crossings_, false)) return false;
        std::sort(ends.begin(), ends.end());
        if (ends.size() % 2 != 0) return false;
        for (std::size_t i = 0; i < ends.size(); i += 2) {
            const CutEnd &to = ends[i], &from = ends[i + 1];
            if (to.first != from.first || to.second != from.second || to.begins || !from.begins) return false;
            near_cuts_.push_back({from.first, {from.vertex, to.vertex}});
            added_cuts_.push_back({from.second, {to.vertex, from.vertex}});
        }
        std::sort(near_cuts_.begin(), near_cuts_.end());
        std::sort(added_cuts_.begin(), added_cuts_.end());
        return true;
    }

    // What an edge has outside of the other surface, from its low to its high end.
    static bool outer_ways(const Operand& of, int e, const Crossing* first, const Crossing* last,
                           std::vector<Way>& ways) {
        std::vector<int> begins, ends;
        if (of.winding[of.edges[e].low] == 0) begins.push_back(of.number[of.edges[e].low]);
        for (const Crossing* c = first; c != last; ++c) (c->sign > 0 ? ends : begins).push_back(c->vertex);
        if (of.winding[of.edges[e].high] == 0) ends.push_back(of.number[of.edges[e].high]);
        if (begins.size() != ends.size()) return false;
        for (std::size_t i = 0; i < begins.size(); ++i) ways.emplace_back(begins[i], ends[i]);
        return true;
    }

    using Cut = std::pair<int, Way>; // triangle
    bool keep(const Operand& of, const GridSurface& surface, const std::vector<Crossing>& crossings,
              const std::vector<Cut>& cuts, Result& kept) const {
        const Crossing* const end = crossings.data() + crossings.size();
        const auto crossings_of = [&](int e) {
            const Crossing* first = std::lower_bound(crossings.data(), end, e,
                                                     [](const Crossing& c, int key) { return c.edge < key; });
            const Crossing* last = first;
            while (last != end && last->edge == e) ++last;
            return std::pair(first, last);
        };
        auto cut = cuts.begin();
        for (int t = 0; t < std::ssize(of.triangles); ++t) {
            const int part = surface.parts[of.whole[t]];
            std::vector<Way> ways;
            for (; cut != cuts.end() && cut->first == t; ++cut) ways.push_back(cut->second);
            const auto& corners = of.triangles[t];
            if (ways.empty()) {
                if (of.winding[corners[0]] != 0) continue;
                kept.triangles.push_back(
                    {of.number[corners[0]], of.number[corners[1]], of.number[corners[2]]});
                kept.parts.push_back(part);
                continue;
            }
            std::vector<std::pair<int, unsigned>> on_edges; // vertices
            for (int k = 0; k < 3; ++k) {
                on_edges.emplace_back(of.number[corners[k]], 1u << k | 1u << (k + 2) % 3);
                const auto [first, last] = crossings_of(of.edges_of[t][k]);
                for (const Crossing* c = first; c != last; ++c) on_edges.emplace_back(c->vertex, 1u << k);
                std::vector<Way> outer;
                if (!outer_ways(of, of.edges_of[t][k], first, last, outer)) return false;
                for (const auto& [from, to] : outer)
                    ways.push_back(of.runs_up(t, k) ? Way{from, to} : Way{to, from});
            }
            if (!fill(of.corners(t), ways, on_edges, part, kept)) return false;
        }
        return true;
    }

    bool fill(const Corners& t, std::vector<Way>& ways, const std::vector<std::pair<int, unsigned>>& on_edges,
              int part, Result& kept) const {
        std::sort(ways.begin(), ways.end());
        std::vector<char> used(ways.size(), 0);
        std::vector<std::vector<LoopCorner>> loops;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            if (used[i]) continue;
            std::vector<LoopCorner> loop;
            for (std::size_t at = i; !used[at];) {
                used[at] = 1;
                loop.push_back(projected(t, ways[at].first, on_edges));
                const auto next = std::lower_bound(ways.begin(), ways.end(), Way{ways[at].second, INT32_MIN});
                if (next == ways.end() || next->first != ways[at].second) return false;
                at = static_cast<std::size_t>(next - ways.begin());
                if (used[at] && at != i) return false;
            }
            if (loop.size() < 3) return false;
            loops.push_back(std::move(loop));
        }
        for (const auto& triangle : fill_loops(std::move(loops))) {
            kept.triangles.push_back(triangle);
            kept.parts.push_back(part);
        }
        return true;
    }

    // Along the axis to which the triangle is nearest to being perpendicular, so that it is seen from
    // outside.
    LoopCorner projected(const Corners& t, int vertex,
                         const std::vector<std::pair<int, unsigned>>& on_edges) const {
        const Wide3 normal = cross(t.b - t.a, t.c - t.a);
        const double n[3] = {static_cast<double>(normal.x), static_cast<double>(normal.y),
                             static_cast<double>(normal.z)};
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
        const GridPoint& p = all_.points[vertex];
        const std::int64_t places[3] = {p.x, p.y, p.z};
        LoopCorner corner{places[(axis + 1) % 3], places[(axis + 2) % 3], vertex, 0};
        if (n[axis] < 0) std::swap(corner.x, corner.y);
        for (const auto& [other, edges] : on_edges)
            if (other == vertex) corner.edges = edges;
        return corner;
    }

    // What is kept takes the places of what was near; later ones fill those that are left.
    void write(const Operand& near, const Result& kept) {
        std::size_t next = 0;
        const auto put = [&](std::size_t t) {
            all_.triangles[t] = kept.triangles[next];
            all_.parts[t] = kept.parts[next];
            all_.boxes[t] = box_of(all_, t);
            ++next;
        };
        std::size_t free = 0;
        while (free < near.whole.size() && next < kept.triangles.size()) put(near.whole[free++]);
        while (next < kept.triangles.size()) {
            all_.triangles.emplace_back(), all_.parts.emplace_back(), all_.boxes.emplace_back();
            put(all_.triangles.size() - 1);
        }
        for (std::size_t i = near.whole.size(); i > free; --i) { // the last first
            const int t = near.whole[i - 1];
            all_.triangles[t] = all_.triangles.back(), all_.triangles.pop_back();
            all_.parts[t] = all_.parts.back(), all_.parts.pop_back();
            all_.boxes[t] = all_.boxes.back(), all_.boxes.pop_back();
        }
    }

    GridSurface& all_;
    const GridSurface& part_; // whose points come after those of all_, and then the crossings
    std::vector<Crossing> near_crossings_, added_crossings_;
    std::vector<Cut> near_cuts_, added_cuts_;
};

} // namespace

bool unite_with(GridSurface& all, GridSurface part) {
    part.boxes.clear();
    for (std::size_t t = 0; t < part.triangles.size(); ++t) part.boxes.push_back(box_of(part, t));
    if (!all.triangles.empty()) return Uniter(all, part).unite();
    all = std::move(part);
    return true;
}

} // namespace pantin
