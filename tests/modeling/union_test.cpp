// SPDX-License-Identifier: MIT
// United surfaces: closed, oriented, the volume that they should have.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "core/random.hpp"
#include "modeling/solids.hpp"
#include "modeling/surface_distance.hpp"
#include "pantin/error.hpp"
#include "pantin/model.hpp"

using namespace pantin;

namespace {

const Frame front; // the canvas as it is seen from the front, the model's origin at its own

double area_of(const std::vector<Point2d>& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i], loop[(i + 1) % loop.size()]);
    return std::abs(twice) / 2;
}

Frame shifted(Vec3 by) {
    Frame frame;
    frame.origin = by;
    return frame;
}

// Half thickness at a point of the canvas: the highest of the triangles over it.
double thickness_at(const SolidMesh& mesh, Point2d p) {
    double highest = -1;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 a = mesh.vertices[i], b = mesh.vertices[j], c = mesh.vertices[k];
        const Point2d o{a.x, -a.y}, u = Point2d{b.x, -b.y} - o, v = Point2d{c.x, -c.y} - o;
        const double twice = cross(u, v);
        if (twice == 0) continue;
        const double s = cross(p - o, v) / twice, t = cross(u, p - o) / twice;
        if (s >= 0 && t >= 0 && s + t <= 1)
            highest = std::max(highest, a.z + s * (b.z - a.z) + t * (c.z - a.z));
    }
    return highest;
}

} // namespace

// --- inflation ---------------------------------------------------------------------------------------------

TEST_CASE("a long strip is inflated to a round bar") {
    for (const double half : {12.0, 20.0, 30.0}) {
        InflationOptions options;
        options.longest_edge = std::min(options.longest_edge, 0.6 * half / 400);
        const Inflation bar = inflate(test::capsule({-200, 0}, {200, 0}, half), options);
        const SolidMesh mesh = part_surface(bar, 1, front);
        CAPTURE(half);
        for (const double x : {-80.0, 0.0, 33.0})
            CHECK(thickness_at(mesh, {x, 0}) == Approx(half).epsilon(0.05));
        for (std::size_t p = 0; p < bar.points.size(); ++p) // a circle's chords
            if (std::abs(bar.points[p].x) < 120)
                CHECK(std::abs(bar.squared[p] - (half * half - bar.points[p].y * bar.points[p].y)) <
                      0.1 * half * half); // 5 % of the thickness
        CHECK(bar.half_width == Approx(half).epsilon(0.1));
    }
}

TEST_CASE("a disc of radius r is r over the root of two thick on each side, an ellipsoid") {
    for (const double r : {1.0, 40.0, 1000.0}) {
        const Inflation ball = inflate(test::disc({5 * r, -3 * r}, r));
        const SolidMesh mesh = part_surface(ball, 1, front);
        CAPTURE(r);
        CHECK(thickness_at(mesh, {5 * r, -3 * r}) == Approx(r / std::sqrt(2)).epsilon(0.02));
        CHECK(test::volume_of(mesh) == Approx(4.0 / 3 * math::pi * r * r * r / std::sqrt(2)).epsilon(0.03));
        CHECK(test::volume_of(part_surface(ball, 0.5, front)) ==
              Approx(0.5 * test::volume_of(mesh)).epsilon(1e-9));
    }
}

TEST_CASE("the squared thickness solves Poisson's equation: nothing at the border, positive inside, the "
          "strip's at the most") {
    Random random(71);
    for (int round = 0; round < 20; ++round) {
        const std::vector<Point2d> stroke = test::blob(random, 3 + round % 5, 0.4);
        const Inflation inflation = inflate(stroke);
        double area = 0;
        for (const auto& [a, b, c] : inflation.triangles) {
            const double twice =
                cross(inflation.points[b] - inflation.points[a], inflation.points[c] - inflation.points[a]);
            CHECK(twice > 0);
            area += twice / 2;
        }
        CHECK(area == Approx(area_of(stroke)).epsilon(0.01));
        for (std::size_t p = 0; p < inflation.points.size(); ++p) {
            CHECK((inflation.squared[p] > 0) == !inflation.border[p]);
            // The solution on a disc around the whole shape is larger everywhere (maximum principle).
            CHECK(inflation.squared[p] <= 0.5 * 170 * 170);
        }
    }
}

