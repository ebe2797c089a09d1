// SPDX-License-Identifier: MIT
// Character folders that people have changed by hand.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "core/random.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

struct DemoCopy {
    TemporaryFolder folder;
    fs::path out = folder / "out", character = out / "character-1";
    DemoCopy() { copy_demo(out); }
    Outcome run(const std::string& step, const std::vector<std::string>& more = {}) const {
        return run_pantin(std::vector<std::string>{step, character.string()} + more);
    }
    std::string status() const {
        return nlohmann::json::parse(read(out / "page.json"))["characters"][0]["status"];
    }
};

void check_input_error(const Outcome& outcome, const std::string& file) {
    CAPTURE(outcome.err);
    CHECK(outcome.code == 3);
    CHECK(outcome.err.starts_with("pantin: "));
    CHECK(outcome.err.find(file) != std::string::npos);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("labels.png of another size, of other values or in colour is an input error", "[cli][end-to-end]") {
    const DemoCopy demo;
    const auto before = read_all(demo.character);
    const GreyImage labels = load_grey(demo.character / "labels.png");
    save_png(demo.character / "labels.png", GreyImage(labels.width() + 1, labels.height(), 2));
    check_input_error(demo.run("skeletonize"), "labels.png: is ");
    save_png(demo.character / "labels.png", GreyImage(labels.width(), labels.height(), 200));
    check_input_error(demo.run("skeletonize"), "labels.png: pixel (0, 0) has the value 200");
    save_png(demo.character / "labels.png", RgbImage(labels.width(), labels.height(), Rgb8{1, 2, 3}));
    check_input_error(demo.run("skeletonize"), "labels.png");
    save_png(demo.character / "labels.png", labels);
    CHECK((read_all(demo.character) == before)); // nothing was written meanwhile
}

TEST_CASE("Damaged files of earlier steps are input errors that name them", "[cli][end-to-end]") {
    const DemoCopy demo;
    const auto damage = [&](const std::string& file, const std::string& bytes, const std::string& step) {
        const std::string good = read(demo.character / file);
        write(demo.character / file, bytes);
        CAPTURE(file, step);
        check_input_error(demo.run(step), file);
        write(demo.character / file, good);
    };
    const std::string skeleton = read(demo.character / "skeleton.json");
    damage("drawing.png", "", "segment");
    damage("mask.png", "no picture", "segment");
    damage("skeleton.json", "", "identify");
    damage("skeleton.json", "{", "rig");
    damage("skeleton.json", replaced(skeleton, "\"width\": ", "\"width\": 1"), "identify");
    damage("identification.json", "[1, 2]", "rig");
    damage("identification.json", "{\"reference\": \"dragon\"}", "render");
    damage("mapping.json", "{}", "render");
    damage("weights.txt", "# pantin weights 1\nbone 0 nobody\n", "render");
}

TEST_CASE("Repainted labels redefine the silhouette, and the next steps go on from there",
          "[cli][end-to-end]") {
    const DemoCopy demo;
    GreyImage labels = load_grey(demo.character / "labels.png");
    // Cut off the lowest tenth: feet.
    for (int y = labels.height() * 9 / 10; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) labels(x, y) = 0;
    save_png(demo.character / "labels.png", labels);
    const std::string glb = read(demo.character / "character.glb");
    for (const std::string step : {"skeletonize", "identify", "rig"}) REQUIRE(demo.run(step).code == 0);
    REQUIRE(demo.run("render", small_films).code == 0);
    const GreyImage skeleton = load_grey(demo.character / "skeleton.png");
    for (int y = labels.height() * 9 / 10; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) REQUIRE(skeleton(x, y) == 0);
    CHECK((read(demo.character / "character.glb") != glb));
}

TEST_CASE("A mapping corrected by hand is used instead of matching", "[cli][end-to-end]") {
    const DemoCopy demo;
    auto mapping = nlohmann::ordered_json::parse(read(demo.character / "mapping.json"));
    REQUIRE(mapping["pairs"].size() >= 2);
    std::swap(mapping["pairs"][0]["reference_end"], mapping["pairs"][1]["reference_end"]);
    const fs::path file = demo.folder / "corrected.json";
    write(file, mapping.dump());
    REQUIRE(demo.run("rig", {"--mapping", file.string()}).code == 0);
    CHECK(nlohmann::ordered_json::parse(read(demo.character / "mapping.json"))["pairs"] == mapping["pairs"]);
    REQUIRE(demo.run("render", small_films).code == 0);
    // Without it the step matches anew.
    REQUIRE(demo.run("rig").code == 0);
    CHECK((read(demo.character / "character.glb") == read(animated_demo() / "character-1/character.glb")));
}

TEST_CASE("A character that cannot go on gets a status, exit code 7, and later a better status",
          "[cli][end-to-end]") {
    const DemoCopy demo;
    const GreyImage labels = load_grey(demo.character / "labels.png");
    save_png(demo.character / "labels.png", GreyImage(labels.width(), labels.height(), 0));
    const Outcome outcome = demo.run("skeletonize");
    CHECK(outcome.code == 7);
    CHECK(outcome.err.starts_with("pantin: " + demo.character.string() + ": skeletonize: "));
    CHECK(demo.status().starts_with("skeletonize: "));
    save_png(demo.character / "labels.png", labels);
    CHECK(demo.run("skeletonize").code == 0);
    CHECK(demo.status() == "ok");
    CHECK((read_all(demo.out) == read_all(animated_demo())));
}

TEST_CASE("Labels like confetti are a scribble", "[cli][end-to-end]") {
    const DemoCopy demo;
    GreyImage labels = load_grey(demo.character / "labels.png");
    Random random(4);
    for (std::uint8_t& label : labels)
        if (label != 0) label = static_cast<std::uint8_t>(random.integer(1, 5));
    save_png(demo.character / "labels.png", labels);
    const Outcome outcome = demo.run("identify");
    CHECK(outcome.code == 7);
    CHECK(outcome.err ==
          "pantin: " + demo.character.string() + ": identify: a scribble: its parts are scattered\n");
}

TEST_CASE("A clip that the reference has not is refused with those that it has", "[cli][end-to-end]") {
    const DemoCopy demo;
    const Outcome outcome = demo.run("render", {"--clip", "dance"});
    CHECK(outcome.code == 7);
    CHECK(outcome.err == "pantin: " + demo.character.string() +
                             ": render: the flying has no clip 'dance' (fly, idle, glide)\n");
}

TEST_CASE("A folder stands alone, without page.json, too", "[cli][end-to-end]") {
    const DemoCopy demo;
    fs::remove(demo.out / "page.json");
    CHECK(demo.run("skeletonize").code == 0);
    CHECK_FALSE(fs::exists(demo.out / "page.json"));
}

TEST_CASE("A head, a scribble and a blob are left behind with a reason, the cat beside them is animated",
          "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const Outcome outcome = run_pantin(
        std::vector<std::string>{"animate", "testdata/rejects.png", "-o", out.string()} + small_films);
    CHECK(outcome.code == 0);
    const auto page = nlohmann::json::parse(read(out / "page.json"));
    REQUIRE(page["characters"].size() == 4);
    std::size_t fine = 0;
    for (const auto& character : page["characters"]) {
        const std::string status = character["status"];
        const fs::path glb = out / character["folder"].get<std::string>() / "character.glb";
        CHECK(fs::exists(glb) == (status == "ok"));
        if (status == "ok")
            ++fine;
        else
            CHECK(status.find(": ") != std::string::npos);
    }
    CHECK(fine == 1);
}

TEST_CASE("A page where no character can be animated is exit code 7 and says why", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    RgbImage page(300, 300, Rgb8{255, 255, 255});
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x) {
            const int d = (x - 150) * (x - 150) + (y - 150) * (y - 150);
            if (d >= 96 * 96 && d <= 100 * 100) page(x, y) = {20, 20, 20}; // a ring of ink
        }
    save_png(folder / "ring.png", page);
    const fs::path out = folder / "out";
    const Outcome outcome =
        run_pantin(std::vector<std::string>{"animate", (folder / "ring.png").string(), "-o", out.string()} +
                   small_films);
    CHECK(outcome.code == 7);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    const std::string status = nlohmann::json::parse(read(out / "page.json"))["characters"][0]["status"];
    CHECK(outcome.out.starts_with((out / "character-1").string() + ": " + status));
    CHECK(status != "ok");
    CHECK(outcome.err.find("ring.png: no character could be animated (character-1: " + status + ")") !=
          std::string::npos);
}
