// SPDX-License-Identifier: MIT
// Ma et al. 2021, section 4.1: the polygon becomes a triangle mesh, its height field comes from Poisson's
// equation (Dvorožňák et al., Monster Mash, 2020).
#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/SparseCholesky>

#include "geometry/extent.hpp"
#include "pantin/model.hpp"

namespace pantin {
namespace {

constexpr double grid_units = 1 << 20; // of the longer side of the outline: all predicates stay exact

// From the canvas to the grid of whole coordinates, and back.
struct GridFrame {
    Point2d corner;
    double scale = 1;
    explicit GridFrame(const std::vector<Point2d>& outline) {
        corner = outline.front();
        Point2d far = corner;
        for (const Point2d& p : outline) {
            corner = {std::min(corner.x, p.x), std::min(corner.y, p.y)};
            far = {std::max(far.x, p.x), std::max(far.y, p.y)};
        }
        scale = grid_units / std::max(far.x - corner.x, far.y - corner.y);
    }
    Point2i to_grid(Point2d p) const {
        return {static_cast<int>(std::floor((p.x - corner.x) * scale + 0.5)),
                static_cast<int>(std::floor((p.y - corner.y) * scale + 0.5))};
    }
    Point2d to_canvas(Point2i p) const { return corner + (1 / scale) * to_double(p); }
};

double perimeter_of(const std::vector<Point2d>& outline) {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        sum += distance(outline[i], outline[(i + 1) % outline.size()]);
    return sum;
}

// Half the width of a long part: area by perimeter, holes counted in both.
double half_width_of(const PartOutline& outline) {
    double area = std::abs(area_of(outline.corners)), perimeter = perimeter_of(outline.corners);
    for (const std::vector<Point2d>& hole : outline.holes) {
        area -= std::abs(area_of(hole));
        perimeter += perimeter_of(hole);
    }
    return area / perimeter;
}

std::vector<Point2i> on_grid(const std::vector<Point2d>& line, const GridFrame& grid) {
    std::vector<Point2i> loop;
    for (const Point2d& p : line)
        if (const Point2i q = grid.to_grid(p); loop.empty() || !(q == loop.back())) loop.push_back(q);
    return loop;
}

// An edge inside that joins two points of the border would have front and back in one place. The refinement
// leaves those that are too short for it, and a triangle alone.
void split_chords(Inflation& mesh) {
    using Side = std::tuple<int, int, int>; // low, high, triangle
    std::vector<Side> sides;
    for (int t = 0; t < std::ssize(mesh.triangles); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            if (mesh.border[a] && mesh.border[b]) sides.emplace_back(std::min(a, b), std::max(a, b), t);
        }
    std::sort(sides.begin(), sides.end());
    std::vector<std::vector<int>> middles(mesh.triangles.size()); // of the chords at each triangle
    std::vector<std::pair<int, int>> ends;                        // of the chord that each new point halves
    const int first = static_cast<int>(mesh.points.size());
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const auto& [low, high, t] = sides[i];
        if (low != std::get<0>(sides[i + 1]) || high != std::get<1>(sides[i + 1])) continue;
        for (const int side : {t, std::get<2>(sides[i + 1])})
            middles[side].push_back(static_cast<int>(mesh.points.size()));
        mesh.points.push_back(0.5 * (mesh.points[low] + mesh.points[high]));
        mesh.border.push_back(0);
        ends.emplace_back(low, high);
    }
    if (mesh.triangles.size() == 1) middles[0].push_back(-1);
    for (int t = 0; t < std::ssize(middles); ++t) {
        const std::array<int, 3> corners = mesh.triangles[t];
        if (middles[t].empty()) continue;
        std::vector<int> around;
        for (int k = 0; k < 3; ++k) {
            const int a = corners[k], b = corners[(k + 1) % 3];
            around.push_back(a);
            for (const int m : middles[t])
                if (m >= 0 && ends[m - first] == std::pair(std::min(a, b), std::max(a, b)))
                    around.push_back(m);
        }
        // A fan about a middle, or about a point inside where there is none or several.
        int centre = middles[t].front();
        if (middles[t].size() > 1 || centre < 0) {
            centre = static_cast<int>(mesh.points.size());
            mesh.points.push_back(
                (1.0 / 3) * (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]));
            mesh.border.push_back(0);
        }
        std::vector<std::array<int, 3>> fan;
        for (std::size_t i = 0; i < around.size(); ++i) {
            const int a = around[i], b = around[(i + 1) % around.size()];
            if (a != centre && b != centre) fan.push_back({a, b, centre});
        }
        mesh.triangles[t] = fan.front();
        mesh.triangles.insert(mesh.triangles.end(), fan.begin() + 1, fan.end());
    }
}

