// SPDX-License-Identifier: MIT
// Strokes, models and checks of surfaces in space for the tests of this module.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/math.hpp"
#include "core/random.hpp"
#include "pantin/model.hpp"

namespace pantin::test {

// --- models ------------------------------------------------------------------------------------------------

inline const std::vector<std::string> model_names = {"bird",    "cat",   "crab",    "deer", "lorax",
                                                     "octopus", "panda", "pokemon", "tree"};

inline Strokes model_strokes(const std::string& name) {
    const std::string file = "testdata/models/" + name + (name == "crab" ? ".svg" : ".json");
    const auto bytes = read_file(file);
    const std::string text(bytes.begin(), bytes.end());
    return name == "crab" ? strokes_from_svg(text, file) : strokes_from_json(text, file);
}

// --- strokes -----------------------------------------------------------------------------------------------

inline std::vector<Point2d> disc(Point2d centre, double radius, int corners = 120) {
    std::vector<Point2d> line;
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * math::pi * i / corners;
        line.push_back(centre + radius * Point2d{math::cos(a), math::sin(a)});
    }
    return line;
}

// A strip from a to b with round ends.
inline std::vector<Point2d> capsule(Point2d a, Point2d b, double radius, int corners = 24) {
    const Point2d u = (radius / distance(a, b)) * (b - a), v = {-u.y, u.x};
    std::vector<Point2d> line;
    for (int i = 0; i <= corners; ++i) {
        const double t = math::pi * (static_cast<double>(i) / corners - 0.5);
        line.push_back(b + math::cos(t) * u + math::sin(t) * v);
    }
    for (int i = 0; i <= corners; ++i) {
        const double t = math::pi * (static_cast<double>(i) / corners + 0.5);
        line.push_back(a + math::cos(t) * u + math::sin(t) * v);
    }
    return line;
}

// A round shape with waves: limbs and bays.
inline std::vector<Point2d> blob(Random& random, int lobes, double depth, double radius = 100) {
    const double phase = random.uniform(0, 6), other = random.uniform(0, 6), small = random.uniform(0, 0.15);
    std::vector<Point2d> line;
    for (int i = 0; i < 200; ++i) {
        const double a = 2 * math::pi * i / 200;
        const double r = 1 + depth * math::sin(lobes * a + phase) + small * math::sin(2 * a + other);
        line.push_back(radius * r * Point2d{math::cos(a), math::sin(a)});
    }
    return line;
}

inline PartStroke part(const std::string& name, const std::vector<Point2d>& stroke,
                       const std::string& parent = "") {
    PartStroke p;
    p.name = name;
    p.stroke = stroke;
    p.parent = parent;
    return p;
}

// --- surfaces ----------------------------------------------------------------------------------------------

inline double volume_of(const SolidMesh& mesh) {
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c]));
    return six / 6;
}

inline Vec3 lowest(const SolidMesh& mesh) {
    Vec3 low = mesh.vertices.front();
    for (const Vec3& v : mesh.vertices)
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    return low;
}
inline Vec3 highest(const SolidMesh& mesh) {
    Vec3 high = mesh.vertices.front();
    for (const Vec3& v : mesh.vertices)
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    return high;
}

// What is wrong with the mesh as a closed, oriented surface; empty: nothing. Every edge has one triangle on
// each side, which run along it in opposite ways, and the triangles around every vertex are one fan.
inline std::string surface_fault(const SolidMesh& mesh) {
    const auto count = static_cast<int>(mesh.vertices.size());
    std::vector<std::pair<int, int>> ways;
    std::vector<std::vector<std::pair<int, int>>> around(mesh.vertices.size()); // edges opposite a vertex
    for (const auto& t : mesh.triangles) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return "a triangle has a corner twice";
        for (int k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
            if (a < 0 || a >= count) return "a corner is no vertex";
            ways.emplace_back(a, b);
            around[a].emplace_back(b, c);
        }
    }
    std::sort(ways.begin(), ways.end());
    if (std::adjacent_find(ways.begin(), ways.end()) != ways.end())
        return "two triangles run along an edge in the same way";
    for (const auto& [a, b] : ways)
        if (!std::binary_search(ways.begin(), ways.end(), std::pair(b, a)))
            return "an edge has a triangle on one side only";
    for (auto& fan : around) {
        if (fan.size() < 3) return "a vertex has fewer than three triangles";
        std::sort(fan.begin(), fan.end());
        std::size_t steps = 0;
        int at = fan.front().first;
        do {
            at = std::lower_bound(fan.begin(), fan.end(), std::pair(at, -1))->second;
            ++steps;
        } while (at != fan.front().first && steps <= fan.size());
        if (steps != fan.size()) return "the triangles around a vertex are several fans";
    }
    return "";
}

