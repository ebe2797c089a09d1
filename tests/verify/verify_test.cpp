// SPDX-License-Identifier: MIT
// The stages against the stored results: they agree, and a change in a stage is seen in that stage.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/json.hpp"
#include "core/resources.hpp"
#include "export/rigs.hpp"
#include "formats/file_names.hpp"
#include "formats/skeleton_file.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"
#include "pantin/verify.hpp"
#include "support/folders.hpp"
#include "verify/stage.hpp"
#include "verify/step_files.hpp"
#include "verify/vectors.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// "<stage>/<drawing>" of all that differ.
std::set<std::string> differing(const Verification& verification) {
    std::set<std::string> all;
    for (const StageDifferences& result : verification.results)
        if (!result.files.empty()) all.insert(result.stage + "/" + result.drawing);
    return all;
}

// The stored files of a preset are the inputs and what the stages make, nothing else.
void check_files(const Verification& verification, const std::string& preset) {
    Files stored = stored_vectors();
    stored.erase("README.md");
    std::erase_if(
        stored, [&](const auto& file) { return file.first.starts_with("thesis/") != (preset == "thesis"); });
    CHECK(verification.outputs.size() == stored.size());
    for (const auto& [name, bytes] : stored) {
        CAPTURE(name);
        CHECK(verification.outputs.count(name) == 1);
    }
}

const std::string& stored_text(const Files& files, const std::string& name) {
    const auto found = files.find("thesis/" + name);
    if (found == files.end()) throw std::runtime_error(name + " is not stored");
    return found->second;
}

SkeletonGraph stored_graph(const Files& files, const std::string& drawing) {
    return skeleton_from_json(stored_text(files, drawing + "/character-1/skeleton.json"), "skeleton.json");
}

} // namespace

TEST_CASE("Preset thesis: every stage agrees, stage by stage and end to end", "[verify]") {
    VerificationSettings settings = VerificationSettings::of("thesis");
    const Verification verification = verify(settings);
    INFO(verification_table(verification));
    CHECK(verification.first_difference() == nullptr);
    CHECK(verification.results.size() == 60);
    CHECK(verification.drawings == std::vector<std::string>{"hole", "unpaired", "crossed"});
    check_files(verification, "thesis");
    settings.end_to_end = true;
    settings.threads = 2;
    CHECK(verify(settings).digest == verification.digest);
}

// A program without GLPK takes our branch and bound for the literal integer program (identification.hpp).
TEST_CASE("Preset thesis: the other solvers of the graph distance store the same", "[verify]") {
    for (const GgdSolver solver : {GgdSolver::branch_and_bound, GgdSolver::tightened}) {
        VerificationSettings settings = VerificationSettings::of("thesis");
        settings.options.identification.solver = solver;
        CHECK(differing(verify(settings)).empty());
    }
}

// What makes the drawings worth verifying does not go away unseen when the vectors are renewed.
TEST_CASE("Preset thesis: a hole, an end-effector without a partner, legs that cross", "[verify]") {
    const Files files = stored_vectors();
    const SkeletonGraph hole = stored_graph(files, "hole");
    CHECK(hole.edges.size() >= hole.vertices.size()); // connected, so it has a cycle

    const SkeletonGraph unpaired = stored_graph(files, "unpaired");
    const Json mapping =
        parse_json(stored_text(files, "unpaired/character-1/mapping.json"), file_names::mapping);
    const auto ends = std::count_if(unpaired.vertices.begin(), unpaired.vertices.end(),
                                    [](const SkeletonVertex& v) { return v.end; });
    CHECK(ends > static_cast<long>(mapping.at("pairs").size()));
    CHECK(mapping.at("costs").size() > mapping.at("costs").at(0).size());

    // The two legs meet in one limb junction, from which each goes its way: neither starts at the body.
    const SkeletonGraph crossed = stored_graph(files, "crossed");
    std::vector<int> legs(crossed.vertices.size());
    for (const SkeletonEdge& edge : crossed.edges)
        for (const auto& [from, to] : {std::pair(edge.u, edge.v), std::pair(edge.v, edge.u)}) {
            const SkeletonVertex &a = crossed.vertices[static_cast<std::size_t>(from)],
                                 &b = crossed.vertices[static_cast<std::size_t>(to)];
            legs[static_cast<std::size_t>(from)] +=
                !a.end && a.label == Label::limb && b.end && b.label == Label::limb && b.y > a.y;
        }
    CHECK(std::count(legs.begin(), legs.end(), 2) == 1);
}

TEST_CASE("Preset thesis: a changed option is seen in its stage", "[verify]") {
    VerificationSettings settings = VerificationSettings::of("thesis");
    settings.options.rigging.weight_ends = WeightEnds::mapped;
    settings.options.rigging.mapping.length_in_pixels = false;
    const std::set<std::string> found = differing(verify(settings));
    CHECK(found.count("weights/unpaired") == 1);
    CHECK(found.count("map/crossed") == 1);
    CHECK(found.count("identify/crossed") == 0);
    CHECK_THROWS_AS(VerificationSettings::of("other"), Error);
    settings.preset = "other";
    CHECK_THROWS_AS(verify(settings), Error);
}

TEST_CASE("Every stage on every drawing agrees with the stored results, stage by stage and end to end",
          "[verify]") {
    const Verification verification = verify();
    INFO(verification_table(verification));
    CHECK(verification.first_difference() == nullptr);
    CHECK(verification.results.size() >= 60);
    check_files(verification, "default");
    VerificationSettings chained;
    chained.end_to_end = true;
    chained.threads = 2;
    const Verification whole = verify(chained);
    CHECK(whole.first_difference() == nullptr);
    CHECK(whole.digest == verification.digest);
}

