// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "export/glb_file.hpp"
#include "pantin/export.hpp"
#include "pantin/identification.hpp"
#include "pantin/image.hpp"
#include "support/films.hpp"

using namespace pantin;
using namespace pantin::test;
using Json = nlohmann::ordered_json;

namespace {

namespace fs = std::filesystem;

std::vector<unsigned char> bytes_of(const fs::path& file) {
    const std::string text = read(file);
    return {text.begin(), text.end()};
}

Json json_of(const fs::path& file) { return Json::parse(read(file)); }

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}
using Keys = std::vector<std::string>;

std::vector<fs::path> demo_characters() {
    std::vector<fs::path> folders;
    const Json page = json_of(animated_demo() / "page.json"); // a temporary would not outlive the range
    for (const Json& character : page["characters"])
        folders.push_back(animated_demo() / character["folder"].get<std::string>());
    return folders;
}

// The clips of the reference that a character was identified as.
std::vector<std::string> clips_of(const fs::path& folder) {
    const std::string name = json_of(folder / "identification.json")["reference"];
    std::vector<std::string> clips;
    for (const ReferenceSkeleton& reference : load_references())
        if (reference.name == name)
            for (const ReferenceClip& clip : reference.clips) clips.push_back(clip.name);
    return clips;
}

// Of every clip without --format.
const std::string film_ending = webp_available() ? ".webp" : ".apng";

} // namespace

TEST_CASE("animate writes exactly the documented files", "[cli][end-to-end]") {
    std::set<std::string> expected = {"page.json", "page.png"}, found;
    for (const fs::path& folder : demo_characters()) {
        std::vector<std::string> files = {
            "drawing.png",  "ink.png",      "mask.png",      "labels.png",          "segmentation.json",
            "contour.json", "skeleton.png", "skeleton.json", "identification.json", "mapping.json",
            "mesh.obj",     "mesh.mtl",     "weights.txt",   "character.glb"};
        if (gif_available()) files.push_back("animation.gif");
        const std::vector<std::string> clips = clips_of(folder);
        for (std::size_t i = 0; i < clips.size(); ++i)
            files.push_back(i == 0 ? "animation" + film_ending : "animation-" + clips[i] + film_ending);
        for (const std::string& file : files) expected.insert(folder.filename().string() + "/" + file);
    }
    for (const auto& [name, bytes] : read_all(animated_demo())) {
        found.insert(name);
        CHECK_FALSE(bytes.empty());
    }
    CHECK(found == expected);
}

TEST_CASE("The demo page has a humanoid, a quadruped and a flyer, and all are recognised",
          "[cli][end-to-end]") {
    std::multiset<std::string> types;
    for (const fs::path& folder : demo_characters())
        types.insert(json_of(folder / "identification.json")["reference"].get<std::string>());
    for (const std::string type : {"humanoid", "quadruped", "flying"}) CHECK(types.count(type) >= 1);
    const Json page = json_of(animated_demo() / "page.json"); // a temporary would not outlive the range
    for (const Json& character : page["characters"]) CHECK(character["status"] == "ok");
}

TEST_CASE("Every JSON file has the documented keys in their order", "[cli][end-to-end]") {
    const Json page = json_of(animated_demo() / "page.json");
    CHECK(keys_of(page) == Keys{"source", "width", "height", "detector", "characters"});
    CHECK(page["source"] == "demo.png");
    for (const Json& character : page["characters"]) {
        Keys keys = {"folder", "box", "scale", "score", "status", "type", "confidence", "second"};
        if (character.contains("warnings")) keys.push_back("warnings"); // only where there are any
        CHECK(keys_of(character) == keys);
    }
    for (const fs::path& folder : demo_characters()) {
        const Json segmentation = json_of(folder / "segmentation.json");
        CHECK(keys_of(segmentation) ==
              Keys{"expert", "router", "sureness", "stroke_ratio", "pose", "type", "areas"});
        CHECK(keys_of(segmentation["type"]) == Keys{"humanoid", "quadruped", "flying", "other"});
        CHECK(keys_of(segmentation["areas"]) == Keys{"background", "head", "body", "limb", "tail", "wing"});
        CHECK(keys_of(segmentation["pose"]) == Keys{"E", "NE", "N", "NW", "W", "SW", "S", "SE"});
        const Json contour = json_of(folder / "contour.json");
        CHECK(keys_of(contour) == Keys{"borders"});
        CHECK(keys_of(contour["borders"].at(0)) == Keys{"outer", "parent", "points"});
        const Json skeleton = json_of(folder / "skeleton.json");
        CHECK(keys_of(skeleton) == Keys{"width", "height", "vertices", "edges"});
        CHECK(keys_of(skeleton["vertices"].at(0)) == Keys{"id", "x", "y", "label", "kind"});
        CHECK(keys_of(skeleton["edges"].at(0)) == Keys{"u", "v", "length", "pixels"});
        const Json identification = json_of(folder / "identification.json");
        CHECK(keys_of(identification) == Keys{"reference", "type", "confidence", "candidates"});
        for (const Json& candidate : identification["candidates"])
            CHECK(keys_of(candidate) ==
                  Keys{"reference", "mirrored", "distance", "score", "evidence", "optimal", "pairs"});
        const Json mapping = json_of(folder / "mapping.json");
        CHECK(keys_of(mapping) == Keys{"pairs", "costs"});
        CHECK(keys_of(mapping["pairs"].at(0)) == Keys{"end", "reference_end", "cost"});
    }
}

