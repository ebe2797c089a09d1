// SPDX-License-Identifier: MIT
// Calls that take back, draw anew and change a part that stands.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "modeling/solids.hpp"
#include "pantin/error.hpp"
#include "pantin/model.hpp"

using namespace pantin;

namespace {

bool same(const Model& a, const Model& b) {
    const auto &p = a.skeleton().joints, &q = b.skeleton().joints;
    return a.calls() == b.calls() &&
           std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const auto& i, const auto& j) {
               return i.place == j.place && i.radius == j.radius && i.part == j.part && i.parent == j.parent;
           });
}

Model body_and_arm() {
    Model model;
    model.add_part(test::part("body", test::capsule({0, -50}, {0, 50}, 25)));
    model.add_part(test::part("arm", test::capsule({0, 0}, {100, 0}, 10)));
    model.add_part(test::part("hand", test::disc({110, 0}, 16)));
    return model;
}

double thickness(Model& model, int part) {
    const SolidMesh mesh = model.surface(part);
    return test::highest(mesh).z - test::lowest(mesh).z;
}

} // namespace

TEST_CASE("undo takes every call back, the last one first") {
    Model model = body_and_arm();
    std::vector<Model> before;
    RefineSkeleton refine;
    refine.prune = 0.2;
    const std::vector<ModelCall> calls = {MovePart{"arm", {0, 10, 5}, 'z', 20, 1.2},
                                          SetSymmetry{"arm", Symmetry::x},
                                          refine,
                                          SetHeight{"body", 0.5},
                                          RedrawPart{"arm", test::capsule({0, 0}, {60, 40}, 8)},
                                          RemovePart{"hand"}};
    for (const ModelCall& call : calls) {
        before.push_back(model);
        model.apply(call);
        CHECK_FALSE(same(model, before.back()));
    }
    CHECK_THROWS_AS(model.remove_part("hand"), Error); // what fails is no call to take back
    for (; !before.empty(); before.pop_back()) {
        CHECK(model.undo());
        CHECK(same(model, before.back()));
        CHECK(model.united().triangles == before.back().united().triangles);
    }
    for (int part = 0; part < 3; ++part) CHECK(model.undo());
    CHECK(model.parts().empty());
    CHECK_FALSE(model.undo());
}

TEST_CASE("a part that is drawn anew keeps its place, its parent, its children and its moves") {
    Model model = body_and_arm();
    model.move_part({"arm", {0, 0, 4}});
    const RedrawPart redraw{"arm", test::capsule({5, 5}, {105, -5}, 14)};
    model.redraw_part(redraw);
    Model other;
    other.add_part(test::part("body", test::capsule({0, -50}, {0, 50}, 25)));
    other.add_part(test::part("arm", redraw.stroke));
    other.add_part(test::part("hand", test::disc({110, 0}, 16)));
    other.move_part({"arm", {0, 0, 4}});
    REQUIRE(model.parts().size() == 3);
    for (int p = 0; p < 3; ++p) {
        CHECK(model.parts()[p].name() == other.parts()[p].name());
        CHECK(model.parts()[p].parent == p - 1);
        CHECK(model.parts()[p].frame.origin == other.parts()[p].frame.origin);
    }
    CHECK(model.united().vertices == other.united().vertices);
    CHECK_THROWS_AS(model.redraw_part({"arm", {{0, 0}, {1, 1}, {2, 2}}}), Error);
    CHECK(model.united().vertices == other.united().vertices);
}

TEST_CASE("a part's height can be changed afterwards") {
    Model model = body_and_arm();
    const double thick = thickness(model, 0);
    model.set_height("body", 2);
    CHECK(thickness(model, 0) == Approx(2 * thick));
    CHECK_THROWS_AS(model.set_height("body", 0), Error);
    CHECK_THROWS_AS(model.set_height("nobody", 1), Error);
}

TEST_CASE("a part of a higher layer lies on the surface of what is below it") {
    for (const int layer : {-1, 1}) {
        Model model;
        model.add_part(test::part("head", test::disc({0, 0}, 100)));
        const double half = thickness(model, 0) / 2;
        PartStroke eye = test::part("eye", test::disc({0, 0}, 8));
        eye.layer = layer;
        model.add_part(eye);
        CHECK(model.parts()[1].frame.origin.z == Approx(layer * half).epsilon(0.01));
        CHECK(model.parts()[1].parent == 0);
        PartStroke pupil = test::part("pupil", test::disc({2, 0}, 3));
        pupil.layer = 2 * layer;
        model.add_part(pupil);
        CHECK(layer * model.parts()[2].frame.origin.z > layer * model.parts()[1].frame.origin.z + 4);
        CHECK(oddities_of(model, model.united()).empty()); // all of it is seen
        PartStroke beside = test::part("beside", test::disc({300, 0}, 20));
        beside.layer = layer;
        model.add_part(beside);
        CHECK(model.parts()[3].frame.origin.z == 0);
    }
}

