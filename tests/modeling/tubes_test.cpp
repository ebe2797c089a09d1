// SPDX-License-Identifier: MIT
// Open strokes of some width: tubes.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math.hpp"
#include "geometry/extent.hpp"
#include "modeling/solids.hpp"
#include "pantin/model.hpp"
#include "pantin/strokes.hpp"

using namespace pantin;

namespace {

Strokes read(const std::string& part) {
    return strokes_from_json("{\"parts\": [{\"name\": \"tail\", " + part + "}]}", "f.json");
}
const PartStroke& part_of(const Strokes& strokes) { return std::get<PartStroke>(strokes.calls.at(0)); }

} // namespace

TEST_CASE("an open stroke with a width is as long and as wide as it says, with round ends") {
    const Strokes strokes = read(R"("stroke": [[0, 0], [100, 0]], "closed": false, "width": 20)");
    CHECK(std::abs(area_of(part_of(strokes).stroke)) == Approx(2000 + 100 * math::pi).epsilon(0.01));
    const std::string text = strokes_to_json(strokes);
    CHECK(strokes_to_json(strokes_from_json(text, "f.json")) == text);
    Model model(strokes);
    const SolidMesh mesh = model.united();
    CHECK(test::surface_fault(mesh).empty());
    const Vec3 size = test::highest(mesh) - test::lowest(mesh);
    CHECK(size.x == Approx(120).margin(1));
    CHECK(size.y == Approx(20).margin(1));
    CHECK(size.z == Approx(20).margin(2)); // round
}

TEST_CASE("a bent tube has its axis along the stroke") {
    const Strokes strokes =
        read(R"("stroke": [[0, 0], [60, 40], [120, 0], [180, 40]], "closed": false, "width": 12)");
    Model model(strokes);
    CHECK(test::genus_of(model.united()) == 0);
    CHECK(model.parts()[0].flat.branches.size() == 1);
    for (const auto& joint : model.parts()[0].flat.joints) {
        const double x = joint.place.x, phase = std::abs(std::fmod(x + 240, 120.0) - 60);
        CHECK(std::abs(joint.place.y - (40 - phase * 40 / 60)) < 6); // half the width
    }
}

TEST_CASE("a bad open stroke is an error that says what it needs") {
    CHECK_THROWS_WITH(read(R"("stroke": [[0, 0], [9, 0]], "closed": false)"),
                      "f.json: part 'tail': an open stroke needs a `width`");
    CHECK_THROWS_WITH(read(R"("stroke": [[0, 0], [9, 0], [9, 9]], "width": 3)"),
                      "f.json: part 'tail': only an open stroke (`closed`: false) has a width");
    CHECK_THROWS_WITH(read(R"("stroke": [[5, 5], [5, 5]], "closed": false, "width": 3)"),
                      "f.json: part 'tail': an open stroke needs at least two points");
    CHECK_THROWS_WITH(read(R"("stroke": [[0, 0], [9, 0]], "closed": false, "width": 0)"),
                      "f.json: part 'tail': width must be greater than 0");
}