TEST_CASE("Pictures of a character fit together", "[cli][end-to-end]") {
    const Json page = json_of(animated_demo() / "page.json");
    for (const Json& character : page["characters"]) {
        const fs::path folder = animated_demo() / character["folder"].get<std::string>();
        const RgbImage drawing = load_image(folder / "drawing.png", 1);
        CHECK(drawing.width() == character["box"][2]);
        CHECK(drawing.height() == character["box"][3]);
        const GreyImage mask = load_grey(folder / "mask.png"), labels = load_grey(folder / "labels.png"),
                        skeleton = load_grey(folder / "skeleton.png");
        CHECK(std::max(mask.width(), mask.height()) <= 512);
        CHECK(labels.width() == mask.width());
        CHECK(labels.height() == mask.height());
        CHECK(skeleton.width() == mask.width());
        for (const std::uint8_t value : mask) REQUIRE((value == 0 || value == 255));
        for (const std::uint8_t value : labels) REQUIRE(value < label_count);
        for (int y = 0; y < skeleton.height(); ++y)
            for (int x = 0; x < skeleton.width(); ++x)
                if (skeleton(x, y) != 0) REQUIRE(labels(x, y) != 0);
    }
}

TEST_CASE("character.glb has one clip per clip of the reference, weights that sum to one, one root",
          "[cli][end-to-end]") {
    for (const fs::path& folder : demo_characters()) {
        const GlbFile glb(bytes_of(folder / "character.glb"));
        std::vector<std::string> names;
        for (const auto& animation : glb.json["animations"]) names.push_back(animation["name"]);
        CHECK(names == clips_of(folder));
        const auto& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
        const auto weights = glb.read(attributes["WEIGHTS_0"]), joints = glb.read(attributes["JOINTS_0"]);
        const std::size_t joint_count = glb.json["skins"][0]["joints"].size();
        for (std::size_t v = 0; v + 3 < weights.size(); v += 4) {
            REQUIRE(std::abs(weights[v] + weights[v + 1] + weights[v + 2] + weights[v + 3] - 1) < 1e-7);
            for (std::size_t k = 0; k < 4; ++k) REQUIRE(joints[v + k] < static_cast<double>(joint_count));
        }
        // Every joint but the first is the child of exactly one.
        std::vector<int> parents(glb.json["nodes"].size(), 0);
        for (const auto& node : glb.json["nodes"])
            if (node.contains("children"))
                for (const std::size_t child : node["children"]) ++parents[child];
        for (std::size_t n = 0; n < parents.size(); ++n) CHECK(parents[n] == (n < 2 ? 0 : 1));
        const auto p = glb.read(attributes["POSITION"]),
                   index = glb.read(glb.json["meshes"][0]["primitives"][0]["indices"]);
        REQUIRE_FALSE(index.empty());
        for (std::size_t i = 0; i < index.size(); i += 3) {
            const auto at = [&](std::size_t k, std::size_t c) {
                return p[3 * static_cast<std::size_t>(index[i + k]) + c];
            };
            REQUIRE((at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) -
                        (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1)) >
                    -1e-12);
        }
    }
}

TEST_CASE("mesh.obj and weights.txt speak of the same vertices", "[cli][end-to-end]") {
    for (const fs::path& folder : demo_characters()) {
        std::size_t vertices = 0, texture = 0, lines = 0, bones = 0;
        std::istringstream obj(read(folder / "mesh.obj"));
        std::vector<std::string> faces;
        for (std::string line; std::getline(obj, line);) {
            if (line.starts_with("v ")) ++vertices;
            if (line.starts_with("vt ")) ++texture;
            if (line.starts_with("f ")) faces.push_back(line.substr(2));
        }
        for (const std::string& face : faces) {
            std::istringstream corners(face);
            std::size_t count = 0;
            for (std::string corner; corners >> corner; ++count) {
                const std::size_t slash = corner.find('/');
                const std::size_t v = std::stoul(corner.substr(0, slash)),
                                  t = std::stoul(corner.substr(slash + 1));
                REQUIRE((v >= 1 && v <= vertices && t == v));
            }
            REQUIRE((count >= 3 && count <= 6));
        }
        std::istringstream weights(read(folder / "weights.txt"));
        for (std::string line; std::getline(weights, line);) {
            if (line.starts_with("bone ")) ++bones;
            if (line.starts_with("v ")) ++lines;
        }
        CHECK(vertices > 20);
        CHECK(texture == vertices);
        CHECK(lines == vertices);
        CHECK(bones >= 2);
        CHECK(read(folder / "mesh.mtl").find("drawing.png") != std::string::npos);
    }
}