// −Δh = load; with 2 a strip of half width w has h = w² − x², which is a circle's. Linear elements: stiffness
// by cotangents, a third of the load of each triangle at its corners; nothing at the border.
std::vector<double> solve_poisson(const Inflation& mesh, double load) {
    std::vector<int> number(mesh.points.size(), -1);
    int unknowns = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        if (!mesh.border[p]) number[p] = unknowns++;
    std::vector<double> squared(mesh.points.size(), 0);
    if (unknowns == 0) return squared;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    for (const auto& corners : mesh.triangles) {
        const double twice = cross(mesh.points[corners[1]] - mesh.points[corners[0]],
                                   mesh.points[corners[2]] - mesh.points[corners[0]]);
        for (int k = 0; k < 3; ++k) {
            const int at = corners[k], i = number[corners[(k + 1) % 3]], j = number[corners[(k + 2) % 3]];
            const Point2d u = mesh.points[corners[(k + 1) % 3]] - mesh.points[at],
                          v = mesh.points[corners[(k + 2) % 3]] - mesh.points[at];
            const double weight = 0.5 * dot(u, v) / twice;
            if (i >= 0) entries.emplace_back(i, i, weight);
            if (j >= 0) entries.emplace_back(j, j, weight);
            if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
            if (number[at] >= 0) right[number[at]] += load * twice / 6;
        }
    }
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors(matrix);
    const Eigen::VectorXd solution = factors.solve(right);
    for (std::size_t p = 0; p < squared.size(); ++p)
        if (number[p] >= 0) squared[p] = std::max(solution[number[p]], 0.0);
    return squared;
}

} // namespace

Inflation inflate(const std::vector<Point2d>& stroke, const InflationOptions& options) {
    return inflate(simple_polygon(stroke, options.polygon), options);
}

Inflation inflate(const PartOutline& polygon, const InflationOptions& options) {
    const std::vector<Point2d>& outline = polygon.corners;
    const GridFrame grid(outline);
    std::vector<std::vector<Point2i>> loops = {on_grid(outline, grid)};
    for (const std::vector<Point2d>& hole : polygon.holes) loops.push_back(on_grid(hole, grid));
    const double diagonal = diagonal_of(outline);
    TriangleQuality quality;
    const double width = half_width_of(polygon);
    quality.longest_edge =
        grid.scale * std::clamp(1.4 * width, 0.012 * diagonal, options.longest_edge * diagonal);
    quality.shortest_edge = grid.scale * options.shortest_edge * diagonal;
    const Triangulation triangulation = refined(constrained_delaunay(loops), quality);

    Inflation result;
    result.half_width = width;
    result.triangles = triangulation.triangles;
    for (const Point2i p : triangulation.points) result.points.push_back(grid.to_canvas(p));
    result.border.resize(result.points.size());
    for (std::size_t t = 0; t < triangulation.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            if (triangulation.neighbours[t][k] < 0)
                for (const int other : {1, 2}) result.border[triangulation.triangles[t][(k + other) % 3]] = 1;
    split_chords(result);
    result.squared = solve_poisson(result, options.load);
    return result;
}

Vec3 to_model(const Frame& frame, Point2d canvas, double depth) {
    return frame.origin + canvas.x * frame.right + canvas.y * frame.down + depth * frame.out;
}

SolidMesh part_surface(const Inflation& inflation, double height, const Frame& frame) {
    SolidMesh mesh;
    std::vector<int> back(inflation.points.size());
    for (std::size_t p = 0; p < inflation.points.size(); ++p)
        mesh.vertices.push_back(
            to_model(frame, inflation.points[p], height * std::sqrt(inflation.squared[p])));
    for (std::size_t p = 0; p < inflation.points.size(); ++p) {
        back[p] = inflation.border[p] ? static_cast<int>(p) : static_cast<int>(mesh.vertices.size());
        if (!inflation.border[p])
            mesh.vertices.push_back(
                to_model(frame, inflation.points[p], -height * std::sqrt(inflation.squared[p])));
    }
    // Right, down and out are left-handed on the canvas, so positive triangles are clockwise from the front.
    const bool flip = dot(cross(frame.right, frame.down), frame.out) < 0;
    for (const auto& [a, b, c] : inflation.triangles) {
        mesh.triangles.push_back(flip ? std::array{a, c, b} : std::array{a, b, c});
        mesh.triangles.push_back(flip ? std::array{back[a], back[b], back[c]}
                                      : std::array{back[a], back[c], back[b]});
    }
    return mesh;
}

} // namespace pantin
