// SPDX-License-Identifier: MIT
// Steps that the user overrules: --mask, --labels, --reference.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Page-sized pictures of the second character of the animated demo, made of its folder.
struct Second {
    TemporaryFolder folder;
    fs::path source = animated_demo() / "character-2", labels = folder / "labels.png",
             mask = folder / "mask.png";
    Box box;
    GreyImage whole;
    Second() {
        const Json page = Json::parse(read(animated_demo() / "page.json"));
        const Json& b = page["characters"][1]["box"];
        box = {b[0], b[1], b[2], b[3]};
        const GreyImage small = resize_nearest(load_grey(source / "labels.png"), box.width, box.height);
        whole = GreyImage(page["width"], page["height"], 0);
        for (int y = 0; y < box.height; ++y)
            for (int x = 0; x < box.width; ++x) whole(box.x + x, box.y + y) = small(x, y);
        save_png(labels, whole);
        GreyImage white = whole;
        for (std::uint8_t& pixel : white) pixel = pixel ? 255 : 0;
        save_png(mask, white);
    }
    fs::path out() const { return folder / "out"; }
    Outcome animate(const std::vector<std::string>& more) const {
        return run_pantin(std::vector<std::string>{"animate", demo_page, "-o", out().string()} + more +
                          small_films);
    }
};

} // namespace

TEST_CASE("--labels skips detection and segmentation: one character with those labels", "[cli][given]") {
    const Second second;
    REQUIRE(second.animate({"--labels", second.labels.string()}).code == 0);
    const Json page = Json::parse(read(second.out() / "page.json"));
    CHECK(page["detector"] == "given");
    REQUIRE(page["characters"].size() == 1);
    const Json box = page["characters"][0]["box"];
    const GreyImage made = load_grey(second.out() / "character-1/labels.png");
    REQUIRE(made.width() == box[2]); // a small character: working pixels are the page's
    for (int y = 0; y < made.height(); ++y)
        for (int x = 0; x < made.width(); ++x)
            REQUIRE(made(x, y) == second.whole(box[0].get<int>() + x, box[1].get<int>() + y));
    CHECK_FALSE(fs::exists(second.out() / "character-1/segmentation.json"));
    CHECK(fs::exists(second.out() / "character-1/character.glb"));
}

TEST_CASE("--mask skips detection: the character is where the mask is", "[cli][given]") {
    const Second second;
    REQUIRE(second.animate({"--mask", second.mask.string()}).code == 0);
    const Json page = Json::parse(read(second.out() / "page.json"));
    REQUIRE(page["characters"].size() == 1);
    CHECK(page["characters"][0]["score"] == 1);
    long area = 0, wanted = 0;
    for (const std::uint8_t v : load_grey(second.out() / "character-1/mask.png")) area += v != 0;
    for (const std::uint8_t v : second.whole) wanted += v != 0;
    CHECK(area == wanted);
    CHECK(fs::exists(second.out() / "character-1/segmentation.json"));
}

TEST_CASE("A given mask is the silhouette to the pixel, also when a step runs alone", "[cli][given]") {
    const Second second;
    GreyImage mask = second.whole;
    for (std::uint8_t& v : mask) v = v ? 255 : 0;
    for (int y = 0; y < 12; ++y) // an ear that is not drawn
        for (int x = 0; x < 12; ++x) {
            int top = 0;
            while (top < mask.height() && mask(second.box.x + second.box.width / 2, top) == 0) ++top;
            mask(second.box.x + second.box.width / 2 + x, std::max(0, top - 6) + y) = 255;
        }
    save_png(second.mask, mask);
    REQUIRE(second.animate({"--mask", second.mask.string()}).code == 0);
    const fs::path character = second.out() / "character-1";
    const auto silhouette = [&] {
        GreyImage labels = load_grey(character / "labels.png");
        for (std::uint8_t& v : labels) v = v ? 255 : 0;
        return labels;
    };
    const GreyImage given = load_grey(character / "mask.png");
    CHECK(silhouette() == given);
    CHECK(Json::parse(read(second.out() / "page.json"))["characters"][0]["exact_mask"] == true);
    fs::remove(character / "labels.png");
    REQUIRE(run_pantin({"segment", character.string()}).code == 0);
    CHECK(silhouette() == given);
}

TEST_CASE("--only animates the characters of those numbers; page.png shows which they are", "[cli][given]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    REQUIRE(run_pantin(std::vector<std::string>{"animate", "--only", "2", demo_page, "-o", out} + small_films)
                .code == 0);
    const Json page = Json::parse(read(folder / "out/page.json"));
    const std::size_t count = page["characters"].size();
    for (std::size_t i = 0; i < count; ++i) {
        INFO(i + 1);
        CHECK((page["characters"][i]["status"] == "ok") == (i == 1));
        const fs::path glb = folder / "out" / ("character-" + std::to_string(i + 1)) / "character.glb";
        CHECK(fs::exists(glb) == (i == 1));
    }
    const RgbImage overview = load_image(folder / "out/page.png");
    CHECK(std::max(overview.width(), overview.height()) <= 1024);
    CHECK(overview != resize(load_image(demo_page), overview.width(), overview.height()));
    const Outcome beyond = run_pantin({"animate", demo_page, "-o", out, "--only", "1,9"});
    CHECK(beyond.code == 2);
    CHECK(beyond.err.find("--only 9") != std::string::npos);
}