TEST_CASE("The films move, loop for ever and have legal delays", "[cli][end-to-end][needs-webp][needs-gif]") {
    for (const fs::path& folder : demo_characters()) {
        const Film gif = read_gif(bytes_of(folder / "animation.gif"));
        CHECK(gif.loops_for_ever);
        CHECK(gif.frames.size() >= 3);
        for (const int delay : gif.delays) CHECK(delay >= 2);
        CHECK_FALSE(gif.frames[0] == gif.frames[1]);
        CHECK(gif.frames[0](0, 0).a == 0);
        const Film webp = read_webp(bytes_of(folder / "animation.webp"));
        CHECK(webp.loops_for_ever);
        CHECK(webp.frames.size() >= 3);
        CHECK(std::max(webp.frames[0].width(), webp.frames[0].height()) == 64);
        CHECK_FALSE(webp.frames[0] == webp.frames[1]);
    }
}

TEST_CASE("Results do not depend on the number of threads", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const Outcome outcome = run_pantin(
        std::vector<std::string>{"animate", demo_page, "-o", out.string(), "--threads", "2", "--quiet"} +
        small_films);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
    CHECK(read_all(out) == read_all(animated_demo()));
}

TEST_CASE("The steps one by one give the same bytes as animate", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    REQUIRE(run_pantin({"detect", demo_page, "-o", out.string()}).code == 0);
    for (const fs::path& character : demo_characters()) {
        const std::string name = (out / character.filename()).string();
        for (const std::string step : {"segment", "skeletonize", "identify", "rig"})
            REQUIRE(run_pantin({step, name}).code == 0);
        REQUIRE(run_pantin(std::vector<std::string>{"render", name + "/"} + small_films).code == 0);
    }
    const auto ours = read_all(out), wanted = read_all(animated_demo());
    REQUIRE(ours.size() == wanted.size());
    for (const auto& [name, bytes] : wanted) {
        CAPTURE(name);
        REQUIRE(ours.count(name) == 1);
        CHECK((ours.at(name) == bytes));
    }
}

TEST_CASE("A page that lies on its side is turned by --rotate before anything else", "[cli]") {
    const TemporaryFolder folder;
    const RgbImage upright = load_image("testdata/humanoid.png");
    save_png(folder / "side.png", turned(upright, 90));
    const std::string sideways = (folder / "side.png").string(), out = (folder / "out").string(),
                      wanted = (folder / "wanted").string();
    REQUIRE(run_pantin({"detect", sideways, "--rotate", "270", "-o", out}).code == 0);
    REQUIRE(run_pantin({"detect", "testdata/humanoid.png", "-o", wanted}).code == 0);
    for (const std::string file : {"/character-1/drawing.png", "/character-1/mask.png"})
        CHECK((read(out + file) == read(wanted + file)));
    const Json page = json_of(fs::path(out) / "page.json");
    CHECK(page["rotate"] == 270);
    CHECK(page["width"] == upright.width());
    CHECK(run_pantin({"detect", sideways, "--rotate", "45", "-o", out}).code == 2);
}

TEST_CASE("A page on its side or upside down is noticed, turned and told", "[cli]") {
    const TemporaryFolder folder;
    const RgbImage upright = load_image("testdata/quadruped.png");
    const std::string out = (folder / "out").string(), wanted = (folder / "wanted").string();
    for (const int degrees : {90, 180, 270}) {
        CAPTURE(degrees);
        const std::string file = (folder / ("held" + std::to_string(degrees) + ".png")).string();
        save_png(file, turned(upright, degrees));
        const Outcome run = run_pantin({"detect", file, "-o", out});
        REQUIRE(run.code == 0);
        CHECK(run.out.find("is turned clockwise by " + std::to_string(360 - degrees) + " degrees") !=
              std::string::npos);
        CHECK(json_of(fs::path(out) / "page.json")["rotate"] == 360 - degrees);
        REQUIRE(run_pantin({"detect", file, "--rotate", std::to_string(360 - degrees), "-o", wanted}).code ==
                0);
        CHECK((read_all(out) == read_all(wanted)));
        REQUIRE(run_pantin({"detect", file, "--rotate", "0", "-o", out}).code == 0);
        CHECK(json_of(fs::path(out) / "page.json").count("rotate") == 0);
    }
    const std::string side = (folder / "held90.png").string();
    REQUIRE(run_pantin({"detect", side, "--preset", "thesis", "-o", out}).code == 0);
    CHECK(json_of(fs::path(out) / "page.json").count("rotate") == 0);
    for (const char* page :
         {"demo.png", "humanoid.png", "flying.png", "photo.jpg", "dog.png", "person.png"}) {
        CAPTURE(page);
        REQUIRE(run_pantin({"detect", std::string("testdata/") + page, "-o", out}).code == 0);
        CHECK(json_of(fs::path(out) / "page.json").count("rotate") == 0);
    }
}

