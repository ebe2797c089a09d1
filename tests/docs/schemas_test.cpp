// SPDX-License-Identifier: MIT
// docs/schemas: what the program writes and reads is as the schemas say, and they let nothing else through.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>

#include "cli/demo.hpp"
#include "evaluation/dataset.hpp"
#include "pantin/pipeline.hpp"
#include "support/schemas.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// The schema of a file with this name; "" for a file that is no JSON.
std::string schema_of(const fs::path& file) {
    if (file.extension() != ".json") return "";
    const std::string stem = file.stem().string();
    return stem.starts_with("skeleton-") ? "skeleton" : stem;
}

// Checks every JSON file of a folder and lists the schemas that were met.
std::set<std::string> check_folder(const fs::path& folder) {
    std::set<std::string> met;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string schema = schema_of(entry.path());
        if (schema.empty()) continue;
        CAPTURE(entry.path().string());
        CHECK(schema_violation(schema, Json::parse(read(entry.path()))) == "");
        met.insert(schema);
    }
    return met;
}

std::vector<Json> lines_of(const std::string& text) {
    std::vector<Json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
    return lines;
}

// The blocks of a page in ```json.
std::vector<std::string> json_blocks(const std::string& page) {
    const std::string text = read(page), fence = "```json\n";
    std::vector<std::string> blocks;
    for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
        // Blocks in lists are indented.
        const std::size_t begin = at + fence.size();
        blocks.push_back(text.substr(begin, text.find("```", begin) - begin));
    }
    return blocks;
}

// What a schema says of one place of a value: an object that may have any key, and keys that may be missing.
struct Allowed {
    std::set<std::string> open;     // places whose objects take any key
    std::set<std::string> optional; // places that may be missing
    std::set<std::string> free;     // places that take any value
};

// Damages a value in all ways, one at a time: a key more, a key less, a value of another type. Places: keys
// joined by points, * for the elements of a list. Of a list the first element is damaged.
class Damager {
public:
    Damager(std::string schema, Json value, Allowed allowed)
        : schema_(std::move(schema)), value_(std::move(value)), allowed_(std::move(allowed)) {}

    int run() {
        visit(value_, "");
        return count_;
    }

private:
    void must_fail(const std::string& what, const std::string& place) {
        CAPTURE(schema_, what, place);
        CHECK(schema_violation(schema_, value_) != "");
        ++count_;
    }
    void visit(Json& node, const std::string& place) {
        if (!allowed_.free.contains(place)) {
            Json kept = std::move(node);
            node = kept.is_object() ? Json("text") : Json{{"of", "another type"}};
            must_fail("another type", place);
            node = std::move(kept);
        }
        if (node.is_object()) visit_object(node, place);
        if (node.is_array() && !node.empty()) visit(node[0], place + "*");
    }
    void visit_object(Json& node, const std::string& place) {
        if (!allowed_.open.contains(place)) {
            node["surplus"] = 1;
            must_fail("a key too many", place);
            node.erase("surplus");
        }
        std::vector<std::string> keys;
        for (const auto& [key, ignored] : node.items()) keys.push_back(key);
        for (const std::string& key : keys) {
            const std::string below = place.empty() ? key : place + "." + key;
            if (!allowed_.optional.contains(below) && !allowed_.open.contains(place)) {
                const Json kept = node[key];
                node.erase(key);
                must_fail("a missing key", below);
                node[key] = kept;
            }
            visit(node[key], below);
        }
    }

    std::string schema_;
    Json value_;
    Allowed allowed_;
    int count_ = 0;
};

// A character's folder of the demo with what only options write.
const fs::path& traced_character() {
    static const TemporaryFolder folder;
    static const fs::path out = [] {
        const fs::path to = folder / "character";
        fs::copy(animated_demo() / "character-1", to, fs::copy_options::recursive);
        for (const std::string option : {"--trace", "--compare"}) {
            const Outcome outcome = run_pantin({"skeletonize", to.string(), option});
            if (outcome.code != 0) throw std::runtime_error("skeletonize failed: " + outcome.err);
        }
        return to;
    }();
    return out;
}

Json character_json(const std::string& name) { return Json::parse(read(traced_character() / name)); }

} // namespace

TEST_CASE("Every JSON file of an animated page is as its schema says", "[docs][schemas]") {
    CHECK(check_folder(animated_demo()) ==
          std::set<std::string>{"page", "segmentation", "contour", "skeleton", "identification", "mapping"});
    CHECK(check_folder(traced_character()) == std::set<std::string>{"segmentation", "contour", "skeleton",
                                                                    "skeletons", "identification", "mapping",
                                                                    "voronoi"});
}

TEST_CASE("Every JSON file of a model is as its schema says", "[docs][schemas]") {
    CHECK(check_folder(animated_model()) ==
          std::set<std::string>{"strokes", "model", "skeleton", "identification", "mapping"});
    for (const auto& entry : fs::directory_iterator("testdata/models"))
        if (entry.path().extension() == ".json")
            CHECK(schema_violation("strokes", Json::parse(read(entry.path()))) == "");
}