inline int components_of(const SolidMesh& mesh) {
    std::vector<int> parent(mesh.vertices.size());
    for (int v = 0; v < std::ssize(parent); ++v) parent[v] = v;
    const auto root = [&](int v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) parent[root(t[k])] = root(t[(k + 1) % 3]);
    int count = 0;
    for (int v = 0; v < std::ssize(parent); ++v) count += parent[v] == v;
    return count;
}

// Handles of all pieces together.
inline int genus_of(const SolidMesh& mesh) {
    const auto faces = static_cast<int>(mesh.triangles.size());
    return components_of(mesh) - (static_cast<int>(mesh.vertices.size()) - faces / 2) / 2;
}

// How often the surface goes around p: the solid angle of all triangles by that of the sphere (van Oosterom &
// Strackee 1983).
inline double winding_of(const SolidMesh& mesh, Vec3 p) {
    double sum = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 a = mesh.vertices[i] - p, b = mesh.vertices[j] - p, c = mesh.vertices[k] - p;
        const double x = length(a), y = length(b), z = length(c);
        sum +=
            2 * math::atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
    }
    return sum / (4 * math::pi);
}

// Whether the ray from p towards the viewer crosses the surface an odd number of times. It begins a little
// beside p, because the vertices of a lattice lie behind each other.
inline bool holds(const SolidMesh& mesh, Vec3 p) {
    p = p + Vec3{1.23e-6, 2.71e-6, 0};
    bool in = false;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 a = mesh.vertices[i] - p, b = mesh.vertices[j] - p, c = mesh.vertices[k] - p;
        if ((a.x > 0 && b.x > 0 && c.x > 0) || (a.x < 0 && b.x < 0 && c.x < 0)) continue;
        const double u = a.x * b.y - a.y * b.x, v = b.x * c.y - b.y * c.x, w = c.x * a.y - c.y * a.x;
        if ((u > 0) != (v > 0) || (v > 0) != (w > 0)) continue;
        if ((v * a.z + w * b.z + u * c.z) * (u + v + w) > 0) in = !in;
    }
    return in;
}

// --- self-intersection -------------------------------------------------------------------------------------

// Counts pairs of triangles that cut each other or fold onto each other. Pairs are found by a grid; a cut
// counts where all the signed volumes that decide it are clear of rounding, so that surfaces which merely
// touch are no fault.
class CutFinder {
public:
    explicit CutFinder(const SolidMesh& mesh) : mesh_(mesh) {
        const Vec3 size = highest(mesh) - lowest(mesh);
        const double side = std::max({size.x, size.y, size.z});
        tiny_ = 1e-13 * side * side * side;
        double sum = 0;
        for (const auto& t : mesh.triangles) sum += distance(at(t[0]), at(t[1]));
        cell_ = 2 * sum / static_cast<double>(mesh.triangles.size());
    }