TEST_CASE("A second run replaces the characters of the first and leaves other files alone",
          "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    copy_demo(out);
    write(out / "notes.txt", "mine");
    write(out / "character-2/notes.txt", "mine, too");
    save_png(folder / "dots.png", RgbImage(100, 100, Rgb8{255, 255, 255}));
    CHECK(run_pantin({"detect", (folder / "dots.png").string(), "-o", out.string()}).code == 4);
    CHECK(fs::exists(out / "character-1/character.glb")); // a page without characters replaces nothing
    REQUIRE(run_pantin({"detect", demo_page, "-o", out.string()}).code == 0);
    std::set<std::string> left;
    for (const auto& [name, bytes] : read_all(out / "character-2")) left.insert(name);
    CHECK(left == std::set<std::string>{"drawing.png", "ink.png", "mask.png", "notes.txt"});
    CHECK(read(out / "notes.txt") == "mine");
}

TEST_CASE("Several pages go to a folder each, and a bad one does not stop the others", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    fs::create_directory(folder / "more");
    fs::copy(small_page, folder / "more/humanoid.png");
    const Outcome outcome =
        run_pantin(std::vector<std::string>{"animate", (folder / "missing.png").string(), small_page,
                                            (folder / "more/humanoid.png").string(), "-o", out.string(),
                                            "--clip", "idle", "--format", "png"} +
                   small_films);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.starts_with("pantin: "));
    CHECK(outcome.err.find("missing.png") != std::string::npos);
    CHECK(fs::exists(out / "humanoid/character-1/frames/idle/0001.png"));
    CHECK_FALSE(fs::exists(out / "humanoid/character-1/animation.webp"));
    CHECK((read_all(out / "humanoid") == read_all(out / "humanoid-2")));
}

TEST_CASE("The thesis rejects nothing: a head, a scribble and a blob are animated, or rest",
          "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const Outcome outcome = run_pantin(
        std::vector<std::string>{"animate", "testdata/rejects.png", "-o", (folder / "out").string(),
                                 "--preset", "thesis", "--format", "png", "--size", "32", "--fps", "2"});
    CHECK(outcome.code == 0);
    const auto page = nlohmann::ordered_json::parse(read(folder / "out/page.json"));
    REQUIRE(page["characters"].size() >= 2);
    for (const auto& character : page["characters"]) {
        CHECK(character["status"] == "ok");
        CHECK(fs::exists(folder / "out" / character["folder"].get<std::string>() / "character.glb"));
    }
}

TEST_CASE("--trace adds the intermediate products and changes nothing else", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const auto files_of = [&](const std::string& name, const std::vector<std::string>& more) {
        const fs::path out = folder / name;
        const Outcome outcome = run_pantin(
            std::vector<std::string>{"animate", small_page, "-o", out.string()} + small_films + more);
        REQUIRE(outcome.code == 0);
        return read_all(out);
    };
    auto traced = files_of("traced", {"--trace"});
    for (const std::string file :
         {"silhouette.png", "voronoi.json", "voronoi.png", "thinned.png", "skeleton-raw.json",
          "skeleton-h1.json", "probability-head.png", "mask-ink.png", "mask-network.png"})
        CHECK(traced.count("character-1/trace/" + file) == 1);
    CHECK(traced.count("trace/ink.png") == 1);
    std::erase_if(traced, [](const auto& file) { return file.first.find("trace/") != std::string::npos; });
    CHECK((traced == files_of("plain", {})));
}

TEST_CASE("The thesis preset runs end to end at its own size", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const Outcome outcome =
        run_pantin(std::vector<std::string>{"animate", small_page, "-o", out.string(), "--preset", "thesis"} +
                   small_films);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    const GreyImage labels = load_grey(out / "character-1/labels.png");
    CHECK(std::max(labels.width(), labels.height()) <= 321);
    CHECK(json_of(out / "character-1/identification.json")["candidates"].at(0)["evidence"].empty());
}
