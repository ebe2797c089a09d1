// SPDX-License-Identifier: MIT
// Holes of parts: one handle each, and a skeleton that goes around them without closing.
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "modeling/solids.hpp"
#include "pantin/model.hpp"
#include "pantin/strokes.hpp"

using namespace pantin;

namespace {

using Line = std::vector<Point2d>;

Line box(Point2d low, Point2d high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

Line star(double radius) {
    Line line;
    for (int i = 0; i < 10; ++i) {
        const double angle = math::pi * i / 5;
        line.push_back((i % 2 == 0 ? radius : 0.55 * radius) * Point2d{math::cos(angle), math::sin(angle)});
    }
    return line;
}

struct Holed {
    std::string name;
    Line border;
    std::vector<Line> holes;
};

std::vector<Holed> drawings() {
    return {{"ring", test::disc({0, 0}, 100), {test::disc({0, 0}, 60)}},
            {"off the middle", test::disc({0, 0}, 100), {test::disc({30, 10}, 50)}},
            {"pin hole", test::disc({0, 0}, 100), {test::disc({0, 0}, 4)}},
            {"frame", box({0, 0}, {200, 120}), {box({30, 30}, {170, 90})}},
            {"thin frame", box({0, 0}, {200, 120}), {box({3, 3}, {197, 117})}},
            {"two windows", box({0, 0}, {200, 120}), {box({20, 30}, {90, 90}), box({110, 30}, {180, 90})}},
            {"star in a star", star(100), {star(45)}},
            {"crescent", test::disc({0, 0}, 100), {test::disc({0, 28}, 70)}}};
}

PartStroke part_of(const Holed& drawing) {
    PartStroke part = test::part("part", drawing.border);
    part.holes = drawing.holes;
    return part;
}

} // namespace

TEST_CASE("a part with holes has a handle for each, its joints and bones are in the solid") {
    for (const bool printed : {false, true})
        for (const Holed& drawing : drawings()) {
            CAPTURE(drawing.name, printed);
            ModelOptions options;
            options.skeleton.printed_axis = printed;
            Model model(Point2d{}, options);
            model.add_part(part_of(drawing));
            CHECK(model.repairs().empty());
            const SolidMesh mesh = model.united();
            CHECK(test::surface_fault(mesh).empty());
            CHECK(test::genus_of(mesh) == static_cast<int>(drawing.holes.size()));
            CHECK(test::components_of(mesh) == 1);
            const auto& joints = model.skeleton().joints;
            CHECK(joints.size() >= 2);
            for (const auto& joint : joints) {
                CHECK(test::winding_of(mesh, joint.place) > 0.5);
                if (joint.parent < 0) continue;
                const Vec3 parent = joints[joint.parent].place;
                for (const double t : {0.25, 0.5, 0.75})
                    CHECK(test::winding_of(mesh, joint.place + t * (parent - joint.place)) > 0.5);
            }
        }
}

TEST_CASE("the skeleton of a ring goes around it, but for a gap where it is thinnest") {
    Model model;
    model.add_part(part_of({"", test::disc({0, 0}, 100), {test::disc({20, 0}, 60)}}));
    const auto& joints = model.skeleton().joints;
    double around = 0;
    for (const auto& joint : joints)
        if (joint.parent >= 0) {
            const Vec3 a = joints[joint.parent].place, b = joint.place;
            around += std::abs(math::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
        }
    CHECK(around > 0.75 * 2 * math::pi);
    CHECK(around < 2 * math::pi);
    for (const auto& joint : joints) CHECK_FALSE((joint.place.x > 80 && std::abs(joint.place.y) < 2));
}

TEST_CASE("holes that are not apart are left out, with a line") {
    for (const Line& hole : {test::disc({90, 0}, 30), test::disc({300, 0}, 30), test::disc({10, 0}, 30)}) {
        PartStroke part = test::part("part", test::disc({0, 0}, 100));
        part.holes = {test::disc({0, 0}, 20), hole};
        Model model;
        model.add_part(part);
        CHECK(model.repairs() ==
              std::vector<std::string>{
                  "part 'part': 1 hole left out, not inside it or too near to another border"});
        CHECK(test::genus_of(model.united()) == 1);
    }
}

TEST_CASE("a stroke that is a hole is one of the latest part around it") {
    const std::string ring = R"([[0, 0], [100, 0], [100, 100], [0, 100]])",
                      hole = R"([[40, 40], [60, 40], [60, 60], [40, 60]])";
    const auto read = [](const std::string& parts) {
        return strokes_from_json("{\"parts\": [" + parts + "]}", "f.json");
    };
    const std::string body = "{\"name\": \"body\", \"stroke\": " + ring + "}",
                      window = "{\"name\": \"window\", \"hole\": true, \"stroke\": " + hole + "}";
    const Strokes strokes = read(body + ", " + window);
    REQUIRE(strokes.calls.size() == 1);
    CHECK(std::get<PartStroke>(strokes.calls[0]).holes ==
          std::vector<Line>{{{40, 40}, {60, 40}, {60, 60}, {40, 60}}});
    const std::string text = strokes_to_json(strokes);
    CHECK(strokes_to_json(strokes_from_json(text, "f.json")) == text);
    CHECK_THROWS_WITH(read(window + ", " + body), "f.json: hole 'window': lies in no part before it");
    CHECK_THROWS_WITH(
        strokes_from_json("{\"parts\": [" + body + "], \"calls\": [{\"add_part\": " + window + "}]}",
                          "f.json"),
        "f.json: part 'window': a hole stands among `parts`, or in the `holes` of its part");
}