TEST_CASE(
    "A cut-out keeps its silhouette; a sheet with a transparent rim is a page; white lines stand on dark",
    "[cli][given]") {
    const TemporaryFolder folder;
    const RgbImage drawn = load_image(small_page);
    const auto run = [&](const RgbaImage& picture) {
        save_png(folder / "cut.png", picture);
        fs::remove_all(folder / "out");
        REQUIRE(run_pantin(std::vector<std::string>{"detect", (folder / "cut.png").string(), "-o",
                                                    (folder / "out").string()})
                    .code == 0);
        const Json page = Json::parse(read(folder / "out/page.json"));
        REQUIRE(page["characters"].size() == 1);
        return page["characters"][0].contains("exact_mask");
    };
    RgbaImage rim(drawn.width(), drawn.height()), lines = rim, faint = rim;
    for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x) {
            const Rgb8 c = drawn(x, y);
            const bool inside = x > 2 && y > 2 && x + 3 < drawn.width() && y + 3 < drawn.height();
            const bool ink = c.r < 128;
            rim(x, y) = {c.r, c.g, c.b, static_cast<std::uint8_t>(inside ? 255 : 0)};
            lines(x, y) = {255, 255, 255, static_cast<std::uint8_t>(ink ? 255 : 0)};
            faint(x, y) = {c.r, c.g, c.b, static_cast<std::uint8_t>(ink ? 100 : 0)};
        }
    CHECK_FALSE(run(rim));
    const GreyImage on_paper = load_grey(folder / "out/character-1/mask.png");
    long whole = 0;
    for (std::uint8_t v : on_paper) whole += v != 0;
    CHECK(whole < 0.8 * static_cast<double>(on_paper.size())); // the figure, not the sheet
    run(lines);
    const RgbImage shown = load_image(folder / "out/character-1/drawing.png", 1);
    CHECK(std::count(shown.begin(), shown.end(), Rgb8{255, 255, 255}) > 0);
    CHECK(2 * std::count(shown.begin(), shown.end(), Rgb8{255, 255, 255}) < static_cast<long>(shown.size()));
    run(faint);
}

TEST_CASE("A page.png that no run wrote is the user's", "[cli][given]") {
    const TemporaryFolder folder;
    fs::copy_file(small_page, folder / "page.png");
    const std::string before = read(folder / "page.png");
    const std::vector<std::string> run =
        std::vector<std::string>{"animate", (folder / "page.png").string(), "-o", folder.path().string()} +
        small_films;
    for (int round = 0; round < 2; ++round) {
        REQUIRE(run_pantin(run).code == 0);
        CHECK(read(folder / "page.png") == before);
    }
}

TEST_CASE("--rotate turns the given pictures with the page", "[cli][given]") {
    const Second second;
    REQUIRE(second.animate({"--labels", second.labels.string(), "--rotate", "180"}).code == 0);
    const Json box = Json::parse(read(second.out() / "page.json"))["characters"][0]["box"];
    const int right = box[0].get<int>() + box[2].get<int>();
    CHECK(std::abs(second.whole.width() - right - second.box.x) <= 12); // margins may differ
}

TEST_CASE("--reference decides what the characters move like", "[cli][given]") {
    const Second second;
    REQUIRE(second.animate({"--labels", second.labels.string(), "--reference", "flying"}).code == 0);
    CHECK(Json::parse(read(second.out() / "character-1/identification.json"))["reference"] == "flying");
}

TEST_CASE("Given pictures that do not fit are one line, exit code 3 and no files", "[cli][given]") {
    const Second second;
    const std::string other = (second.folder / "other.png").string();
    const auto refused = [&](const std::vector<std::string>& more, const std::string& what) {
        const Outcome outcome = second.animate(more);
        CAPTURE(outcome.err);
        CHECK(outcome.code == 3);
        CHECK(outcome.err.find(what) != std::string::npos);
        CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
        CHECK_FALSE(fs::exists(second.out()));
    };
    save_png(other, GreyImage(33, 44, 255));
    refused({"--mask", other}, "other.png: is 33×44 pixels, but testdata/demo.png is 840×600");
    save_png(other, GreyImage(840, 600, 0));
    refused({"--mask", other}, "other.png: has no pixel of the character");
    save_png(other, GreyImage(840, 600, 9));
    refused({"--labels", other}, "other.png: pixel (0, 0) has the value 9");
    refused({"--reference", "dragon"}, "there is no reference 'dragon' (humanoid, quadruped, flying");
    const Outcome two =
        run_pantin({"animate", demo_page, small_page, "-o", second.out().string(), "--mask", other});
    CHECK(two.code == 2);
}
