// SPDX-License-Identifier: MIT
// Inflated parts in, one closed surface out: their own surfaces, united exactly (RealSkel 4.1;
// docs/errata.md, 29).
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/disjoint_sets.hpp"
#include "modeling/solid_union.hpp"
#include "pantin/error.hpp"
#include "pantin/model.hpp"

namespace pantin {
namespace {

constexpr double used = 0.99;     // of the grid's reach
constexpr double smallest = 4096; // steps of the grid: so large is a part at least
constexpr int most_tries = 8;
constexpr double nudge = 64; // steps of the grid

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

GridSurface on_grid(const SolidMesh& mesh, int part, const Grid3& grid, int tried) {
    GridSurface surface;
    const std::int64_t by = static_cast<std::int64_t>(nudge) * tried * (part + 1);
    for (const Vec3& v : mesh.vertices) {
        const GridPoint p = grid.to_grid(v);
        surface.points.push_back({p.x + by, p.y - by, p.z + 2 * by});
    }
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
    for (const auto& [a, b, c] : surface.triangles)
        six[sets.find(a)] += dot(at(a), cross(at(b), at(c)));
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
    std::vector<SolidMesh> surfaces;
    for (const InflatedPart& part : parts)
        surfaces.push_back(part_surface(*part.inflation, part.height, part.frame));
    const Grid3 grid(surfaces);
    for (std::size_t p = 0; p < parts.size(); ++p)
        if (length(parts[p].frame.right) * parts[p].inflation->half_width * grid.scale < smallest)
            throw Error(ErrorKind::input, "union: a part is too small beside the model");
    for (int tried = 0; tried < most_tries; ++tried) {
        GridSurface all;
        bool done = true;
        for (std::size_t p = 0; done && p < parts.size(); ++p)
            done = unite_with(all, on_grid(surfaces[p], static_cast<int>(p), grid, tried));
        if (!done) continue;
        drop_hollows(all);
        if (is_closed(all)) return in_model(all, grid);
    }
    throw Error(ErrorKind::input, "union: the parts lie on each other in too many ways");
}

} // namespace pantin
