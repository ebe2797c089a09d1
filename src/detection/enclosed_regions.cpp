// SPDX-License-Identifier: MIT
// Background regions that outlines enclose, with gaps or without: the ink's border pixels in, a mask out.
//
// Closing the ink with a disc and filling asks which background the disc cannot reach from outside. The
// Delaunay triangulation of the ink's border pixels answers it for all radii at once: a triangle is passed
// through its edges, and the widest disc that passes an edge has half its length. Triangles flow towards
// wider ones (an obtuse triangle through its longest edge, an acute one is a sink), which makes basins, each
// the surroundings of a local maximum of the distance to ink, its inradius; basins meet at edges. Seen from
// wide to narrow edges, a basin, or several that have met, is enclosed when the edge through which it meets
// the outside, its mouth, is narrow compared with its inradius. The space between two legs is as wide at its
// mouth as anywhere, ratio 1, and stays outside at every radius; a body whose outline has a gap does not. The
// cut is the straight edge between the two stroke ends; nothing is dilated. Where the way out is a corridor
// (a leg without a foot), the cut is moved to its outer end.
//
// Based on: H. Edelsbrunner, M. Facello, J. Liang: On the definition and the construction of pockets in
// macromolecules. Discrete Applied Mathematics 88, 1998 (flow on Delaunay triangles, pockets and their
// mouths). It takes the place of the closing with growing radii that thesis 4.2 hints at ("dilating the input
// … only allows to close small holes").
#include "detection/enclosed_regions.hpp"

#include <algorithm>
#include <numeric>

#include "core/disjoint_sets.hpp"
#include "pantin/geometry.hpp"
#include "pantin/image.hpp"

namespace pantin {

namespace {

// Squared length of the edge between 8-adjacent ink pixels, which nothing passes.
constexpr int longest_wall = 2;

// --- triangles to basins ---------------------------------------------------------------------------------

struct Saddle {
    int a = 0, b = 0; // basins; 0 is the outside
    int squared = 0;  // length of the edge between them
};
struct Basins {
    std::vector<int> of_triangle;
    std::vector<double> squared_inradius; // largest circumradius of an acute triangle
    std::vector<double> area;
    std::vector<Saddle> saddles; // from wide to narrow
};

std::vector<Point2i> border_pixels(const Mask& ink) {
    std::vector<Point2i> points;
    for (int y = 0; y < ink.height(); ++y)
        for (int x = 0; x < ink.width(); ++x)
            if (on_border(ink, x, y)) points.push_back({x, y});
    return points;
}

int squared_distance(Point2i a, Point2i b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

// Lengths (squared, of the edge opposite each corner) and area of a triangle.
struct Shape {
    int squared[3];
    std::int64_t double_area;
    // The corner with an obtuse angle, −1 when there is none.
    int obtuse_corner() const {
        for (int i = 0; i < 3; ++i)
            if (squared[i] > squared[(i + 1) % 3] + squared[(i + 2) % 3]) return i;
        return -1;
    }
    double squared_circumradius() const { // (abc)² / (4·area)²
        const double area = static_cast<double>(double_area);
        return 1.0 * squared[0] * squared[1] * squared[2] / (4 * area * area);
    }
};
Shape shape_of(const std::vector<Point2i>& points, const std::array<int, 3>& corners) {
    const Point2i a = points[corners[0]], b = points[corners[1]], c = points[corners[2]];
    const std::int64_t twice = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
    return {{squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)}, std::abs(twice)};
}

// Obtuse triangles flow through their longest edge, unless it is a wall; beyond the convex hull is the
// outside.
Basins make_basins(const std::vector<Point2i>& points, const Delaunay& mesh) {
    const int count = static_cast<int>(mesh.triangles.size());
    std::vector<Shape> shapes;
    for (const auto& corners : mesh.triangles) shapes.push_back(shape_of(points, corners));
    DisjointSets sets(static_cast<std::size_t>(count) + 1); // triangle t is element t + 1
    for (int t = 0; t < count; ++t) {
        const int corner = shapes[t].obtuse_corner();
        if (corner >= 0 && shapes[t].squared[corner] > longest_wall)
            sets.unite(t + 1, mesh.neighbours[t][corner] + 1);
    }
    Basins basins;
    std::vector<int> number(static_cast<std::size_t>(count) + 1, -1); // of the basin with that root
    const auto basin_of = [&](int element) {
        int& basin = number[sets.find(element)];
        if (basin < 0) {
            basin = static_cast<int>(basins.area.size());
            basins.area.push_back(0);
            basins.squared_inradius.push_back(0);
        }
        return basin;
    };
    basin_of(0);
    for (int t = 0; t < count; ++t) {
        const int basin = basin_of(t + 1);
        basins.of_triangle.push_back(basin);
        basins.area[basin] += 0.5 * static_cast<double>(shapes[t].double_area);
        if (shapes[t].obtuse_corner() < 0)
            basins.squared_inradius[basin] =
                std::max(basins.squared_inradius[basin], shapes[t].squared_circumradius());
    }
    for (int t = 0; t < count; ++t) {
        for (int i = 0; i < 3; ++i) {
            const int neighbour = mesh.neighbours[t][i], squared = shapes[t].squared[i];
            if (neighbour >= t || squared <= longest_wall) continue; // each edge once
            const int a = basins.of_triangle[t], b = neighbour < 0 ? 0 : basins.of_triangle[neighbour];
            if (a != b) basins.saddles.push_back({a, b, squared});
        }
    }
    std::stable_sort(basins.saddles.begin(), basins.saddles.end(),
                     [](const Saddle& p, const Saddle& q) { return p.squared > q.squared; });
    return basins;
}

// --- basins to enclosed regions ----------------------------------------------------------------------------

class RegionFinder {
public:
    RegionFinder(const Basins& basins, const EnclosedRegionOptions& options, double hull_area,
                 double diagonal)
        : basins_(basins), options_(options), hull_area_(hull_area),
          widest_(2 * options.max_mouth * diagonal), sets_(basins.area.size()),
          squared_inradius_(basins.squared_inradius), area_(basins.area), enclosed_(basins.area.size(), 0) {}

