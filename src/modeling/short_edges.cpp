// SPDX-License-Identifier: MIT
// A closed surface in, the same without its shortest edges out (Hoppe et al. 1993).
#include "modeling/short_edges.hpp"

#include <algorithm>
#include <tuple>

#include "pantin/point.hpp"

namespace pantin {
namespace {

class EdgeCollapser {
public:
    explicit EdgeCollapser(GridSurface& surface) : surface_(surface), around_(surface.points.size()) {
        for (int t = 0; t < std::ssize(surface.triangles); ++t)
            for (const int v : surface.triangles[t]) around_[v].push_back(t);
    }

    void collapse(double shorter) {
        for (bool changed = true; changed;) { // one may free the next
            changed = false;
            for (const auto& [far, a, b] : edges(shorter))
                changed = try_collapse(a, b) || try_collapse(b, a) || changed;
        }
        GridSurface kept;
        kept.points = surface_.points;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
            if (surface_.triangles[t][0] >= 0) {
                kept.triangles.push_back(surface_.triangles[t]);
                kept.parts.push_back(surface_.parts[t]);
            }
        surface_ = std::move(kept);
    }

private:
    std::vector<std::tuple<double, int, int>> edges(double shorter) const { // the shortest first
        std::vector<std::tuple<double, int, int>> found;
        for (const auto& t : surface_.triangles)
            for (int k = 0; k < 3; ++k)
                if (const int a = t[k], b = t[(k + 1) % 3]; a < b)
                    if (const double far = distance(at(a), at(b)); far < shorter)
                        found.emplace_back(far, a, b);
        std::sort(found.begin(), found.end());
        return found;
    }
    Vec3 at(int v) const {
        const GridPoint& p = surface_.points[v];
        return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    }
    bool has(int t, int v) const {
        const auto& corners = surface_.triangles[t];
        return std::find(corners.begin(), corners.end(), v) != corners.end();
    }
    std::vector<int> neighbours(int v) const {
        std::vector<int> all;
        for (const int t : around_[v])
            for (const int w : surface_.triangles[t])
                if (w != v) all.push_back(w);
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }
    // Whether the triangle would turn over with `from` at the place of `to`; one without area may.
    bool turns(int t, int from, int to) const {
        std::array<Vec3, 3> p, q;
        for (int k = 0; k < 3; ++k) {
            const int v = surface_.triangles[t][k];
            p[k] = at(v), q[k] = at(v == from ? to : v);
        }
        const Vec3 before = cross(p[1] - p[0], p[2] - p[0]), after = cross(q[1] - q[0], q[2] - q[0]);
        const double sizes = length(before) * length(after);
        return dot(after, after) == 0 || (sizes > 0 && dot(before, after) < 0.5 * sizes);
    }

    // One point of two: `from` goes.
    bool try_collapse(int from, int to) {
        const std::vector<int> a = neighbours(from), b = neighbours(to);
        if (!std::binary_search(a.begin(), a.end(), to) || a.size() + b.size() < 7) return false;
        std::vector<int> both;
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
        if (both.size() != 2) return false;
        for (const int v : both)
            if (around_[v].size() < 4) return false;
        for (const int t : around_[from])
            if (!has(t, to) && turns(t, from, to)) return false;
        for (const int t : around_[from]) {
            if (!has(t, to)) {
                std::replace(surface_.triangles[t].begin(), surface_.triangles[t].end(), from, to);
                around_[to].push_back(t);
                continue;
            }
            for (const int v : surface_.triangles[t])
                if (v != from) std::erase(around_[v], t);
            surface_.triangles[t] = {-1, -1, -1};
        }
        around_[from].clear();
        return true;
    }

    GridSurface& surface_;
    std::vector<std::vector<int>> around_; // triangles
};

} // namespace

void collapse_short_edges(GridSurface& surface, double shorter) { EdgeCollapser(surface).collapse(shorter); }

} // namespace pantin
