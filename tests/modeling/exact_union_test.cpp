// SPDX-License-Identifier: MIT
// Our union beside CGAL's. `pantin-tests '[exact-union]'` prints the table of
// docs/modeling.md.
#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>

#include "modeling/cgal/unite_exactly.hpp"
#include "modeling/solids.hpp"
#include "modeling/surface_distance.hpp"
#include "pantin/error.hpp"

using namespace pantin;

namespace {

double height_of(const SolidMesh& mesh) { return test::highest(mesh).y - test::lowest(mesh).y; }

Frame shifted(Vec3 by) {
    Frame frame;
    frame.origin = by;
    return frame;
}

double seconds(const std::chrono::steady_clock::time_point& since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

} // namespace

TEST_CASE("distances between surfaces are those of spheres one in another") {
    const Inflation ball = inflate(test::disc({0, 0}, 50));
    const SolidMesh mesh = part_surface(ball, 1, Frame{});
    CHECK(test::surface_distance(mesh, mesh).largest == Approx(0).margin(1e-9));
    const test::SurfaceDistance moved =
        test::surface_distance(mesh, part_surface(ball, 1, shifted({200, 0, 0})));
    CHECK(moved.largest == Approx(200).epsilon(0.01));
    CHECK(moved.mean > 100);
    const test::NearestOnSurface nearest(mesh);
    CHECK(nearest.distance_of({70, 0, 0}) == Approx(20).epsilon(0.01));
    CHECK(nearest.distance_of({0, 0, 0}) == Approx(50 / std::sqrt(2)).epsilon(0.02));
}

TEST_CASE("a build without CGAL says so") {
    if (exact_union_available()) return;
    try {
        unite_exactly({});
        FAIL();
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::usage);
    }
}

TEST_CASE("exact unions follow the rule of sums exactly", "[needs-cgal]") {
    const Inflation large = inflate(test::disc({0, 0}, 50)), small = inflate(test::disc({0, 0}, 20));
    const double volume = test::volume_of(part_surface(large, 1, Frame{})),
                 less = test::volume_of(part_surface(small, 1, Frame{}));
    const SolidMesh apart = unite_exactly({{&large, 1, Frame{}}, {&small, 1, shifted({90, 10, 0})}});
    CHECK(test::volume_of(apart) == Approx(volume + less).epsilon(1e-9));
    CHECK(test::components_of(apart) == 2);
    const SolidMesh within = unite_exactly({{&large, 1, Frame{}}, {&small, 1, shifted({6, -3, 2})}});
    CHECK(test::volume_of(within) == Approx(volume).epsilon(1e-9));
    CHECK(test::components_of(within) == 1);
    CHECK(test::volume_of(unite_exactly({{&large, 1, Frame{}}, {&large, 1, Frame{}}})) ==
          Approx(volume).epsilon(1e-9));
    CHECK(unite_exactly({}).triangles.empty());
}

TEST_CASE("our union is the one of CGAL", "[needs-cgal]") {
    Model model(test::model_strokes("deer"));
    const SolidMesh ours = model.united(), exact = unite_exactly(model.inflated());
    CHECK(test::surface_fault(exact) == "");
    CHECK(test::components_of(exact) == 1);
    CHECK(test::self_cuts(exact) == 0);
    CHECK(test::volume_of(ours) == Approx(test::volume_of(exact)).epsilon(0.002));
    const test::SurfaceDistance distance = test::surface_distance(ours, exact);
    CHECK(distance.mean < 0.0002 * height_of(exact));
    CHECK(distance.largest < 0.002 * height_of(exact));
}

TEST_CASE("table of the nine models: our union beside CGAL's", "[.][exact-union][needs-cgal]") {
    std::printf("| model | volume, relative | mean distance | largest | triangles | time "
                "|\n|---|---|---|---|---|---|\n");
    for (const std::string& name : test::model_names) {
        Model model(test::model_strokes(name));
        model.inflated();
        const auto start = std::chrono::steady_clock::now();
        const SolidMesh ours = model.united();
        const double our_time = seconds(start);
        const auto then = std::chrono::steady_clock::now();
        const SolidMesh exact = unite_exactly(model.inflated());
        const double time = seconds(then);
        const test::SurfaceDistance d = test::surface_distance(ours, exact);
        CHECK(test::surface_fault(exact) == "");
        CHECK(test::self_cuts(exact) == 0);
        CHECK(d.largest < 0.002 * height_of(exact));
        std::printf("| %s | %+.2f %% | %.2f %% | %.2f %% | %zu / %zu | %.2f / %.2f s |\n", name.c_str(),
                    100 * (test::volume_of(ours) / test::volume_of(exact) - 1),
                    100 * d.mean / height_of(exact), 100 * d.largest / height_of(exact),
                    ours.triangles.size(), exact.triangles.size(), our_time, time);
    }
}