// One option of each stage is changed, all at once: since stages take the stored input, each change shows
// where it is made and nowhere else.
TEST_CASE("A changed option is seen in its stage alone, with file, place and both values", "[verify]") {
    VerificationSettings settings;
    settings.options.detection.working_size = 150;
    settings.options.segmentation.silhouette.speck_share = 0.05;
    settings.options.skeletonization.merge_distance = 20;
    settings.options.identification.ggd.k_v = 1.25;
    settings.options.rigging.mapping.position_weight = 3;
    settings.options.rigging.limb_segments = 1;
    settings.options.animation.samples = 6;
    settings.options.modeling.inflation.longest_edge = 0.12;
    const Verification verification = verify(settings);
    INFO(verification_table(verification));
    const std::set<std::string> found = differing(verification);
    for (const char* stage : {"detect", "identify", "map", "bones", "weights", "animate"})
        for (const char* drawing : {"humanoid", "quadruped"})
            CHECK(found.count(std::string(stage) + "/" + drawing) == 1);
    for (const char* stage : {"detect", "identify", "map", "animate"}) // its wings are one stiff bone each
        CHECK(found.count(std::string(stage) + "/flyer") == 1);
    CHECK(found.count("inflate/humanoid") == 1);
    CHECK(found.count("unite/humanoid") == 1);
    const std::set<std::string> allowed = {"detect",   "segment", "h2",      "skeletonize",
                                           "identify", "map",     "mesh",    "bones",
                                           "weights",  "animate", "inflate", "unite"};
    for (const std::string& row : found) {
        CAPTURE(row);
        CHECK(allowed.count(row.substr(0, row.find('/'))) == 1);
    }
    const StageDifferences* first = verification.first_difference();
    REQUIRE(first != nullptr);
    CHECK(first->stage == "detect");
    CHECK(first->files.front().file == "humanoid/page.json");
    CHECK(first->files.front().place == "characters[0].scale");
    CHECK(first->files.front().first == "1");
    CHECK(verification_table(verification).find("identify    DIFFERS") != std::string::npos);
}

TEST_CASE("A stage that throws differs by its message", "[verify]") {
    VerificationSettings settings;
    settings.options.identification.reference = "dragon";
    const Verification verification = verify(settings);
    const StageDifferences* first = verification.first_difference();
    REQUIRE(first != nullptr);
    CHECK(first->stage == "identify");
    CHECK(first->files.front().second.find("dragon") != std::string::npos);
    CHECK(differing(verification).size() == 3);
}

TEST_CASE("Every file of the vectors is made by one stage at first, and read only after it is made",
          "[verify]") {
    for (const std::string_view preset : verified_presets())
        for (const VerifiedDrawing& drawing : verified_drawings(preset)) {
            std::set<std::string> made = {"page.png"};
            for (const Stage& stage : verified_stages()) {
                if (!stage.is_for(drawing)) continue;
                for (const std::string& input : stage.inputs) {
                    CAPTURE(stage.name, input);
                    CHECK(made.count(input) == 1);
                }
                made.insert(stage.outputs.begin(), stage.outputs.end());
            }
        }
}

TEST_CASE("The README of the vectors describes every file and every stage", "[verify]") {
    const std::string readme = read("testdata/vectors/README.md");
    for (const Stage& stage : verified_stages()) {
        CAPTURE(stage.name);
        const std::size_t row = readme.find("| " + stage.name + " |");
        REQUIRE(row != std::string::npos);
        const std::string line = readme.substr(row, readme.find('\n', row) - row);
        for (const auto* files : {&stage.inputs, &stage.outputs})
            for (const std::string& file : *files) {
                CAPTURE(file);
                const std::string name =
                    file.starts_with(character_path) ? file.substr(character_path.size()) : file;
                CHECK(line.find("`" + name + "`") != std::string::npos);
            }
    }
}

TEST_CASE("What steps hand to each other survives the file to the bit", "[verify]") {
    Rig rig = square_rig();
    rig.weights[4] = {{2, 0, 1, 0}, {0.7, 0.2, 0.1, 0}}; // descending, as everywhere but in that test figure
    rig.weights[8] = {{1, 0, 2, 0}, {0.5, 0.25, 0.25, 0}};
    const std::string mesh = mesh_to_json(rig), bones = bones_to_json(rig), weights = to_weights_text(rig),
                      depths = depths_to_json(rig);
    const Rig read = rig_from_files(mesh, bones, weights, depths);
    CHECK(mesh_to_json(read) == mesh);
    CHECK(bones_to_json(read) == bones);
    CHECK(to_weights_text(read) == weights);
    CHECK(depths_to_json(read) == depths);
    const std::string animations = animations_to_json({swing()});
    CHECK(animations_to_json(animations_from_json(animations, "animations.json")) == animations);
    const SolidMesh solid{{{0, 0, 0}, {1, 0, 0.1}, {0, 1, -0.0}}, {{0, 1, 2}}, {0, 0, 1}};
    CHECK(solid_to_json(solid_from_json(solid_to_json(solid), "solid.json")) == solid_to_json(solid));
    CHECK_THROWS_AS(solid_from_json("{}", "solid.json"), Error);
    CHECK_THROWS_AS(animations_from_json("[]", "animations.json"), Error);
    CHECK_THROWS_AS(rig_from_files("{}", bones, weights, depths), Error);
}

TEST_CASE("A damaged archive is an error", "[verify]") {
    const auto bytes = find_resource("vectors.tar.gz");
    CHECK(read_archive(bytes).size() > 60);
    CHECK_THROWS_AS(read_archive(bytes.first(5)), Error);
    CHECK_THROWS_AS(read_archive(bytes.subspan(1)), Error);
    CHECK_THROWS_AS(read_archive(bytes.first(bytes.size() / 2)), Error);
}
