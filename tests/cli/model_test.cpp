// SPDX-License-Identifier: MIT
// pantin model: strokes and scanned characters to solids.
#include <catch2/catch.hpp>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "export/glb_file.hpp"
#include "pantin/image.hpp"
#include "pantin/strokes.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string stick = R"({"parts": [
  {"name": "body", "stroke": [[40, 40], [60, 40], [64, 70], [60, 100], [40, 100], [36, 70]]},
  {"name": "head", "stroke": [[50, 6], [66, 16], [66, 34], [50, 46], [34, 34], [34, 16]]},
  {"name": "arm", "stroke": [[58, 46], [90, 50], [92, 60], [56, 58]], "symmetric": true},
  {"name": "leg", "stroke": [[52, 92], [64, 92], [72, 140], [58, 142]], "symmetric": true}]})";

Outcome model(const std::string& input, const fs::path& out, const std::vector<std::string>& more = {}) {
    return run_pantin(std::vector<std::string>{"model", input, "-o", out.string()} + more);
}

struct Text {
    TemporaryFolder folder;
    fs::path file;
    explicit Text(const std::string& text, const std::string& name = "strokes.json") : file(folder / name) {
        write(file, text);
    }
};

void check_refused(const std::string& text, const std::string& fact,
                   const std::string& name = "strokes.json") {
    const Text input(text, name);
    const TemporaryFolder folder;
    const Outcome outcome = model(input.file.string(), folder / "out");
    CAPTURE(text, outcome.err);
    CHECK(outcome.code == 3);
    CHECK(outcome.err.starts_with("pantin: " + input.file.string()));
    CHECK(outcome.err.find(fact) != std::string::npos);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    CHECK_FALSE(fs::exists(folder / "out"));
}

} // namespace

TEST_CASE("A model's folder has the solid, its skeleton and what the steps take", "[cli][model]") {
    const fs::path& out = animated_model();
    for (const char* name :
         {"strokes.json", "model.json", "model.obj", "model.mtl", "model.glb", "views.png", "drawing.png",
          "mask.png", "labels.png", "skeleton.json", "identification.json", "mapping.json", "character.glb"})
        CHECK(fs::exists(out / name));
    CHECK(Json::parse(read(out / "identification.json"))["reference"] == "quadruped");
    const Json json = Json::parse(read(out / "model.json"));
    int roots = 0;
    for (std::size_t j = 0; j < json["joints"].size(); ++j) {
        if (!json["joints"][j].contains("parent"))
            ++roots;
        else
            CHECK(json["joints"][j]["parent"] < j);
    }
    CHECK(roots == 1);
    const std::string glb = read(out / "character.glb");
    const GlbFile solid(std::vector<unsigned char>(glb.begin(), glb.end()));
    const Json primitive = solid.json["meshes"][0]["primitives"][0];
    CHECK(primitive["attributes"].contains("NORMAL"));
    CHECK(primitive["attributes"].contains("COLOR_0"));
    CHECK_FALSE(solid.json.contains("extensionsUsed")); // it is lit
    CHECK(solid.json["animations"].size() >= 3);
}

TEST_CASE("The same strokes give the same bytes, from JSON, again and from the folder's own strokes.json",
          "[cli][model]") {
    const Text input(stick);
    const TemporaryFolder folder;
    REQUIRE(model(input.file.string(), folder / "a").code == 0);
    REQUIRE(model(input.file.string(), folder / "b").code == 0);
    REQUIRE(model((folder / "a" / "strokes.json").string(), folder / "c").code == 0);
    const auto files = read_all(folder / "a");
    CHECK(files.size() == 10);
    CHECK((read_all(folder / "b") == files));
    CHECK((read_all(folder / "c") == files));
}

TEST_CASE("An SVG of the same strokes gives the same model", "[cli][model][needs-pugixml]") {
    const Text json(stick);
    const Text svg(R"svg(<svg xmlns="http://www.w3.org/2000/svg" data-origin="50 70">
        <polygon id="body" points="40,40 60,40 64,70 60,100 40,100 36,70"/>
        <path id="head" d="M 50 6 L 66 16 V 34 L 50 46 L 34 34 V 16 Z"/>
        <g transform="translate(50 0)"><polygon id="arm" data-symmetric="true" points="8,46 40,50 42,60 6,58"/></g>
        <polyline id="leg" data-symmetric="x" points="52 92 64 92 72 140 58 142 52 92"/></svg>)svg",
                   "strokes.svg");
    const TemporaryFolder folder;
    REQUIRE(model(json.file.string(), folder / "a").code == 0);
    REQUIRE(model(svg.file.string(), folder / "b").code == 0);
    CHECK(read(folder / "a" / "model.obj") == read(folder / "b" / "model.obj"));
}