TEST_CASE("front and back of a part are one closed surface, from every side and mirrored") {
    Random random(72);
    for (int round = 0; round < 50; ++round) {
        const std::vector<Point2d> stroke =
            test::blob(random, 2 + round % 6, random.uniform(0.1, 0.5), random.uniform(0.01, 500));
        const Inflation inflation = inflate(stroke);
        Frame frame;
        if (round % 3 == 1) frame = {{3, 4, 5}, {0, 0, -2}, {0, -2, 0}, {2, 0, 0}};
        if (round % 3 == 2) frame = {{-7, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}; // mirrored
        const SolidMesh mesh = part_surface(inflation, random.uniform(0.3, 2), frame);
        CAPTURE(round);
        CHECK(test::surface_fault(mesh) == "");
        CHECK(test::components_of(mesh) == 1);
        CHECK(test::volume_of(mesh) > 0);
        CHECK(mesh.vertices.size() + mesh.triangles.size() - mesh.triangles.size() * 3 / 2 ==
              2); // Euler: a sphere
        if (round % 5 == 0) CHECK(test::self_cuts(mesh) == 0);
    }
}

// --- union -------------------------------------------------------------------------------------------------

TEST_CASE("the checker of self-intersection finds cuts and folds") {
    const Inflation ball = inflate(test::disc({0, 0}, 20));
    SolidMesh two = part_surface(ball, 1, front);
    CHECK(test::self_cuts(two) == 0);
    const SolidMesh other = part_surface(ball, 1, shifted({9.7, 3.1, 2.2}));
    const int count = static_cast<int>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles) two.triangles.push_back({a + count, b + count, c + count});
    CHECK(test::self_cuts(two) > 20);
    CHECK(test::surface_fault(two) == "");
    CHECK(test::components_of(two) == 2);
    SolidMesh folded;
    folded.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.5, 0}};
    folded.triangles = {{0, 1, 2}, {1, 0, 3}};
    CHECK(test::self_cuts(folded) == 1);
    folded.vertices[3] = {0.5, -1, 0};
    CHECK(test::self_cuts(folded) == 0);
    CHECK(test::surface_fault(folded) != "");
}

TEST_CASE("volumes of united solids follow the rule of sums") {
    const Inflation large = inflate(test::disc({0, 0}, 50)), small = inflate(test::disc({0, 0}, 20));
    const double volume = test::volume_of(part_surface(large, 1, front)),
                 less = test::volume_of(part_surface(small, 1, front));
    const SolidMesh one = unite({{&large, 1, front}});
    CHECK(test::volume_of(one) == Approx(volume).epsilon(1e-3));
    const SolidMesh apart = unite({{&large, 1, front}, {&small, 1, shifted({90, 10, 0})}});
    CHECK(test::components_of(apart) == 2);
    CHECK(test::volume_of(apart) == Approx(volume + less).epsilon(1e-3));
    const SolidMesh within = unite({{&large, 1, front}, {&small, 1, shifted({6, -3, 2})}});
    CHECK(test::components_of(within) == 1);
    CHECK(test::volume_of(within) == Approx(test::volume_of(one)).epsilon(1e-3));
    const SolidMesh twice = unite({{&large, 1, front}, {&large, 1, front}});
    CHECK(test::components_of(twice) == 1);
    CHECK(test::surface_fault(twice) == "");
    CHECK(test::volume_of(twice) == Approx(volume).epsilon(1e-3));
    // Two that overlap: their sum without what both hold, which points at random find.
    const Frame beside = shifted({35, 20, 5});
    const SolidMesh first = part_surface(large, 1, front), second = part_surface(large, 1, beside);
    Random random(73);
    int both = 0;
    constexpr int tries = 1500;
    const Vec3 low = test::lowest(second), size = test::highest(second) - low;
    for (int i = 0; i < tries; ++i) {
        const Vec3 p =
            low + Vec3{random.uniform() * size.x, random.uniform() * size.y, random.uniform() * size.z};
        both += test::holds(first, p) && test::holds(second, p);
    }
    const double shared = size.x * size.y * size.z * both / tries;
    CHECK(test::volume_of(unite({{&large, 1, front}, {&large, 1, beside}})) ==
          Approx(2 * volume - shared).epsilon(0.02));
}

