// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/math.hpp"
#include "core/random.hpp"
#include "pantin/error.hpp"
#include "pantin/geometry.hpp"
#include "pantin/triangulation.hpp"

using namespace pantin;

namespace {

using Loop = std::vector<Point2i>;

double twice_area(const Loop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += cross(to_double(loop[i]), to_double(loop[(i + 1) % loop.size()]));
    return sum;
}
double twice_area(const Triangulation& t) {
    double sum = 0;
    for (const auto& [a, b, c] : t.triangles)
        sum += cross(to_double(t.points[b]) - to_double(t.points[a]),
                     to_double(t.points[c]) - to_double(t.points[a]));
    return sum;
}

// A star-shaped polygon with a wild radius.
Loop star(Random& random, int corners, double size) {
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * math::pi * i / corners, r = size * random.uniform(0.2, 1);
        loop.push_back({static_cast<int>(r * math::cos(a)), static_cast<int>(r * math::sin(a))});
    }
    return loop;
}

void check_links(const Triangulation& t) {
    for (int i = 0; i < std::ssize(t.triangles); ++i) {
        const auto& [a, b, c] = t.triangles[i];
        REQUIRE(orientation(t.points[a], t.points[b], t.points[c]) > 0);
        for (int k = 0; k < 3; ++k) {
            const int n = t.neighbours[i][k];
            if (n < 0) continue;
            REQUIRE(std::count(t.neighbours[n].begin(), t.neighbours[n].end(), i) == 1);
            const int back = static_cast<int>(std::find(t.neighbours[n].begin(), t.neighbours[n].end(), i) -
                                              t.neighbours[n].begin());
            CHECK(t.triangles[n][(back + 1) % 3] == t.triangles[i][(k + 2) % 3]);
            CHECK(t.triangles[n][(back + 2) % 3] == t.triangles[i][(k + 1) % 3]);
        }
    }
}

// No inner edge could be flipped to a better one.
int illegal_edges(const Triangulation& t) {
    int count = 0;
    for (int i = 0; i < std::ssize(t.triangles); ++i)
        for (int k = 0; k < 3; ++k) {
            const int n = t.neighbours[i][k];
            if (n < i) continue;
            const int back = static_cast<int>(std::find(t.neighbours[n].begin(), t.neighbours[n].end(), i) -
                                              t.neighbours[n].begin());
            const auto& [a, b, c] = t.triangles[i];
            count += in_circle(t.points[a], t.points[b], t.points[c], t.points[t.triangles[n][back]]) > 0;
        }
    return count;
}

std::set<std::pair<int, int>> border_edges(const Triangulation& t) {
    std::set<std::pair<int, int>> edges;
    for (int i = 0; i < std::ssize(t.triangles); ++i)
        for (int k = 0; k < 3; ++k)
            if (t.neighbours[i][k] < 0) {
                const int a = t.triangles[i][(k + 1) % 3], b = t.triangles[i][(k + 2) % 3];
                edges.emplace(std::min(a, b), std::max(a, b));
            }
    return edges;
}

double smallest_angle(const Triangulation& t) { // degrees, over triangles without a corner of the border
    std::set<int> border;
    for (const auto& [a, b] : border_edges(t)) border.insert(a), border.insert(b);
    double largest_cosine = -1;
    for (const auto& corners : t.triangles) {
        if (std::any_of(corners.begin(), corners.end(), [&](int c) { return border.count(c) > 0; })) continue;
        for (int k = 0; k < 3; ++k) {
            const Point2d at = to_double(t.points[corners[k]]);
            const Point2d u = to_double(t.points[corners[(k + 1) % 3]]) - at,
                          v = to_double(t.points[corners[(k + 2) % 3]]) - at;
            largest_cosine = std::max(largest_cosine, dot(u, v) / (length(u) * length(v)));
        }
    }
    return math::atan2(std::sqrt(1 - largest_cosine * largest_cosine), largest_cosine) * 180 / math::pi;
}

} // namespace

TEST_CASE("A square has two triangles, a square with a hole eight", "[triangulation]") {
    const Loop square = {{0, 0}, {90, 0}, {90, 90}, {0, 90}}, hole = {{30, 30}, {60, 30}, {60, 60}, {30, 60}};
    CHECK(constrained_delaunay({square}).triangles.size() == 2);
    const Triangulation ring = constrained_delaunay({square, hole});
    CHECK(ring.triangles.size() == 8);
    CHECK(twice_area(ring) == 2 * (8100 - 900));
    CHECK_THROWS_AS(constrained_delaunay({{{0, 0}, {5, 5}, {9, 9}}}), Error);
}

TEST_CASE("Constrained triangulations of random polygons keep every edge and the area, and are Delaunay",
          "[triangulation]") {
    Random random(5);
    for (int round = 0; round < 300; ++round) {
        const int corners = 3 + random.integer(0, round < 200 ? 40 : 300);
        const Loop loop = star(random, std::max(corners, 4), round % 3 == 0 ? 60 : 500000);
        std::set<std::pair<int, int>> places;
        for (const Point2i p : loop) places.emplace(p.x, p.y);
        if (places.size() < loop.size()) continue; // on the coarse grid corners meet
        const Triangulation t = constrained_delaunay({loop});
        check_links(t);
        CHECK(illegal_edges(t) == 0);
        if (round % 3 == 0)
            continue; // rounded to a coarse grid, corners may lie on other edges or beyond them
        CHECK(twice_area(t) == std::abs(twice_area(loop)));
        CHECK(t.triangles.size() == loop.size() - 2);
        const auto border = border_edges(t);
        CHECK(border.size() == loop.size());
    }
}

TEST_CASE("Refined triangulations have good angles and no triangle with all corners on the border",
          "[triangulation]") {
    Random random(6);
    for (int round = 0; round < 60; ++round) {
        const Loop loop = star(random, 8 + random.integer(0, 30), 500000);
        const Triangulation coarse = constrained_delaunay({loop});
        TriangleQuality quality;
        quality.longest_edge = 60000;
        quality.shortest_edge = 4000;
        const Triangulation t = refined(coarse, quality);
        check_links(t);
        CHECK(std::abs(twice_area(t) / twice_area(coarse) - 1) < 1e-4);
        CHECK(t.points.size() < 5000);
        CHECK(smallest_angle(t) > 15);
        const auto border = border_edges(t);
        std::set<int> on;
        for (const auto& [a, b] : border) on.insert(a), on.insert(b);
        for (const auto& corners : t.triangles) {
            CHECK_FALSE(std::all_of(corners.begin(), corners.end(), [&](int c) { return on.count(c) > 0; }));
            for (int k = 0; k < 3; ++k)
                CHECK(distance(to_double(t.points[corners[k]]), to_double(t.points[corners[(k + 1) % 3]])) <
                      1.8 * quality.longest_edge);
        }
        for (std::size_t p = 0; p < loop.size(); ++p) CHECK(t.points[p] == coarse.points[p]);
    }
}
