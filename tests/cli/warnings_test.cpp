// SPDX-License-Identifier: MIT
// Warnings on the way through the program: standard error, page.json, batch; what is written of them.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"
#include "pantin/warnings.hpp"
#include "support/schemas.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// A page with one character, animated; its head is then painted over as background, or back again.
struct Figure {
    TemporaryFolder folder;
    fs::path out = folder / "out", character = out / "character-1";
    GreyImage labels;
    Figure() {
        REQUIRE(run_pantin(std::vector<std::string>{"animate", small_page, "-o", out.string()} + small_films)
                    .code == 0);
        labels = load_grey(character / "labels.png");
    }
    void behead() const {
        GreyImage painted = labels;
        for (std::uint8_t& label : painted)
            if (label == static_cast<std::uint8_t>(Label::head)) label = 0;
        save_png(character / "labels.png", painted);
    }
    void restore() const { save_png(character / "labels.png", labels); }
    Outcome run(const std::string& step, const std::vector<std::string>& more = {}) const {
        return run_pantin(std::vector<std::string>{step, character.string()} + more);
    }
    void redo_until_rig() const {
        for (const std::string step : {"skeletonize", "identify", "rig"})
            REQUIRE(run(step, {"--quiet"}).code == 0);
    }
    std::vector<std::string> kinds() const {
        const Json page = Json::parse(read(out / "page.json"));
        CHECK(schema_violation("page", page) == "");
        std::vector<std::string> found;
        for (const Json& warning : page["characters"][0].value("warnings", Json::array()))
            found.push_back(warning["kind"]);
        return found;
    }
};

} // namespace

TEST_CASE("A step alone keeps the warnings of its character up to date", "[cli][warnings][end-to-end]") {
    const std::vector<std::string> none, lost = {"lost_ink"};
    const Figure figure;
    CHECK(figure.kinds() == none);
    figure.behead();
    figure.redo_until_rig();
    CHECK(figure.kinds() == lost);
    const Outcome render = figure.run("render", small_films);
    CHECK(render.code == 0);
    CHECK(render.err.starts_with("pantin: warning: " + figure.character.string() + ": "));
    CHECK(render.err.ends_with(" % of the ink lies outside of the silhouette and is not in the films\n"));
    CHECK(std::count(render.err.begin(), render.err.end(), '\n') == 1);
    CHECK(figure.run("render", small_films + std::vector<std::string>{"--quiet"}).err.empty());
    figure.restore();
    CHECK(figure.run("skeletonize").code == 0);
    CHECK(figure.kinds() == lost); // the films are still those without a head
    figure.redo_until_rig();
    CHECK(figure.kinds() == none);
    figure.behead();
    figure.redo_until_rig();
    save_png(figure.character / "labels.png", GreyImage(figure.labels.width(), figure.labels.height(), 0));
    CHECK(figure.run("skeletonize").code == 7);
    CHECK(figure.kinds() == none); // the status says it all
}

TEST_CASE("A given mask that is not kept is seen, by a step alone, too", "[cli][warnings][end-to-end]") {
    const Figure figure;
    // As if the whole crop had been given.
    save_png(figure.character / "mask.png", GreyImage(figure.labels.width(), figure.labels.height(), 255));
    CHECK(figure.run("rig").err.empty());
    Json page = Json::parse(read(figure.out / "page.json"));
    for (Json& character : page["characters"]) character["exact_mask"] = true;
    write(figure.out / "page.json", page.dump());
    CHECK(figure.run("rig").err.find("of the given mask") != std::string::npos);
    CHECK(figure.kinds() == std::vector<std::string>{"lost_mask"});
}

TEST_CASE("A batch lists the kinds of a character and counts them at the end",
          "[batch][warnings][end-to-end]") {
    const Figure figure;
    figure.behead();
    figure.redo_until_rig();
    const std::string line = Json{{"image", small_page}, {"out", figure.out.string()}}.dump() + "\n";
    const Outcome outcome = run_pantin({"batch", "--skip-done"}, {}, "", line);
    CHECK(outcome.code == 0);
    CHECK(outcome.err == "pantin: warning: 1 of 1 characters: lost_ink 1\n");
    const Json result = Json::parse(outcome.out);
    CHECK(result["characters"][0]["warnings"] == Json{"lost_ink"});
    CHECK(schema_violation("batch-output", result) == "");
    CHECK(run_pantin({"batch", "--skip-done", "--quiet"}, {}, "", line).err.empty());
}

TEST_CASE("Every kind of warning and its threshold stand in the documentation and in the schemas",
          "[docs][warnings]") {
    const std::string page = read("docs/warnings.md"), formats = read("docs/formats.md");
    for (const WarningRow& row : warning_table) {
        const std::string name = "`" + std::string(row.name) + "`";
        CAPTURE(name);
        const std::size_t begin = page.find("\n| " + name + " |");
        REQUIRE(begin != std::string::npos);
        char threshold[32];
        std::snprintf(threshold, sizeof threshold, " | %s %.2f | ", row.below ? "<" : ">", row.threshold);
        CHECK(page.substr(begin, page.find('\n', begin + 1) - begin).find(threshold) != std::string::npos);
        CHECK(formats.find(name) != std::string::npos);
        for (const char* schema : {"page", "batch-output", "evaluation"})
            CHECK(read_schema(schema).dump().find("\"" + std::string(row.name) + "\"") != std::string::npos);
    }
}