TEST_CASE("Every JSON file of the reference vectors is as its schema says, and damaged ones are not",
          "[docs][schemas]") {
    const std::set<std::string> own = {"found",      "probabilities", "mesh",      "bones", "depths",
                                       "animations", "posed",         "inflation", "solid"};
    const std::set<std::string> met = check_folder("testdata/vectors");
    CHECK(std::includes(met.begin(), met.end(), own.begin(), own.end()));
    const fs::path vectors = "testdata/vectors/humanoid", character = vectors / "character-1";
    for (const fs::path& file :
         {vectors / "found.json", character / "trace/probabilities.json", character / "trace/mesh.json",
          character / "trace/bones.json", character / "trace/depths.json",
          character / "trace/animations.json", character / "trace/posed.json",
          character / "model/inflation.json", character / "model/solid.json"})
        CHECK(Damager(file.stem().string(), Json::parse(read(file)), {}).run() >= 5);
}

TEST_CASE("The compiled-in references are as their schema says", "[docs][schemas]") {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("references")) {
        CAPTURE(entry.path().string());
        CHECK(schema_violation("reference", Json::parse(read(entry.path()))) == "");
        ++count;
    }
    CHECK(count == static_cast<int>(load_references().size()));
}

TEST_CASE("The lines that batch reads and writes are as their schemas say", "[docs][schemas]") {
    const TemporaryFolder folder;
    const std::string good = Json{{"image", small_page},
                                  {"clip", "idle"},
                                  {"formats", {"apng"}},
                                  {"config", {{"rigging.limb_segments", 1}}}}
                                 .dump();
    const std::string input = good + "\n{\"image\": \"none.png\", \"rotate\": 90}\nno JSON either\n{\n";
    CHECK(schema_violation("batch-input", Json::parse(good)) == "");
    const Outcome outcome = run_pantin(
        std::vector<std::string>{"batch", "-o", (folder / "out").string(), "--seconds"} + small_films, {}, "",
        input);
    const std::vector<Json> lines = lines_of(outcome.out);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0]["code"] == 0);
    for (const Json& line : lines) CHECK(schema_violation("batch-output", line) == "");
    check_folder(folder / "out");
    CHECK(Damager("batch-output", lines[0], {{}, {"seconds"}, {}}).run() > 15);
    CHECK(Damager("batch-input", Json::parse(good),
                  {{"config"}, {"clip", "formats", "config"}, {"config", "config.rigging.limb_segments"}})
              .run() > 5);
}

TEST_CASE("A dataset and its evaluation are as their schemas say", "[docs][schemas]") {
    const TemporaryFolder folder;
    write_dataset(folder / "data", 1);
    for (const Json& line : lines_of(read(folder / "data/index.ndjson")))
        CHECK(schema_violation("dataset", line) == "");
    CHECK(schema_violation("dataset", {{"id", "../a"}}) != "");
    CHECK(schema_violation("dataset", {{"type", "humanoid"}}) != "");
    REQUIRE(run_pantin({"evaluate", (folder / "data").string(), "-o", (folder / "out").string()}).code == 0);
    CHECK(check_folder(folder / "out").contains("evaluation"));
    const Json evaluation = Json::parse(read(folder / "out/evaluation.json"));
    const int damages =
        Damager("evaluation", evaluation,
                {{"segmentation", "identification", "identification.humanoid", "identification.quadruped"},
                 {},
                 {}})
            .run();
    CHECK(damages > 100);
}

TEST_CASE("Examples in the documentation are as the schemas say", "[docs][schemas]") {
    const std::vector<std::string> formats = json_blocks("docs/formats.md"),
                                   modeling = json_blocks("docs/modeling.md"),
                                   references = json_blocks("docs/references.md"),
                                   batch = json_blocks("docs/batch.md");
    REQUIRE((formats.size() == 3 && modeling.size() == 1 && references.size() == 1 && batch.size() == 2));
    CHECK(schema_violation("page", Json::parse(formats[0])) == "");
    CHECK(schema_violation("skeleton", Json::parse(formats[1])) == "");
    CHECK(schema_violation("configuration", Json::parse(formats[2])) == "");
    CHECK(schema_violation("strokes", Json::parse(modeling[0])) == "");
    CHECK(schema_violation("reference", Json::parse(references[0])) == "");
    for (const Json& line : lines_of(batch[0])) CHECK(schema_violation("batch-input", line) == "");
    for (const Json& line : lines_of(batch[1])) CHECK(schema_violation("batch-output", line) == "");
}