    int count() {
        std::vector<std::pair<long long, int>> cells;
        for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
            boxes_.push_back({{low(t, &Vec3::x), low(t, &Vec3::y), low(t, &Vec3::z)},
                              {high(t, &Vec3::x), high(t, &Vec3::y), high(t, &Vec3::z)}});
            for (const long long key : cells_of(t)) cells.emplace_back(key, t);
        }
        std::sort(cells.begin(), cells.end());
        std::vector<std::pair<int, int>> pairs;
        for (auto first = cells.begin(); first != cells.end(); ++first)
            for (auto second = first + 1; second != cells.end() && second->first == first->first; ++second)
                if (boxes_meet(first->second, second->second))
                    pairs.emplace_back(first->second, second->second);
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        return static_cast<int>(
            std::count_if(pairs.begin(), pairs.end(), [&](const auto& p) { return cut(p.first, p.second); }));
    }

private:
    Vec3 at(int vertex) const { return mesh_.vertices[vertex]; }
    double low(int t, double Vec3::*axis) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return std::min({at(a).*axis, at(b).*axis, at(c).*axis});
    }
    double high(int t, double Vec3::*axis) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return std::max({at(a).*axis, at(b).*axis, at(c).*axis});
    }
    bool boxes_meet(int s, int t) const {
        const auto& [a, b] = boxes_[s];
        const auto& [c, d] = boxes_[t];
        return a.x <= d.x && a.y <= d.y && a.z <= d.z && c.x <= b.x && c.y <= b.y && c.z <= b.z;
    }
    std::vector<long long> cells_of(int t) const {
        const auto cell = [&](double value) { return static_cast<long long>(std::floor(value / cell_)); };
        std::vector<long long> keys;
        for (long long z = cell(low(t, &Vec3::z)); z <= cell(high(t, &Vec3::z)); ++z)
            for (long long y = cell(low(t, &Vec3::y)); y <= cell(high(t, &Vec3::y)); ++y)
                for (long long x = cell(low(t, &Vec3::x)); x <= cell(high(t, &Vec3::x)); ++x)
                    keys.push_back(((z + 500'000) * 1'000'000 + y + 500'000) * 1'000'000 + x + 500'000);
        return keys;
    }
    // Six times the signed volume of a tetrahedron as −1, 0 or 1.
    int side(Vec3 a, Vec3 b, Vec3 c, Vec3 d) const {
        const double v = dot(d - a, cross(b - a, c - a));
        return v > tiny_ ? 1 : v < -tiny_ ? -1 : 0;
    }
    bool pierces(Vec3 p, Vec3 q, const std::array<int, 3>& t) const {
        const Vec3 a = at(t[0]), b = at(t[1]), c = at(t[2]);
        if (side(a, b, c, p) * side(a, b, c, q) >= 0) return false;
        const int u = side(p, q, a, b), v = side(p, q, b, c), w = side(p, q, c, a);
        return u != 0 && u == v && v == w;
    }
    bool cut(int s, int t) const {
        const std::array<int, 3>&f = mesh_.triangles[s], &g = mesh_.triangles[t];
        int shared = -1, count = 0; // corner
        for (const int v : f)
            if (std::find(g.begin(), g.end(), v) != g.end()) shared = v, ++count;
        if (count >= 2) return folded(f, g);
        const auto edges_cut = [&](const std::array<int, 3>& edges, const std::array<int, 3>& face) {
            for (int k = 0; k < 3; ++k) {
                const int a = edges[k], b = edges[(k + 1) % 3];
                const bool touches = a == shared || b == shared;
                if (!touches && pierces(at(a), at(b), face)) return true;
            }
            return false;
        };
        return edges_cut(f, g) || edges_cut(g, f);
    }
    // Two triangles at an edge that lie on each other.
    bool folded(const std::array<int, 3>& f, const std::array<int, 3>& g) const {
        const Vec3 n = cross(at(f[1]) - at(f[0]), at(f[2]) - at(f[0])),
                   m = cross(at(g[1]) - at(g[0]), at(g[2]) - at(g[0]));
        return dot(n, m) <= -(1 - 1e-12) * length(n) * length(m);
    }

    const SolidMesh& mesh_;
    std::vector<std::pair<Vec3, Vec3>> boxes_; // of the triangles
    double tiny_ = 0, cell_ = 1;
};

inline int self_cuts(const SolidMesh& mesh) { return CutFinder(mesh).count(); }

} // namespace pantin::test
