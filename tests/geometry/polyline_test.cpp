// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "core/random.hpp"
#include "pantin/geometry.hpp"

using namespace pantin;

TEST_CASE("resampling keeps the ends and spaces the points equally along the line") {
    const std::vector<Point2d> corner = {{0, 0}, {4, 0}, {4, 0}, {4, 4}};
    CHECK(polyline_length(corner) == 8);
    const auto five = resample(corner, 5);
    CHECK(five == std::vector<Point2d>{{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}});
    CHECK(resample(corner, 2) == std::vector<Point2d>{{0, 0}, {4, 4}});
    CHECK(resample({{3, 1}}, 3) == std::vector<Point2d>{{3, 1}, {3, 1}, {3, 1}});
}

TEST_CASE("Douglas-Peucker keeps every dropped point within the tolerance") {
    CHECK(douglas_peucker({}, 1).empty());
    CHECK(douglas_peucker({{1, 1}}, 1) == std::vector<int>{0});
    CHECK(douglas_peucker({{0, 0}, {1, 0.4}, {2, 0}, {3, 2}, {4, 0}}, 0.5) == std::vector<int>{0, 2, 3, 4});
    // A closed line: its ends coincide, the distance is that to the point.
    CHECK(douglas_peucker({{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 0}}, 0.5) == std::vector<int>{0, 1, 2, 3, 4});
    Random random(5);
    for (int round = 0; round < 30; ++round) {
        std::vector<Point2d> line = {{0, 0}};
        for (int i = 0; i < 50; ++i) {
            const double dx = random.uniform(0, 2), dy = random.uniform(-1, 1);
            line.push_back({line.back().x + dx, line.back().y + dy});
        }
        const auto kept = douglas_peucker(line, 1.5);
        REQUIRE(kept.front() == 0);
        REQUIRE(kept.back() == 50);
        for (std::size_t k = 1; k < kept.size(); ++k)
            for (int i = kept[k - 1]; i <= kept[k]; ++i) {
                const Point2d a = line[kept[k - 1]], b = line[kept[k]], p = line[i];
                REQUIRE(std::abs(cross(b - a, p - a)) / distance(a, b) <= 1.5 + 1e-9);
            }
    }
}
