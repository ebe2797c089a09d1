// SPDX-License-Identifier: MIT
// Thin parts: none is lost, each in one piece with what it touches, and as thin as it was drawn.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "core/random.hpp"
#include "modeling/solids.hpp"
#include "pantin/model.hpp"

using namespace pantin;

namespace {

constexpr double model_side = 400; // about, of the models below

std::vector<Point2d> strip(Point2d a, Point2d b, double width) {
    const Point2d u = (0.5 * width / distance(a, b)) * (b - a), v = {-u.y, u.x};
    return {a + v, b + v, b - 1 * v, a - 1 * v};
}

Point2d direction(double angle) { return {math::cos(angle), math::sin(angle)}; }

// Share of the samples of a part's bones that lie inside of the surface.
double share_inside(const Model& model, const SolidMesh& mesh, int part) {
    const ModelPart& p = model.parts()[part];
    int inside = 0, all = 0;
    for (const auto& [from, to] : p.flat.bones)
        for (int i = 0; i <= 6; ++i) {
            const Point2d a = p.flat.joints[from].place, b = p.flat.joints[to].place;
            inside += test::holds(mesh, to_model(p.frame, a + (i / 6.0) * (b - a)));
            ++all;
        }
    return all > 0 ? static_cast<double>(inside) / all : 0;
}

void check_whole(const SolidMesh& mesh, int pieces = 1) {
    CHECK(test::surface_fault(mesh) == "");
    CHECK(test::components_of(mesh) == pieces);
    CHECK(test::volume_of(mesh) > 0);
}

PartStroke body() { return test::part("body", test::disc({0, 0}, 100)); }

} // namespace

TEST_CASE("a thin part at any angle keeps its axis and hangs on the body") {
    Random random(91);
    for (int round = 0; round < 24; ++round) {
        const double width = model_side * 0.002 * std::pow(25, random.uniform()); // 0.2 to 5 %
        const Point2d way = direction(random.uniform(0, 2 * math::pi));
        const double length = random.uniform(120, 300);
        Model model;
        model.add_part(body());
        model.add_part(test::part("leg", strip(80 * way, (100 + length) * way, width)));
        if (round % 2 == 1) { // out of the plane, about where it hangs
            MovePart turn;
            turn.part = "leg";
            turn.axis = round % 4 == 1 ? 'y' : 'x';
            turn.degrees = random.uniform(-20, 20);
            model.move_part(turn);
        }
        const SolidMesh mesh = model.united();
        CAPTURE(round, width, way.x, way.y, length);
        CHECK(share_inside(model, mesh, 1) == 1);
        check_whole(mesh);
        CHECK(mesh.triangles.size() < 200'000);
        if (round % 8 == 0) CHECK(test::self_cuts(mesh) == 0);
    }
}

TEST_CASE("a thin tail of a thick stroke, a needle and a speck are there") {
    Model tail;
    tail.add_part(test::part(
        "body", {{0, 0}, {200, -10}, {230, 30}, {420, 60}, {420, 61.5}, {225, 45}, {190, 80}, {10, 70}}));
    const SolidMesh whole = tail.united();
    check_whole(whole);
    CHECK(share_inside(tail, whole, 0) == 1);
    CHECK(test::highest(whole).x > 405);

    Model needle; // whose sub-skeleton is hardly more than a point
    needle.add_part(body());
    needle.add_part(test::part("horn", {{60, -1}, {300, 0}, {60, 1}}));
    needle.add_part(test::part("eye", test::disc({0, 150}, 0.5)));
    const SolidMesh pointed = needle.united();
    check_whole(pointed, 2);
    for (double x = 60; x < 290; x += 5) CHECK(test::holds(pointed, {x, 0, 0}));
    CHECK(test::holds(pointed, {0, -150, 0}));
    CHECK(test::highest(pointed).x < 305); // and not longer than it was drawn
}

TEST_CASE("a figure of lines is one piece, as thin as it was drawn") {
    for (const double width : {0.5, 1.0, 3.0}) {
        Model model;
        model.add_part(test::part("head", test::disc({100, 40}, 22)));
        model.add_part(test::part("body", strip({100, 58}, {100, 150}, width)));
        model.add_part(test::part("arm_left", strip({100, 85}, {40, 110}, width)));
        model.add_part(test::part("arm_right", strip({100, 85}, {160, 110}, width)));
        model.add_part(test::part("leg_left", strip({100, 149}, {60, 240}, width)));
        model.add_part(test::part("leg_right", strip({100, 149}, {140, 240}, width)));
        const SolidMesh mesh = model.united();
        CAPTURE(width);
        check_whole(mesh);
        for (int part = 1; part < 6; ++part) CHECK(share_inside(model, mesh, part) == 1);
        CHECK(test::highest(mesh).x - test::lowest(mesh).x < 125 + 4 * width);
    }
}

TEST_CASE("a part as flat as paper reaches to its rim") {
    for (const double height : {1e-4, 0.01, 0.03}) {
        PartStroke wing = test::part("wing", strip({60, 0}, {300, 90}, 80));
        wing.height = height;
        Model model;
        model.add_part(body());
        model.add_part(wing);
        const SolidMesh mesh = model.united();
        CAPTURE(height);
        check_whole(mesh);
        CHECK(share_inside(model, mesh, 1) == 1);
        // To its rim, and no farther.
        const Point2d along = (1 / distance(Point2d{60, 0}, Point2d{300, 90})) * Point2d{240, 90},
                      across{-along.y, along.x};
        for (double t = 120; t < 245; t += 12)
            for (const double side : {-36.0, 0.0, 36.0}) {
                const Point2d p = Point2d{60, 0} + t * along + side * across;
                CHECK(test::holds(mesh, {p.x, -p.y, 0}));
                const Point2d beyond = p + (side / 36 * 8) * across;
                if (side != 0) CHECK_FALSE(test::holds(mesh, {beyond.x, -beyond.y, 0}));
            }
    }
}

TEST_CASE("parts that do not touch stay apart, however thin they are") {
    Model model;
    model.add_part(body());
    PartStroke leg = test::part("leg", strip({160, 0}, {360, 20}, 1));
    leg.parent = "body";
    model.add_part(leg);
    const SolidMesh mesh = model.united();
    check_whole(mesh, 2);
    CHECK(share_inside(model, mesh, 1) == 1);
}