TEST_CASE("The schema of the configuration has every option, nested and dotted, and no other",
          "[docs][schemas]") {
    const Json schema = read_schema("configuration");
    std::set<std::string> dotted, groups;
    for (const auto& [key, ignored] : schema["properties"].items())
        (key.find('.') == std::string::npos ? groups : dotted).insert(key);
    dotted.erase("identification.label_values"); // nested once more
    std::set<std::string> options;
    Json all = Json::object();
    for (const char* preset : {"default", "thesis"})
        for (const auto& [name, value] : list_options(make_preset(preset))) {
            CAPTURE(name, value);
            options.insert(name);
            const std::size_t point = name.find('.');
            CHECK(groups.contains(name.substr(0, point)));
            // A number is a decimal or, if whole, has no point: 2e+06 is whole, too.
            Json json = Json::parse(value);
            if (json.is_number_float() && json == Json(json.get<long>())) json = json.get<long>();
            all[name] = json;
            CHECK(schema_violation("configuration", {{name, json}}) == "");
            CHECK(schema_violation("configuration",
                                   {{name.substr(0, point), {{name.substr(point + 1), json}}}}) == "");
            CHECK(schema_violation("configuration", {{name, "another type"}}) != "");
            CHECK(schema_violation("configuration", {{name.substr(0, point),
                                                      {{name.substr(point + 1), Json::array()}}}}) != "");
        }
    // Former names are valid, too, and marked.
    for (const auto& [former, name] : renamed_options()) {
        CAPTURE(former);
        CHECK(options.insert(std::string(former)).second);
        const std::size_t point = former.find('.');
        const Json& group = schema["definitions"][std::string(former.substr(0, point))]["properties"];
        CHECK(group[std::string(former.substr(point + 1))].value("deprecated", false));
        CHECK(schema_violation("configuration", {{std::string(former), all[std::string(name)]}}) == "");
        CHECK(schema_violation("configuration", {{std::string(former), "another type"}}) != "");
    }
    for (const FormerSwitch& option : former_switches()) {
        CAPTURE(option.former);
        options.insert(std::string(option.former));
        for (const bool value : {true, false})
            CHECK(schema_violation("configuration", {{std::string(option.former), value}}) == "");
        for (const std::string_view value : {option.if_true, option.if_false})
            CHECK(schema_violation("configuration", {{std::string(option.name), std::string(value)}}) == "");
    }
    CHECK(dotted == options);
    CHECK(schema_violation("configuration", all) == "");
    CHECK(schema_violation("configuration", {{"identification", {{"label_values", {{"wing", 9}}}}}}) == "");
    CHECK(schema_violation("configuration", {{"detection.speed", 1}}) != "");
    CHECK(schema_violation("configuration", {{"detection", {{"speed", 1}}}}) != "");
    CHECK(schema_violation("configuration", {{"rigging.limb_segments", 5}}) !=
          ""); // out of range, as for the program
}

TEST_CASE("No file with a key too many, a missing key or a value of another type is let through",
          "[docs][schemas]") {
    const auto damages = [](const std::string& schema, const Json& value, const Allowed& allowed = {}) {
        return Damager(schema, value, allowed).run();
    };
    // What is known of identified characters alone.
    const Allowed identified{{}, {"characters*.type", "characters*.confidence", "characters*.second"}, {}};
    CHECK(damages("page", Json::parse(read(animated_demo() / "page.json")), identified) > 20);
    CHECK(damages("segmentation", character_json("segmentation.json"), {{"router"}, {"type"}, {}}) > 40);
    CHECK(damages("contour", character_json("contour.json")) > 10);
    CHECK(damages("skeleton", character_json("skeleton.json")) > 25);
    CHECK(damages("skeletons", character_json("skeletons.json")) > 60);
    CHECK(damages("mapping", character_json("mapping.json")) > 10);
    CHECK(damages("voronoi", character_json("trace/voronoi.json")) > 15);
    // Terms of the evidence depend on the options.
    Allowed evidence;
    const Json identification = character_json("identification.json");
    for (const auto& [term, ignored] : identification["candidates"][0]["evidence"].items())
        evidence.optional.insert("candidates*.evidence." + term);
    CHECK(damages("identification", identification, evidence) > 30);
    const Allowed strokes = {{},
                             {"origin", "parts*.depth", "parts*.view", "parts*.symmetric", "parts*.parent",
                              "parts*.height", "parts*.label", "parts*.colour"},
                             {}};
    CHECK(damages("strokes", Json::parse(read(animated_model() / "strokes.json")), strokes) >= 15);
    const Json model = Json::parse(read(animated_model() / "model.json"));
    CHECK(damages("model", model, {{}, {"joints*.parent"}, {}}) > 40);
    Json reference = Json::parse(read("references/fish.json"));
    Allowed free = {{}, {"order", "like", "needs", "clips*.tracks*.phase"}, {}};
    for (const auto& [trait, ignored] : reference["needs"].items()) free.optional.insert("needs." + trait);
    CHECK(damages("reference", reference, free) > 60);
    reference.erase("like");
    CHECK(schema_violation("reference", reference) != ""); // needs are of one that is like another
}