TEST_CASE("a part without bones moves with what it hangs on") {
    Model model = body_and_arm();
    PartStroke eye = test::part("eye", test::disc({0, -50}, 6));
    eye.bones = false;
    model.add_part(eye);
    PartStroke lash = test::part("lash", test::capsule({0, -50}, {0, -95}, 2), "eye");
    model.add_part(lash);
    CHECK(model.parts()[3].parent == 0);
    int roots = 0;
    bool lash_has_bones = false;
    for (const auto& joint : model.skeleton().joints) {
        CHECK(joint.part != 3);
        roots += joint.parent < 0;
        lash_has_bones = lash_has_bones || joint.part == 4;
    }
    CHECK(roots == 1);
    CHECK(lash_has_bones);
    PartStroke stone = test::part("stone", test::disc({500, 0}, 20));
    stone.bones = false;
    model.add_part(stone); // hangs on nothing
    CHECK(model.skeleton().joints.back().part == 5);
}

TEST_CASE("parts that meet nothing and parts that nobody sees are said") {
    Model model;
    model.add_part(test::part("car", test::capsule({0, 0}, {100, 0}, 30)));
    model.add_part(test::part("wheel", test::disc({20, 80}, 10)));
    model.add_part(test::part("engine", test::disc({20, 0}, 8)));
    model.add_part(test::part("spare", test::disc({80, 80}, 10)));
    CHECK(oddities_of(model, model.united()) ==
          std::vector<std::string>{
              "2 parts meet no part before them and have skeletons of their own: 'wheel', 'spare'",
              "1 part lies wholly inside others and is not seen: 'engine'"});
}

TEST_CASE("a smaller load of Poisson's equation makes a part thinner by its root") {
    const auto thick = [](double load) {
        ModelOptions options;
        options.inflation.load = load;
        Model model(Point2d{}, options);
        model.add_part(test::part("p", test::disc({0, 0}, 100)));
        return thickness(model, 0);
    };
    CHECK(thick(1) == Approx(thick(2) / std::sqrt(2.0)));
}

TEST_CASE("calls of a file take back, draw anew and change parts as those of the model do") {
    const std::string parts = R"({"name": "a", "stroke": [[0, 0], [90, 0], [90, 90]]},
                                 {"name": "b", "stroke": [[50, 0], [70, 0], [70, 200]], "layer": -2, "bones": false})";
    const auto read = [&](const std::string& calls) {
        return strokes_from_json("{\"parts\": [" + parts + "], \"calls\": [" + calls + "]}", "f.json");
    };
    const Strokes strokes = read(R"({"set_height": {"part": "b", "height": 3}}, {"remove_part": "a"},
                                    {"undo": 1}, {"set_symmetry": {"part": "a", "symmetric": "z"}},
                                    {"remove_part": "b"}, {"undo": 2},
                                    {"redraw_part": {"part": "a", "stroke": [[0, 0], [80, 0], [80, 80]],
                                                     "holes": [[[60, 10], [70, 10], [70, 20]]]}})");
    REQUIRE(strokes.calls.size() == 4);
    CHECK(std::get<PartStroke>(strokes.calls[1]).layer == -2);
    CHECK_FALSE(std::get<PartStroke>(strokes.calls[1]).bones);
    CHECK(std::get<SetHeight>(strokes.calls[2]) == SetHeight{"b", 3});
    const auto& redraw = std::get<RedrawPart>(strokes.calls[3]);
    CHECK(redraw == RedrawPart{"a", {{0, 0}, {80, 0}, {80, 80}}, {{{60, 10}, {70, 10}, {70, 20}}}});
    const std::string text = strokes_to_json(strokes);
    const Strokes again = strokes_from_json(text, "f.json");
    CHECK(again.calls == strokes.calls);
    CHECK(strokes_to_json(again) == text);
    const Strokes more = with_calls(strokes, R"({"calls": [{"undo": 2}, {"remove_part": "b"}]})", "g.json");
    CHECK(more.calls.size() == 3);
    CHECK_THROWS_WITH(read(R"({"undo": 3})"),
                      Catch::Matchers::Contains("there are not so many calls to take back"));
    CHECK_THROWS_WITH(read(R"({"undo": 1}, {"set_height": {"part": "b", "height": 3}})"),
                      Catch::Matchers::Contains("there is no part 'b' here"));
}