TEST_CASE("the united surface of one part is that part's own") {
    Random random(74);
    for (int round = 0; round < 6; ++round) {
        const Inflation inflation = inflate(test::blob(random, 2 + round % 4, 0.3));
        const SolidMesh exact = part_surface(inflation, 1, front), mesh = unite({{&inflation, 1, front}});
        CAPTURE(round);
        CHECK(test::surface_fault(mesh) == "");
        CHECK(test::surface_distance(mesh, exact).largest < 0.05); // of a size of 200
        CHECK(test::volume_of(mesh) == Approx(test::volume_of(exact)).epsilon(1e-3));
    }
}

TEST_CASE("random solids are united to closed surfaces that do not cut themselves") {
    Random random(75);
    for (int round = 0; round < 12; ++round) {
        std::vector<Inflation> inflations;
        const int count = random.integer(2, 5);
        for (int i = 0; i < count; ++i)
            inflations.push_back(inflate(
                test::blob(random, random.integer(2, 6), random.uniform(0.1, 0.5), random.uniform(20, 80))));
        std::vector<InflatedPart> parts;
        for (const Inflation& inflation : inflations) {
            const auto place = [&] { return random.uniform(-60, 60); };
            Frame frame = shifted({place(), place(), place()});
            if (random.chance(0.5)) frame = {frame.origin, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}};
            parts.push_back({&inflation, random.uniform(0.3, 1.5), frame});
        }
        const SolidMesh mesh = unite(parts);
        CAPTURE(round);
        CHECK(test::surface_fault(mesh) == "");
        CHECK(test::volume_of(mesh) > 0);
        CHECK(test::self_cuts(mesh) == 0);
    }
}

TEST_CASE("parts that touch stay apart, parts that overlap a little are joined") {
    const std::vector<Point2d> square = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    const Inflation one = inflate(square);
    const SolidMesh touching = unite({{&one, 1, front}, {&one, 1, shifted({100, 0, 0})}});
    CHECK(test::components_of(touching) == 2);
    CHECK(test::surface_fault(touching) == "");
    const SolidMesh joined = unite({{&one, 1, front}, {&one, 1, shifted({99.9, 0, 0})}});
    CHECK(test::components_of(joined) == 1);
    CHECK(test::surface_fault(joined) == "");
    CHECK(test::genus_of(joined) == 0);
}

TEST_CASE("what parts enclose is filled") {
    // Six plates around a hollow.
    const Inflation plate = inflate({{-60, -60}, {60, -60}, {60, 60}, {-60, 60}});
    std::vector<InflatedPart> box;
    for (const double side : {-1.0, 1.0}) {
        box.push_back({&plate, 0.3, {{0, 0, 50 * side}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}}});
        box.push_back({&plate, 0.3, {{0, 50 * side, 0}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}}});
        box.push_back({&plate, 0.3, {{50 * side, 0, 0}, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}}});
    }
    const SolidMesh mesh = unite(box);
    CHECK(test::surface_fault(mesh) == "");
    CHECK(test::components_of(mesh) == 1);
    CHECK(test::genus_of(mesh) == 0);
    CHECK(test::holds(mesh, {0, 0, 0}));
}

TEST_CASE("a part that is nothing beside the model is an input error") {
    const Inflation ball = inflate(test::disc({0, 0}, 1));
    CHECK(unite({}).triangles.empty());
    const SolidMesh flat = unite({{&ball, 1e-3, front}});
    CHECK(test::surface_fault(flat) == "");
    CHECK(test::highest(flat).z == Approx(1e-3 / std::sqrt(2)).epsilon(0.02));
    CHECK_THROWS_AS(unite({{&ball, 1, front}, {&ball, 1, shifted({1e9, 0, 0})}}), Error);
}
