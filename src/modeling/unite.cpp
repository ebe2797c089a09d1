// SPDX-License-Identifier: MIT
// Inflated parts in, one closed surface out: the zero set of the smallest of their distances (RealSkel 4.1;
// docs/errata.md, 29).
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "modeling/part_field.hpp"
#include "modeling/tetrahedra.hpp"
#include "modeling/thin_parts.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr double most_refined = 2;         // thin parts make the cell smaller, at most so many times
constexpr double cells_across_half = 1.25; // of a thin part's half width or half thickness
constexpr double table_steps = 2;          // of the fields' tables, to a cell
constexpr double most_points = 3e7;        // of the lattice
// Where parts would be lost the cell becomes smaller still, as far as that costs no more than this:
constexpr double thin_triangles = 60'000, thin_points = 4e6;
constexpr double triangles_of_area = 8; // about so many of a square of a cell's side

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

// Whether all parts together would vanish between the points of the grid.
bool all_smaller_than(double cell, const std::vector<InflatedPart>& parts) {
    return std::all_of(parts.begin(), parts.end(), [&](const InflatedPart& part) {
        const Vec3 size = size_of({part});
        return std::max({size.x, size.y, size.z}) < cell;
    });
}

// A smaller cell, at which those parts are lost no more, or less thick than they would be.
double finer_cell(const std::vector<InflatedPart>& parts, const std::vector<char>& is_thin, Vec3 size,
                  double cell) {
    double area = 0, thinnest = cell;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const double unit = length(parts[p].frame.right);
        const Inflation& flat = *parts[p].inflation;
        for (const auto& [a, b, c] : flat.triangles) // front and back
            area += unit * unit * cross(flat.points[b] - flat.points[a], flat.points[c] - flat.points[a]);
        if (is_thin[p])
            thinnest = std::min(thinnest, unit * flat.half_width * std::min(1.0, parts[p].height));
    }
    const double by_triangles = std::sqrt(triangles_of_area * area / thin_triangles);
    double finer = std::clamp(by_triangles, thinnest / cells_across_half, cell);
    while (finer < cell &&
           2 * (size.x / finer + 5) * (size.y / finer + 5) * (size.z / finer + 5) > thin_points)
        finer *= 1.05;
    return std::min(finer, cell);
}

// The parts as the lattice samples them: what each is, and bars where it is thin.
struct Fields {
    std::vector<PartField> parts;
    std::vector<ThinBar> bars;
    std::vector<char> is_thin; // per part

    Fields(const std::vector<InflatedPart>& inflated, double cell) : is_thin(inflated.size(), 0) {
        for (std::size_t p = 0; p < inflated.size(); ++p) {
            const double least = least_half_thickness(inflated[p], cell);
            is_thin[p] = least > 0;
            parts.emplace_back(inflated[p], cell / table_steps, least);
        }
        bars = thin_bars(inflated, parts, cell);
        for (const ThinBar& bar : bars) is_thin[static_cast<std::size_t>(bar.part())] = 1;
    }

    bool any_thin() const { return std::count(is_thin.begin(), is_thin.end(), 1) > 0; }
    Box3 box() const {
        Box3 box = parts.front().box();
        each([&](const auto& field, int) { box.include(field.box().low), box.include(field.box().high); });
        return box;
    }
    // How far, and which part.
    std::pair<double, int> nearest(Vec3 p) const {
        std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
        each([&](const auto& field, int part) {
            if (field.box().holds(p)) best = std::min(best, {field(p), part});
        });
        return best;
    }
    template <class Visit> void each(const Visit& visit) const {
        for (std::size_t p = 0; p < parts.size(); ++p) visit(parts[p], static_cast<int>(p));
        for (const ThinBar& bar : bars) visit(bar, bar.part());
    }
};

} // namespace

SolidMesh unite(const std::vector<InflatedPart>& parts, const UnionOptions& options) {
    if (parts.empty()) return {};
    const Vec3 size = size_of(parts);
    double cell = cell_for(parts, size, options);
    check_size(size, cell); // before the tables, which are as fine
    if (all_smaller_than(cell, parts)) fail();
    Fields fields(parts, cell);
    if (options.cell <= 0 && fields.any_thin()) {
        cell = finer_cell(parts, fields.is_thin, size, cell);
        fields = Fields(parts, cell);
    }
    const Box3 box = fields.box();
    check_size(box.high - box.low, cell);
    TetrahedraLattice lattice(box.low, box.high, cell);
    fields.each([&](const auto& field, int) {
        lattice.each(field.box().low, field.box().high,
                     [&](Vec3 p, double& value) { value = std::min(value, field(p)); });
    });
    SolidMesh mesh = lattice.surface([&](Vec3 p) { return fields.nearest(p).first; });
    if (mesh.triangles.empty()) fail();
    for (const Vec3& v : mesh.vertices) mesh.parts.push_back(fields.nearest(v).second);
    for (std::size_t p = 0; p < parts.size(); ++p)
        if (fields.is_thin[p]) mesh.thin_parts.push_back(static_cast<int>(p));
    if (!mesh.thin_parts.empty()) mesh.least_thickness = 2 * least_radius(cell);
    return mesh;
}

} // namespace pantin
