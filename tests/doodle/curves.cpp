// SPDX-License-Identifier: MIT
// Curves, polygons and lines of the generator of drawings.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "core/math.hpp"
#include "doodle/curve.hpp"
#include "doodle/raster.hpp"

using namespace pantin;
using namespace pantin::doodle;

TEST_CASE("resampling keeps the ends, the spacing and the undrawn stretches") {
    const Outline bent{{{0, 0}, {10, 0}, {10, 10}}, {0, 1, 0}, false};
    const Outline fine = resample(bent, 1.0);
    REQUIRE(fine.points.size() == 20);
    CHECK(fine.points.front() == Point2d{0, 0});
    CHECK(distance(fine.points.back(), {10, 10}) < 1e-12);
    for (std::size_t i = 0; i < fine.points.size(); ++i)
        CHECK((fine.undrawn[i] == 1) == (fine.points[i].y > 0.0 || i == 19));
    const Path ring = resample(ellipse({0, 0}, 20, 20), 2.0, true);
    for (std::size_t i = 0; i < ring.size(); ++i)
        CHECK(distance(ring[i], ring[(i + 1) % ring.size()]) == Approx(2.0).margin(0.1));
}

TEST_CASE("a spline runs through its points and a superellipse fulfils its equation") {
    const Path points = {{0, 0}, {5, 8}, {12, 3}, {7, -6}};
    const Path curve = spline(points, true, 5);
    REQUIRE(curve.size() == 20);
    for (std::size_t i = 0; i < points.size(); ++i) CHECK(distance(curve[5 * i], points[i]) < 1e-12);
    for (Point2d p : ellipse({1, 2}, 3, 4, 0, 4)) {
        const double u = (p.x - 1) / 3, v = (p.y - 2) / 4;
        CHECK(u * u * u * u + v * v * v * v == Approx(1.0));
    }
}

TEST_CASE("Douglas-Peucker keeps what is farther than the tolerance") {
    const Path path = {{0, 0}, {1, 0.1}, {2, -0.1}, {3, 3}, {4, 0}};
    CHECK(simplify(path, 0.5) == Path{{0, 0}, {2, -0.1}, {3, 3}, {4, 0}});
    CHECK(simplify(path, 5.0) == Path{{0, 0}, {4, 0}});
}

TEST_CASE("a ribbon's outline keeps the radius from its midline") {
    const Outline limb = ribbon({{0, 0}, {30, 0}}, {4.0, 2.0});
    for (Point2d p : limb.points) {
        const double x = std::clamp(p.x, 0.0, 30.0);
        CHECK(distance(p, {x, 0}) == Approx(4.0 - 2.0 * x / 30).margin(1e-9));
    }
    const Outline open = ribbon({{0, 0}, {30, 0}}, {3.0}, {Cap::flat, Cap::flat, true, false});
    CHECK(std::count(open.undrawn.begin(), open.undrawn.end(), 1) == 1); // the start has no line
}

TEST_CASE("a filled polygon holds the pixel centres inside") {
    const Patch<std::uint8_t> square = fill_polygon({{2.5, 3.5}, {7.5, 3.5}, {7.5, 5.5}, {2.5, 5.5}}, 20, 20);
    int count = 0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            CHECK((square.at(x, y) != 0) == (x >= 3 && x <= 7 && y >= 4 && y <= 5));
            count += square.at(x, y);
        }
    CHECK(count == 10);
    // A figure eight is filled in both lobes, whatever their turning.
    const Patch<std::uint8_t> eight = fill_polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, 20, 20);
    CHECK(eight.at(1, 5) == 1);
    CHECK(eight.at(9, 5) == 1);
    CHECK(eight.at(5, 1) == 0);
}

TEST_CASE("coverage adds up to the area, also where the page cuts it") {
    const auto sum = [](const Patch<float>& patch) {
        return std::accumulate(patch.values.begin(), patch.values.end(), 0.0);
    };
    CHECK(sum(cover_polygon(ellipse({20, 20}, 9, 6), 40, 40)) == Approx(math::pi * 54).epsilon(0.01));
    CHECK(sum(cover_polygon({{-5, -5}, {9.5, -5}, {9.5, 9.5}, {-5, 9.5}}, 40, 40)) ==
          Approx(100.0).epsilon(0.01));
    const double stadium = 20 * 5 + math::pi * 6.25;
    CHECK(sum(cover_line({{10, 10}, {22, 26}}, {2.5, 2.5}, 40, 40)) == Approx(stadium).epsilon(0.02));
    CHECK(cover_line({{-50, -50}, {-40, -40}}, {2.5, 2.5}, 40, 40).values.size() == 0);
}