TEST_CASE("Calls are played after the strokes", "[cli][model]") {
    const Text input(stick);
    const Text calls(R"({"calls": [{"move_part": {"part": "arm", "rotate": {"axis": "z", "degrees": 20}}},
        {"refine": {"prune": 0.2}}, {"remove_part": "head"},
        {"add_part": {"name": "tail", "stroke": [[50, 84], [56, 90], [20, 130], [14, 126]]}}]})",
                     "calls.json");
    const TemporaryFolder folder;
    REQUIRE(model(input.file.string(), folder / "out", {"--calls", calls.file.string()}).code == 0);
    const Json parts = Json::parse(read(folder / "out" / "model.json"))["parts"];
    std::vector<std::string> names;
    for (const Json& part : parts) names.push_back(part["name"]);
    CHECK(names == std::vector<std::string>{"body", "arm", "arm.mirrored", "leg", "leg.mirrored", "tail"});
    REQUIRE(model((folder / "out" / "strokes.json").string(), folder / "again").code ==
            0); // the calls are kept
    CHECK((read_all(folder / "again") == read_all(folder / "out")));
    const Text bad(R"({"calls": [{"remove_part": "wing"}]})", "calls.json");
    const Outcome outcome = model(input.file.string(), folder / "bad", {"--calls", bad.file.string()});
    CHECK(outcome.code == 3);
    CHECK(outcome.err.find("there is no part 'wing'") != std::string::npos);
}

TEST_CASE("A scanned character becomes a solid that walks with the drawing on it",
          "[cli][model][end-to-end]") {
    const TemporaryFolder folder;
    copy_demo(folder / "out");
    const fs::path character = folder / "out" / "character-1";
    const Outcome outcome = run_pantin(
        std::vector<std::string>{"model", character.string(), "--animate", "--clip", "idle"} + small_films);
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
    const fs::path out = character / "model";
    CHECK((load_grey(out / "labels.png") == load_grey(character / "labels.png")));
    CHECK(Json::parse(read(out / "model.json"))["texture"] == "drawing");
    CHECK(fs::exists(out / "character.glb"));
    CHECK(fs::file_size(out / "mesh.obj") > fs::file_size(character / "mesh.obj"));
}

TEST_CASE("Bad strokes are refused in one line, and nothing is written", "[cli][model]") {
    check_refused("", "");
    check_refused("{}", "holds no part");
    check_refused(R"({"parts": [{"name": "a", "stroke": [[0, 0], [1, 1]]}]})", "at least three points");
    check_refused(R"({"parts": [{"name": "a", "stroke": [[0, 0], [1, 1], [2, 2], [3, 3]]}]})", "part 'a'");
    check_refused(R"({"parts": [{"name": "a", "stroke": [[0, 0], [1, null], [2, 5]]}]})", "must be a number");
    check_refused(R"({"parts": [{"name": "a", "stroke": [[0, 0], [9, 0], [0, 9]], "parent": "b"},
                                {"name": "b", "stroke": [[0, 0], [9, 0], [0, 9]], "parent": "a"}]})",
                  "does not come before it");
    if (svg_available()) {
        check_refused("<svg><path id='a' d='M 0 0 L 5'/></svg>", "path 'a': d, character 10", "strokes.svg");
        check_refused("<svg", "", "strokes.svg");
    }
    check_refused("0 0 1 1", "must be a .json or .svg file", "strokes.txt");
    const TemporaryFolder folder;
    CHECK(run_pantin({"model", "testdata/models/cat.json"}).code == 2); // no folder for the results
    CHECK(model((folder / "missing.json").string(), folder / "out").code == 3);
    CHECK(model(folder.path().string(), folder / "out").code == 3); // no character's folder
}

TEST_CASE("Bad strokes that can be repaired are repaired and reported", "[cli][model]") {
    const Text input(
        R"({"parts": [{"name": "eight", "stroke": [[0, 0], [0, 0], [40, 40], [40, 0], [0, 44]]}]})");
    const TemporaryFolder folder;
    const Outcome outcome = model(input.file.string(), folder / "out");
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("crosses itself") != std::string::npos);
    CHECK(outcome.out.find("repeated point") != std::string::npos);
}

TEST_CASE("A model without parts is said in one line", "[cli][model]") {
    const Text input(R"({"parts": [{"name": "body", "stroke": [[0, 0], [9, 0], [9, 9]]}],
                         "calls": [{"remove_part": "body"}]})");
    const TemporaryFolder folder;
    const Outcome outcome = model(input.file.string(), folder / "out");
    CHECK(outcome.code == 3);
    CHECK(outcome.err.find("no part is left, there is nothing to model") != std::string::npos);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

TEST_CASE("Thin parts are there and drawn", "[cli][model]") {
    // A leg of 1 % of the model, a whisker of 0.1 %.
    const Text input(R"({"parts": [
      {"name": "body", "stroke": [[100, 100], [300, 90], [340, 140], [300, 200], [110, 190], [70, 150]]},
      {"name": "leg", "stroke": [[120, 180], [124, 180], [124, 330], [120, 330]]},
      {"name": "whisker", "label": "tail", "stroke": [[310, 140], [450, 60], [450, 60.5], [310, 140.5]]}]})");
    const TemporaryFolder folder;
    const Outcome outcome = model(input.file.string(), folder / "out");
    CAPTURE(outcome.out, outcome.err);
    REQUIRE(outcome.code == 0);
    // All of the whisker that does not lie in the body is seen.
    const GreyImage labels = load_grey(folder / "out/labels.png");
    int rows = 0, columns = 0;
    for (int y = 0; y < labels.height(); ++y) {
        bool seen = false;
        for (int x = 0; x < labels.width(); ++x) seen = seen || labels(x, y) == 4;
        rows += seen;
    }
    for (int x = 0; x < labels.width(); ++x) {
        bool seen = false;
        for (int y = 0; y < labels.height(); ++y) seen = seen || labels(x, y) == 4;
        columns += seen;
    }
    CHECK(rows > 60);     // of 68, at about one pixel to a unit
    CHECK(columns > 105); // of 119
}
