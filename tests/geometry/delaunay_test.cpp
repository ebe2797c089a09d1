// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

#include "core/random.hpp"
#include "pantin/geometry.hpp"

using namespace pantin;

namespace {

std::vector<Point2i> random_points(Random& random, int count, int side) {
    std::set<std::pair<int, int>> distinct;
    for (int i = 0; i < count; ++i) {
        const int x = random.integer(0, side), y = random.integer(0, side);
        distinct.insert({x, y});
    }
    std::vector<Point2i> points;
    for (const auto& [x, y] : distinct) points.push_back({x, y});
    for (std::size_t i = points.size(); i > 1; --i)
        std::swap(points[i - 1], points[random.integer(0, static_cast<int>(i) - 1)]);
    return points;
}

// Number of points on the convex hull's boundary, collinear ones included (monotone chain, exact).
int hull_points(std::vector<Point2i> points) {
    std::sort(points.begin(), points.end(),
              [](Point2i a, Point2i b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::set<std::pair<int, int>> on_hull;
    for (int side = 0; side < 2; ++side) {
        std::vector<Point2i> chain;
        for (const Point2i p : points) {
            while (chain.size() >= 2 && orientation(chain[chain.size() - 2], chain.back(), p) < 0)
                chain.pop_back();
            chain.push_back(p);
        }
        for (const Point2i p : chain) on_hull.insert({p.x, p.y});
        std::reverse(points.begin(), points.end());
    }
    return static_cast<int>(on_hull.size());
}

void check_delaunay(const std::vector<Point2i>& points) {
    const Delaunay d = delaunay(points);
    const int n = static_cast<int>(points.size());
    // Euler: a triangulation of n points with h on the hull has 2n − 2 − h triangles.
    REQUIRE(static_cast<int>(d.triangles.size()) == 2 * n - 2 - hull_points(points));
    for (std::size_t t = 0; t < d.triangles.size(); ++t) {
        const auto [a, b, c] = d.triangles[t];
        REQUIRE(orientation(points[a], points[b], points[c]) > 0);
        for (int i = 0; i < n; ++i) REQUIRE(in_circle(points[a], points[b], points[c], points[i]) <= 0);
        for (int i = 0; i < 3; ++i) {
            const int other = d.neighbours[t][i];
            if (other < 0) continue;
            const int u = d.triangles[t][(i + 1) % 3], v = d.triangles[t][(i + 2) % 3];
            const auto& theirs = d.triangles[other];
            REQUIRE(std::count(theirs.begin(), theirs.end(), u) == 1);
            REQUIRE(std::count(theirs.begin(), theirs.end(), v) == 1);
            const auto& back = d.neighbours[other];
            REQUIRE(std::count(back.begin(), back.end(), static_cast<int>(t)) == 1);
        }
    }
}

} // namespace

TEST_CASE("orientation and in_circle give exact signs up to 2^24") {
    const int m = (1 << 24) - 1;
    CHECK(orientation({0, 0}, {1, 0}, {0, 1}) == 1);
    CHECK(orientation({0, 0}, {0, 1}, {1, 0}) == -1);
    CHECK(orientation({-m, -m}, {0, 0}, {m, m}) == 0);
    CHECK(orientation({-m, -m}, {0, 0}, {m, m - 1}) == -1);
    CHECK(orientation({-m, -m}, {m, m - 1}, {m - 1, m}) == 1);
    // The corners of a square are cocircular; one step decides.
    CHECK(in_circle({-m, -m}, {m, -m}, {m, m}, {-m, m}) == 0);
    CHECK(in_circle({-m, -m}, {m, -m}, {m, m}, {-m + 1, m}) == 1);
    CHECK(in_circle({-m + 1, -m + 1}, {m - 1, -m + 1}, {m - 1, m - 1}, {-m + 1, m}) == -1);
    CHECK(in_circle({0, 0}, {4, 0}, {4, 4}, {0, 4}) == 0);
    CHECK(in_circle({0, 0}, {4, 0}, {4, 4}, {1, 3}) == 1);
    CHECK(in_circle({0, 0}, {4, 0}, {4, 4}, {0, 5}) == -1);
}

TEST_CASE("Delaunay triangles have empty circles and cover the hull") {
    Random random(7);
    for (int round = 0; round < 60; ++round) {
        const int count = random.integer(3, 60), side = random.integer(3, 40);
        const std::vector<Point2i> points = random_points(random, count, side);
        if (points.size() >= 3) check_delaunay(points);
    }
    for (int round = 0; round < 5; ++round) check_delaunay(random_points(random, 80, 1 << 23));
}

TEST_CASE("Delaunay of a full pixel lattice: everything is cocircular") {
    std::vector<Point2i> lattice;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 11; ++x) lattice.push_back({x, y});
    check_delaunay(lattice);
    CHECK(delaunay(lattice).triangles.size() == 2 * 8 * 10);
}

TEST_CASE("Delaunay without a triangle: empty, one, two, collinear, equal points") {
    CHECK(delaunay({}).triangles.empty());
    CHECK(delaunay({{1, 1}}).triangles.empty());
    CHECK(delaunay({{1, 1}, {2, 5}}).triangles.empty());
    CHECK(delaunay({{0, 0}, {3, 3}, {1, 1}, {2, 2}, {9, 9}}).triangles.empty());
    CHECK(delaunay({{4, 4}, {4, 4}, {4, 4}}).triangles.empty());
    CHECK(delaunay({{0, 0}, {0, 0}, {5, 0}, {0, 5}, {0, 5}}).triangles.size() == 1);
}

TEST_CASE("Delaunay depends on the set of points, not on their order") {
    Random random(8);
    std::vector<Point2i> points = random_points(random, 120, 15);
    const auto shape = [](const std::vector<Point2i>& p) {
        std::set<std::vector<std::pair<int, int>>> triangles;
        for (const auto& t : delaunay(p).triangles) {
            std::vector<std::pair<int, int>> corners;
            for (const int i : t) corners.push_back({p[i].x, p[i].y});
            std::sort(corners.begin(), corners.end());
            triangles.insert(corners);
        }
        return triangles;
    };
    const auto expected = shape(points);
    for (int round = 0; round < 5; ++round) {
        std::rotate(points.begin(), points.begin() + 31, points.end());
        std::swap(points[3], points[50]);
        CHECK(shape(points) == expected);
    }
}

TEST_CASE("Voronoi vertices are equally far from three sites and nearer to none") {
    Random random(9);
    const std::vector<Point2i> points = random_points(random, 70, 30);
    const std::vector<VoronoiEdge> edges = voronoi_edges(points, delaunay(points));
    REQUIRE(edges.size() > 50);
    for (const VoronoiEdge& edge : edges)
        for (const Point2d v : {edge.from, edge.to}) {
            const double a = distance(v, to_double(points[edge.site_a]));
            REQUIRE(distance(v, to_double(points[edge.site_b])) == Approx(a).margin(1e-9));
            for (const Point2i p : points) REQUIRE(distance(v, to_double(p)) >= a - 1e-7 * (1 + a));
        }
}

TEST_CASE("cocircular triangles share their Voronoi vertex to the bit") {
    // Eight lattice points on one circle around (5/2, 5/2), and far copies whose numerators exceed 2^53.
    for (const int shift : {0, 1000, 8'000'001}) {
        std::vector<Point2i> circle;
        for (const Point2i p : {Point2i{0, 1}, {0, 4}, {1, 0}, {4, 0}, {5, 1}, {5, 4}, {1, 5}, {4, 5}})
            circle.push_back({p.x + shift, p.y - shift});
        for (const VoronoiEdge& edge : voronoi_edges(circle, delaunay(circle))) {
            CHECK(edge.from == edge.to);
            CHECK(edge.from == Point2d{shift + 2.5, 2.5 - shift});
        }
    }
}
