// SPDX-License-Identifier: MIT
// Inflated parts in, one closed surface out: their own surfaces, united exactly (RealSkel 4.1;
// docs/errata.md, 29).
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/disjoint_sets.hpp"
#include "modeling/short_edges.hpp"
#include "modeling/solid_union.hpp"
#include "pantin/error.hpp"
#include "pantin/model.hpp"

namespace pantin {
namespace {

constexpr double used = 0.99;          // of the grid's reach
constexpr double smallest = 1e6;       // steps of the grid: half a part's width, at least
constexpr double shortest_edge = 2e-5; // of the grid's reach: what is shorter is left over from cuts
constexpr double shrink = 1e-4;        // of a part's size
constexpr int most_tries = 8;

// From the model to whole coordinates and back.
struct Grid3 {
    Vec3 middle;
    double scale = 1; // steps in a unit

    explicit Grid3(const std::vector<SolidMesh>& surfaces) {
        Vec3 low = surfaces.front().vertices.front(), high = low;
        for (const SolidMesh& surface : surfaces)
            for (const Vec3& v : surface.vertices) {
                low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
                high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
            }
        middle = 0.5 * (low + high);
        const Vec3 half = 0.5 * (high - low);
        // A power of two, so that places on both sides of a plane of symmetry stay so.
        scale = std::exp2(std::floor(std::log2(used * grid_reach / std::max({half.x, half.y, half.z}))));
    }
    GridPoint to_grid(Vec3 v) const {
        const auto whole = [&](double x) { return static_cast<std::int64_t>(std::floor(x * scale + 0.5)); };
        const Vec3 p = v - middle;
        return {whole(p.x), whole(p.y), whole(p.z)};
    }
    Vec3 to_model(GridPoint p) const {
        return middle + (1 / scale) * Vec3{static_cast<double>(p.x), static_cast<double>(p.y),
                                           static_cast<double>(p.z)};
    }
};

// Of a sequence that fills the range −0.5 to 0.5 evenly and never repeats.
double spread(int number, double step) {
    const double x = number * step;
    return x - std::floor(x) - 0.5;
}

// A little smaller than it is, so that parts which only touch stay apart, and moved by still less, so that
// what lies on one plane of symmetry does not coincide.
SolidMesh set_apart(const InflatedPart& part, int number) {
    SolidMesh mesh = part_surface(*part.inflation, part.height, part.frame);
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& v : mesh.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    const Vec3 middle = 0.5 * (low + high);
    const double by = 0.5 * shrink * length(part.frame.right) * part.inflation->half_width;
    const Vec3 move = by * Vec3{spread(number, 0.8192), spread(number, 0.6710), spread(number, 0.5497)};
    for (Vec3& v : mesh.vertices) v = middle + (1 - shrink) * (v - middle) + move;
    return mesh;
}

GridSurface on_grid(const SolidMesh& mesh, int part, const Grid3& grid) {
    GridSurface surface;
    for (const Vec3& v : mesh.vertices) surface.points.push_back(grid.to_grid(v));
    surface.triangles = mesh.triangles;
    surface.parts.assign(mesh.triangles.size(), part);
    return surface;
}

// Without the surfaces of hollows that the parts enclose.
void drop_hollows(GridSurface& surface) {
    DisjointSets sets(surface.points.size());
    for (const auto& [a, b, c] : surface.triangles) sets.unite(a, b), sets.unite(b, c);
    std::vector<double> six(surface.points.size(), 0); // times the volume
    const auto at = [&](int v) {
        const GridPoint& p = surface.points[v];
        return Vec3{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    };
    for (const auto& [a, b, c] : surface.triangles) six[sets.find(a)] += dot(at(a), cross(at(b), at(c)));
    GridSurface kept;
    kept.points = surface.points;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (six[sets.find(surface.triangles[t][0])] > 0) {
            kept.triangles.push_back(surface.triangles[t]);
            kept.parts.push_back(surface.parts[t]);
        }
    surface = std::move(kept);
}

bool is_closed(const GridSurface& surface) {
    std::vector<std::pair<int, int>> ways;
    for (const auto& t : surface.triangles)
        for (int k = 0; k < 3; ++k) ways.emplace_back(t[k], t[(k + 1) % 3]);
    std::sort(ways.begin(), ways.end());
    if (std::adjacent_find(ways.begin(), ways.end()) != ways.end()) return false;
    return std::all_of(ways.begin(), ways.end(), [&](const auto& way) {
        return std::binary_search(ways.begin(), ways.end(), std::pair(way.second, way.first));
    });
}

void check_sizes(const std::vector<InflatedPart>& parts, const Grid3& grid) {
    for (const InflatedPart& part : parts)
        if (length(part.frame.right) * part.inflation->half_width * grid.scale < smallest)
            throw Error(ErrorKind::input, "union: a part is too small beside the model");
}

SolidMesh in_model(const GridSurface& surface, const Grid3& grid) {
    SolidMesh mesh;
    std::vector<int> number(surface.points.size(), -1);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<int, 3> triangle{};
        for (int k = 0; k < 3; ++k) {
            int& n = number[surface.triangles[t][k]];
            if (n < 0) {
                n = static_cast<int>(mesh.vertices.size());
                mesh.vertices.push_back(grid.to_model(surface.points[surface.triangles[t][k]]));
                mesh.parts.push_back(surface.parts[t]);
            }
            triangle[k] = n;
        }
        mesh.triangles.push_back(triangle);
    }
    mesh.triangle_parts = surface.parts;
    return mesh;
}

} // namespace

SolidMesh unite(const std::vector<InflatedPart>& parts) {
    if (parts.empty()) return {};
    for (int tried = 0; tried < most_tries; ++tried) {
        std::vector<SolidMesh> surfaces;
        for (int p = 0; p < std::ssize(parts); ++p)
            surfaces.push_back(set_apart(parts[p], p + tried * static_cast<int>(parts.size())));
        const Grid3 grid(surfaces);
        check_sizes(parts, grid);
        GridSurface all;
        bool done = true;
        for (int p = 0; done && p < std::ssize(parts); ++p)
            done = unite_with(all, on_grid(surfaces[p], p, grid));
        if (!done) continue;
        drop_hollows(all);
        if (!is_closed(all)) continue;
        collapse_short_edges(all, shortest_edge * grid_reach);
        return in_model(all, grid);
    }
    throw Error(ErrorKind::input, "union: the parts lie on each other in too many ways");
}

} // namespace pantin