    // Which basins are outside once every enclosed region is cut off at its mouths.
    std::vector<char> outside() {
        for (const Saddle& saddle : basins_.saddles) meet(saddle);
        std::vector<char> outside(basins_.area.size());
        for (std::size_t i = 0; i < outside.size(); ++i) outside[i] = sets_.find(static_cast<int>(i)) == 0;
        extend_along_corridors(outside);
        return outside;
    }

private:
    bool is_enclosed(int set, int squared_mouth) const {
        if (squared_mouth > widest_ * widest_) return false;
        const double share = std::min(1.0, area_[set] / (options_.large_share * hull_area_));
        const double ratio = options_.small_ratio + share * (options_.large_ratio - options_.small_ratio);
        return 4 * squared_inradius_[set] >= ratio * ratio * squared_mouth;
    }

    void meet(const Saddle& saddle) {
        const int a = sets_.find(saddle.a), b = sets_.find(saddle.b);
        if (a == b) return;
        const int low = std::min(a, b), high = std::max(a, b);
        if (low == 0) {
            if (enclosed_[high]) return; // another mouth of the region, narrower than the first
            if (is_enclosed(high, saddle.squared)) {
                enclosed_[high] = 1;
                return;
            }
        }
        sets_.unite(low, high);
        squared_inradius_[low] = std::max(squared_inradius_[low], squared_inradius_[high]);
        area_[low] += area_[high];
        enclosed_[low] |= enclosed_[high];
    }

    // Moves each cut to the outer end of its corridor: an outside basin that is hardly wider than the mouth
    // through which it meets an enclosed region belongs to it. Repeated until nothing changes.
    void extend_along_corridors(std::vector<char>& outside) const {
        for (bool changed = true; changed;) {
            changed = false;
            for (const Saddle& saddle : basins_.saddles) {
                if (outside[saddle.a] == outside[saddle.b]) continue;
                const int outer = outside[saddle.a] ? saddle.a : saddle.b;
                const double limit = options_.corridor * options_.corridor * saddle.squared;
                if (outer == 0 || 4 * basins_.squared_inradius[outer] > limit) continue;
                outside[outer] = 0;
                changed = true;
            }
        }
    }

    const Basins& basins_;
    const EnclosedRegionOptions& options_;
    double hull_area_, widest_;
    DisjointSets sets_;
    std::vector<double> squared_inradius_, area_; // of the sets
    std::vector<char> enclosed_;
};

// Sets the pixels inside or on the border of a triangle.
void fill_triangle(Mask& mask, Point2i a, Point2i b, Point2i c) {
    for (int y = std::min({a.y, b.y, c.y}); y <= std::max({a.y, b.y, c.y}); ++y) {
        for (int x = std::min({a.x, b.x, c.x}); x <= std::max({a.x, b.x, c.x}); ++x) {
            const int sides[3] = {orientation(a, b, {x, y}), orientation(b, c, {x, y}),
                                  orientation(c, a, {x, y})};
            const bool left = sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0;
            const bool right = sides[0] <= 0 && sides[1] <= 0 && sides[2] <= 0;
            if (left || right) mask(x, y) = 1;
        }
    }
}

double box_diagonal(const std::vector<Point2i>& points) {
    Point2i low = points.front(), high = points.front();
    for (Point2i p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return distance(to_double(low), to_double({high.x + 1, high.y + 1}));
}

} // namespace

Mask find_enclosed_regions(const Mask& ink, const EnclosedRegionOptions& options) {
    Mask regions(ink.width(), ink.height());
    const std::vector<Point2i> points = border_pixels(ink);
    const Delaunay mesh = delaunay(points);
    if (mesh.triangles.empty()) return regions;
    const Basins basins = make_basins(points, mesh);
    const double hull_area = std::accumulate(basins.area.begin(), basins.area.end(), 0.0);
    const std::vector<char> outside =
        RegionFinder(basins, options, hull_area, box_diagonal(points)).outside();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if (!outside[basins.of_triangle[t]]) fill_triangle(regions, points[a], points[b], points[c]);
    }
    for (std::size_t i = 0; i < regions.size(); ++i) regions.data()[i] &= ink.data()[i] ^ 1;
    return regions;
}

} // namespace pantin
