// SPDX-License-Identifier: MIT
// Characters from end to end: what `animate --trace` stored of each stage against what the thesis says,
// computed anew from the stage before it by simple code of its own. A few drawings in every run; [.replay]
// takes 40 generated ones, and PANTIN_REPLAY_LABELS names a folder of label maps (0 to 5) for
// [.replay-labels].
#include <algorithm>
#include <cstdlib>
#include <functional>

#include <catch2/catch.hpp>

#include "doodle/doodle.hpp"
#include "pantin/image.hpp"
#include "replay/stored.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"

namespace pantin::test::replay {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void replay_all(const Stored& stored, Tally& tally) {
    replay_shape(stored, tally);
    replay_voronoi(stored, tally);
    replay_thinning(stored, tally);
    replay_graph(stored, tally);
    replay_distance(stored, tally);
    replay_mapping(stored, tally);
    replay_mesh(stored, tally);
    replay_weights(stored, tally);
}

// Animates with --trace and small films; the folders of the characters with a skeleton.
std::vector<fs::path> animate(const fs::path& page, const fs::path& out, const std::string& preset,
                              const Words& more) {
    Words words = {"animate", page.string(), "-o", out.string(), "--trace", "--preset", preset, "--format",
                   "png",     "--size",      "16", "--fps",      "1",       "--clip",   "idle", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_pantin(words);
    INFO(outcome.err);
    CHECK((outcome.code == 0 || outcome.code == 4 || outcome.code == 7));
    std::vector<fs::path> folders;
    for (int i = 1; fs::exists(out / ("character-" + std::to_string(i))); ++i)
        if (const fs::path folder = out / ("character-" + std::to_string(i));
            fs::exists(folder / "skeleton.json"))
            folders.push_back(folder);
    return folders;
}

// Both presets; the number of characters replayed.
int replay_page(const fs::path& page, const std::string& name, Tally& tally, const Words& more = {}) {
    int count = 0;
    for (const std::string preset : {"default", "thesis"}) {
        TemporaryFolder out;
        for (const fs::path& folder : animate(page, out.path(), preset, more)) {
            tally.start(name + " " + preset + " " + folder.filename().string());
            replay_all(read_stored(folder, preset == "thesis"), tally);
            ++count;
        }
    }
    return count;
}

doodle::Page drawing(std::uint64_t seed) {
    const std::vector<std::string>& types = doodle::character_types();
    return doodle::draw_page({types[seed % types.size()]}, 3100 + seed);
}

int replay_drawings(std::uint64_t count, Tally& tally) {
    int characters = 0;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        TemporaryFolder folder;
        save_png(folder / "page.png", drawing(seed).picture);
        characters += replay_page(folder / "page.png", "drawing " + std::to_string(seed), tally);
    }
    return characters;
}

void check(const Tally& tally) {
    for (const std::string& miss : tally.misses()) FAIL_CHECK(miss);
}

} // namespace

TEST_CASE("every traced stage is what the thesis makes of the stage before it", "[replay][end-to-end]") {
    Tally tally;
    CHECK(replay_drawings(3, tally) >= 4);
    check(tally);
    for (const char* stage :
         {"raster: equal", "H2", "mapping: costs", "mesh: faces", "weights: Algorithm 4.4"})
        CHECK(tally.of(stage) >= 2);
}

TEST_CASE("the same of 40 generated drawings", "[.replay]") {
    Tally tally;
    const int characters = replay_drawings(40, tally);
    WARN(characters << " characters\n" << tally.table());
    check(tally);
}

TEST_CASE("the same of given label maps", "[.replay-labels]") {
    const char* given = std::getenv("PANTIN_REPLAY_LABELS");
    REQUIRE(given);
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(given)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    Tally tally;
    int characters = 0;
    for (std::size_t i = 0; i < files.size(); i += std::max<std::size_t>(1, files.size() / 40)) {
        TemporaryFolder folder;
        const GreyImage labels = load_grey(files[i]);
        GreyImage mask = labels, page = labels;
        for (auto& pixel : mask) pixel = pixel ? 255 : 0;
        for (auto& pixel : page) pixel = pixel ? 60 : 255;
        save_png(folder / "mask.png", mask);
        save_png(folder / "page.png", page);
        characters += replay_page(folder / "page.png", files[i].stem().string(), tally,
                                  {"--mask", folder / "mask.png", "--labels", files[i]});
    }
    WARN(characters << " characters\n" << tally.table());
    check(tally);
}

TEST_CASE("the replay notices what is wrong", "[replay][end-to-end]") {
    TemporaryFolder folder;
    save_png(folder / "page.png", drawing(0).picture);
    const std::vector<fs::path> found = animate(folder / "page.png", folder.path() / "out", "thesis", {});
    REQUIRE(found.size() == 1);
    const Stored sound = read_stored(found[0], true);
    const auto flip = [](Mask& mask) { // a pixel beside the first one
        auto pixel = std::find(mask.begin(), mask.end(), 1);
        *(pixel - 1) = 1;
    };
    const std::map<std::string, std::function<void(Stored&)>> damages = {
        {"silhouette", [&](Stored& s) { flip(s.silhouette); }},
        {"borders: pixels and passes", [](Stored& s) { s.borders[0].pop_back(); }},
        {"Voronoi diagram", [](Stored& s) { s.voronoi_edges.erase(s.voronoi_edges.size() / 2); }},
        {"residuals", [](Stored& s) { s.voronoi_edges[3]["residual"] = 0.5; }},
        {"raster: equal", [&](Stored& s) { flip(s.voronoi); }},
        {"Zhang-Suen", [&](Stored& s) { flip(s.thinned); }},
        {"redundant pixels", [&](Stored& s) { flip(s.skeleton); }},
        {"graph of the skeleton", [](Stored& s) { s.raw.edges.pop_back(); }},
        {"H1", [](Stored& s) { s.after_h1.vertices[0].x += 1; }},
        {"H2", [](Stored& s) { s.graph.vertices[0].label = "wing"; }},
        {"graph distance: that of its matching",
         [](Stored& s) { s.identification["candidates"][0]["distance"] = 0.1; }},
        {"graph distance: none is smaller",
         [](Stored& s) { s.identification["candidates"][0]["distance"] = 100; }},
        {"mapping: costs", [](Stored& s) { s.mapping["costs"][0][0] = 100; }},
        {"mapping: cheapest assignment", [](Stored& s) { s.mapping["pairs"][0]["cost"] = 100; }},
        {"mesh: faces", [](Stored& s) { s.faces.pop_back(); }},
        {"texture coordinates", [](Stored& s) { s.texture[0].x += 0.01; }},
        {"weights: Algorithm 4.4",
         [](Stored& s) {
             s.weights[0] = {{1, 0.5}, {2, 0.5}};
         }},
    };
    for (const auto& [stage, damage] : damages) {
        INFO(stage);
        Stored damaged = sound;
        damage(damaged);
        Tally tally;
        replay_all(damaged, tally);
        CHECK(std::any_of(tally.misses().begin(), tally.misses().end(), [&](const std::string& miss) {
            return miss.find(": " + stage) != std::string::npos;
        }));
    }
}

} // namespace pantin::test::replay
