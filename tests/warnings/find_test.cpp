// SPDX-License-Identifier: MIT
// All warnings of a character: none of one that is as it should be, and what is said of one that is not.
#include <catch2/catch.hpp>

#include <set>

#include "pantin/image.hpp"
#include "pantin/warnings.hpp"
#include "warnings/figures.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// The outlines of the labels' parts, black on white.
RgbImage outlines_of(const LabelMap& labels) {
    RgbImage drawing(labels.width(), labels.height(), {255, 255, 255});
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) != 0 && (labels.value_or(x - 1, y, 0) != labels(x, y) ||
                                      labels.value_or(x, y - 1, 0) != labels(x, y)))
                drawing(x, y) = {0, 0, 0};
    return drawing;
}

Candidate candidate(const std::string& reference, double score) {
    Candidate c;
    c.reference = reference;
    c.score = score;
    c.evidence = {{"graph", score}};
    return c;
}

// The table of the rigging tests, as a sure quadruped, in its walk.
struct Table {
    tests::Character character = tests::table();
    LabelMap labels = character.labels;
    RgbImage drawing = outlines_of(labels);
    Mask mask = foreground(labels);
    std::vector<ReferenceSkeleton> references = load_references();
    Identification identification;
    Rig rig = tests::rig_of(character);
    BoneAnimation walk = retarget(rig, character.reference, character.reference.clips[0]);
    View view = view_of(rig, {walk});
    bool mask_given = false, reference_given = false;

    Table() {
        identification.reference = identification.type = "quadruped";
        identification.confidence = 0.9;
        identification.candidates = {candidate("quadruped", 1), candidate("bird", 2), candidate("flying", 3),
                                     candidate("humanoid", 4)};
    }
    std::vector<Warning> found() const {
        return find_warnings({drawing,
                              mask,
                              labels,
                              identification,
                              references,
                              character.reference,
                              rig,
                              {{walk, view}},
                              mask_given,
                              reference_given});
    }
};

} // namespace

TEST_CASE("The table has its rows in the order of the kinds, each with a name of its own", "[warnings]") {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < warning_table.size(); ++i) {
        CHECK(static_cast<std::size_t>(warning_table[i].kind) == i);
        CHECK(names.insert(warning_table[i].name).second);
    }
}

TEST_CASE("A character that is as it should be has no warnings", "[warnings]") {
    CHECK(Table().found().empty());
}

TEST_CASE("An unsure type names the next one that stands on its own", "[warnings]") {
    Table table;
    table.identification.confidence = 0.4;
    const std::vector<Warning> found = table.found();
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == WarningKind::unsure_type);
    CHECK(found[0].value == 0.4);
    CHECK(found[0].text ==
          "identified as quadruped with a confidence of 40 %; --reference flying is the next choice");
    table.reference_given = true;
    CHECK(table.found().empty());
    table.reference_given = false;
    table.identification.reference = table.identification.type = "humanoid"; // by hand, in the file
    CHECK(table.found().empty());
    CHECK(second_type(table.identification, table.references).empty());
}

TEST_CASE("A distance that is not proven smallest is marked where it decides", "[warnings]") {
    Table table;
    for (Candidate& c : table.identification.candidates) c.evidence.clear();
    CHECK(table.found().empty());
    table.identification.candidates[1].optimal = table.identification.candidates[3].optimal = false;
    CHECK(unproven_distance(table.identification) == 0.5);
    const std::vector<Warning> found = table.found();
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == WarningKind::unproven_distance);
    CHECK(found[0].value == 0.5);
    CHECK(found[0].text.find("the graph distance to bird, humanoid is") == 0);
    CHECK(found[0].text == unproven_line(table.identification));
    table.identification.candidates[0].evidence = {{"graph", 1}}; // one part of several
    CHECK(table.found().empty());
    CHECK(unproven_line(table.identification).empty());
    CHECK(unproven_distance({}) == 0);
}

TEST_CASE("A bird's next type is none that it is like, and a fish's type is not a matter of confidence",
          "[warnings]") {
    const std::vector<ReferenceSkeleton> references = load_references();
    Identification bird;
    bird.reference = "bird", bird.type = "flying";
    bird.candidates = {candidate("bird", 1), candidate("flying", 2), candidate("humanoid", 3)};
    CHECK(second_type(bird, references) == "humanoid");
    // Its needs may decide for it although what it is like is not the best of those that stand on their own.
    std::swap(bird.candidates[1], bird.candidates[2]);
    CHECK(second_type(bird, references) == "humanoid");
    Identification fish = bird;
    fish.reference = fish.type = "fish";
    fish.candidates.insert(fish.candidates.begin(), candidate("fish", 0));
    CHECK(second_type(fish, references).empty());
    Identification plain = bird; // without evidence the confidence is no probability
    for (Candidate& c : plain.candidates) c.evidence.clear();
    CHECK(second_type(plain, references).empty());
}

TEST_CASE("Several warnings come in the order of the table, with values and words", "[warnings]") {
    Table table;
    table.identification.confidence = 0.3;
    table.view = {-5, -5, 10, 10};
    table.mask_given = true;
    for (int y = 0; y < 24; ++y) // a hat that the user's mask has and the silhouette has not
        for (int x = 20; x < 60; ++x) table.mask(x, y) = 1, table.drawing(x, y) = {0, 0, 0};
    const std::vector<Warning> found = table.found();
    REQUIRE(found.size() == 4);
    CHECK(found[0].kind == WarningKind::lost_ink);
    CHECK(found[0].text.ends_with(" % of the ink lies outside of the silhouette and is not in the films"));
    CHECK(found[1].kind == WarningKind::lost_mask);
    CHECK(found[1].text.starts_with("the silhouette leaves out "));
    CHECK(found[2].kind == WarningKind::small_figure);
    CHECK(found[2].text == "walk: the figure takes 12 % of the frame's longer side");
    CHECK(found[3].kind == WarningKind::unsure_type);
    for (const Warning& warning : found) CHECK(is_marked(warning.kind, warning.value));
}

TEST_CASE("Legs are judged in clips that step alone", "[warnings]") {
    Table table;
    for (auto& rotations : table.walk.rotations) // nothing moves
        for (Quaternion& rotation : rotations) rotation = {};
    const std::vector<Warning> found = table.found();
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == WarningKind::still_limbs);
    CHECK(found[0].text == "walk: 100 % of the limbs hardly move");
    table.walk.name = "idle";
    CHECK(table.found().empty());
}
