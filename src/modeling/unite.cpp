// SPDX-License-Identifier: MIT
// Inflated parts in, one closed surface out: the zero set of the smallest of their distances (RealSkel 4.1;
// docs/errata.md, 29).
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "modeling/part_field.hpp"
#include "modeling/tetrahedra.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr double most_refined = 2;         // thin parts make the cell smaller, at most so many times
constexpr double cells_across_half = 1.25; // of a thin part's half width or half thickness
constexpr double table_steps = 2;          // of the fields' tables, to a cell
constexpr double most_points = 3e7;        // of the lattice

Vec3 size_of(const std::vector<InflatedPart>& parts) {
    const Vec3 start = to_model(parts.front().frame, parts.front().inflation->points.front());
    Box3 box{start, start};
    for (const InflatedPart& part : parts)
        for (std::size_t p = 0; p < part.inflation->points.size(); ++p)
            for (const double side : {-1.0, 1.0})
                box.include(to_model(part.frame, part.inflation->points[p],
                                     side * part.height * std::sqrt(part.inflation->squared[p])));
    return box.high - box.low;
}

double cell_for(const std::vector<InflatedPart>& parts, Vec3 size, const UnionOptions& options) {
    if (options.cell > 0) return options.cell;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const InflatedPart& part : parts)
        thinnest = std::min(thinnest, length(part.frame.right) * part.inflation->half_width *
                                          std::min(1.0, part.height));
    const double coarse = std::max({size.x, size.y, size.z}) / options.cells_across;
    return std::clamp(thinnest / cells_across_half, coarse / most_refined, coarse);
}

[[noreturn]] void fail() {
    throw Error(ErrorKind::input, "union: the parts are too thin or too far apart for one grid");
}

void check_size(Vec3 size, double cell) {
    if (!(2 * (size.x / cell + 5) * (size.y / cell + 5) * (size.z / cell + 5) <= most_points)) fail();
}

} // namespace

SolidMesh unite(const std::vector<InflatedPart>& parts, const UnionOptions& options) {
    if (parts.empty()) return {};
    const Vec3 size = size_of(parts);
    const double cell = cell_for(parts, size, options);
    check_size(size, cell); // before the tables, which are as fine
    std::vector<PartField> fields;
    for (const InflatedPart& part : parts) fields.emplace_back(part, cell / table_steps);
    Box3 box = fields.front().box();
    for (const PartField& field : fields) box.include(field.box().low), box.include(field.box().high);
    check_size(box.high - box.low, cell);
    TetrahedraLattice lattice(box.low, box.high, cell);
    for (const PartField& field : fields)
        lattice.each(field.box().low, field.box().high,
                     [&](Vec3 p, double& value) { value = std::min(value, field(p)); });
    const auto nearest = [&](Vec3 p) { // how far, and which part
        std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
        for (std::size_t f = 0; f < fields.size(); ++f)
            if (fields[f].box().holds(p)) best = std::min(best, {fields[f](p), static_cast<int>(f)});
        return best;
    };
    SolidMesh mesh = lattice.surface([&](Vec3 p) { return nearest(p).first; });
    if (mesh.triangles.empty()) fail();
    for (const Vec3& v : mesh.vertices) mesh.parts.push_back(nearest(v).second);
    return mesh;
}

} // namespace pantin
