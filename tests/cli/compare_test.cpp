// SPDX-License-Identifier: MIT
// skeletonize --compare: the skeletons of all methods in one picture.
#include <catch2/catch.hpp>

#include <set>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

constexpr int gap = 8; // docs/formats.md

long count_of(const RgbImage& picture, Box box, Rgb8 colour) {
    long sum = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) sum += picture(x, y) == colour;
    return sum;
}

} // namespace

TEST_CASE("--compare draws all four skeletons and counts them, and does the step as ever",
          "[cli][skeleton]") {
    const TemporaryFolder folder;
    copy_demo(folder / "out");
    const fs::path character = folder / "out/character-1";
    const auto before = read_all(character);
    REQUIRE(run_pantin({"skeletonize", character.string(), "--compare"}).code == 0);
    auto after = read_all(character);
    const auto counts = nlohmann::ordered_json::parse(after.at("skeletons.json"));
    const RgbImage picture = load_image(character / "skeletons.png");
    const GreyImage labels = load_grey(character / "labels.png");
    REQUIRE(picture.height() == 2 * labels.height());
    REQUIRE(picture.width() == 8 * labels.width() + 3 * gap);
    const std::vector<std::string> methods = {"voronoi", "straight", "thinning", "chordal"};
    REQUIRE(counts.size() == methods.size());
    std::set<std::string> different;
    for (int i = 0; i < 4; ++i) {
        CAPTURE(methods[i]);
        REQUIRE(std::next(counts.begin(), i).key() == methods[i]);
        const auto& one = counts[methods[i]];
        CHECK(one["status"] == "ok");
        CHECK(one["ends"].get<int>() + one["junctions"].get<int>() == one["vertices"].get<int>());
        CHECK(one["edges"].get<int>() >= one["vertices"].get<int>() - 1);
        const Box panel{i * (2 * labels.width() + gap), 0, 2 * labels.width(), picture.height()};
        CHECK(count_of(picture, panel, {30, 80, 220}) > one["length"].get<double>());
        const long marked = count_of(picture, panel, {220, 20, 40});
        CHECK(marked > 13 * 13 / 2 * one["ends"].get<int>());
        CHECK(marked <= 13 * 13 * one["ends"].get<int>());
        different.insert(one.dump());
    }
    CHECK(different.size() >= 3);
    const auto skeleton = nlohmann::json::parse(after.at("skeleton.json"));
    CHECK(counts["voronoi"]["vertices"] == skeleton["vertices"].size());
    after.erase("skeletons.json");
    after.erase("skeletons.png");
    CHECK((after == before));

    // The same bytes again, whatever method the step itself takes.
    const std::string json = read(character / "skeletons.json"), png = read(character / "skeletons.png");
    REQUIRE(run_pantin({"skeletonize", character.string(), "--compare", "--skeleton", "chordal"}).code == 0);
    CHECK(read(character / "skeletons.json") == json);
    CHECK((read(character / "skeletons.png") == png));
    CHECK(read(character / "skeleton.json") != before.at("skeleton.json"));
}

TEST_CASE("--compare tells which method finds no skeleton", "[cli][skeleton]") {
    const TemporaryFolder folder;
    copy_demo(folder / "out");
    const fs::path character = folder / "out/character-1";
    const GreyImage size = load_grey(character / "mask.png");
    // No part of a box has that much more border than its chord; the straight skeleton does not ask.
    GreyImage labels(size.width(), size.height(), 0);
    const int side = std::min(size.width(), size.height()) * 2 / 5;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < 2 * side; ++x) labels(4 + x, 4 + y) = 3;
    save_png(character / "labels.png", labels);
    write(folder / "options.json",
          R"({"skeletonization": {"lower_threshold": false, "residual_threshold": 300}})");
    const Outcome outcome = run_pantin({"skeletonize", character.string(), "--compare", "--skeleton",
                                        "straight", "--config", (folder / "options.json").string()});
    REQUIRE(outcome.code == 0);
    const auto counts = nlohmann::json::parse(read(character / "skeletons.json"));
    CHECK(counts["voronoi"]["status"] == "the skeleton is a single point");
    CHECK(counts["voronoi"]["vertices"] == 0);
    CHECK(counts["chordal"]["status"] == "the skeleton is a single point");
    CHECK(counts["straight"]["status"] == "ok");
}

TEST_CASE("--compare needs the drawing, and writes nothing when the step itself cannot go on",
          "[cli][skeleton]") {
    const TemporaryFolder folder;
    copy_demo(folder / "out");
    const fs::path character = folder / "out/character-1";
    const std::string drawing = read(character / "drawing.png");
    fs::remove(character / "drawing.png");
    const Outcome missing = run_pantin({"skeletonize", character.string(), "--compare"});
    CHECK(missing.code == 3);
    CHECK(missing.err.find("drawing.png") != std::string::npos);
    CHECK(missing.err.find('\n') == missing.err.size() - 1);
    write(character / "drawing.png", drawing);
    const GreyImage labels = load_grey(character / "labels.png");
    save_png(character / "labels.png", GreyImage(labels.width(), labels.height(), 0));
    const Outcome rejected = run_pantin({"skeletonize", character.string(), "--compare"});
    CHECK(rejected.code == 7);
    CHECK(rejected.err.find('\n') == rejected.err.size() - 1);
    CHECK_FALSE(fs::exists(character / "skeletons.png"));
    CHECK_FALSE(fs::exists(character / "skeletons.json"));
    CHECK(run_pantin({"skeletonize", "--help"}).out.find("--compare") != std::string::npos);
}
