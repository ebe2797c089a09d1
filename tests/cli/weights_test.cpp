// SPDX-License-Identifier: MIT
// --weights: the files of a folder choose the networks, from the page to segmentation.json. Small networks
// with random weights, so what they say means nothing, but it must be what they say.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "formats/pictures.hpp"
#include "pantin/detection.hpp"
#include "pantin/image.hpp"
#include "pantin/options.hpp"
#include "pantin/segmentation.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"
#include "support/state_dictionary.hpp"
#include "support/weight_files.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* page = "testdata/dog.png";

// A folder with the two small networks, and one to write to. Whatever the detector finds is taken, and
// nothing is a scribble.
struct Setup {
    TemporaryFolder folder;
    Setup() {
        fs::create_directories(folder / "weights");
        fs::copy_file("testdata/sketch_parse_tiny.safetensors", segmenter());
        fs::copy_file("testdata/mask_rcnn_tiny.safetensors", detector());
        write(
            folder / "config.json",
            R"({"detection.network_score": 0, "detection.max_characters": 3, "segmentation.least_confidence": 0, "segmentation.tilt": 0})");
    }
    fs::path segmenter() const { return folder / "weights/segmenter.safetensors"; }
    fs::path detector() const { return folder / "weights/detector.safetensors"; }
    fs::path out() const { return folder / "out"; }
    Outcome run(const std::vector<std::string>& words) const {
        std::vector<std::string> all = words;
        for (const fs::path& word :
             {fs::path("--weights"), folder / "weights", fs::path("--config"), folder / "config.json"})
            all.push_back(word.string());
        return run_pantin(all);
    }
    Options options(const std::string& preset) const {
        Options options = make_preset(preset);
        apply_config(options, folder / "config.json");
        return options;
    }
};

// The step's files are those of a direct call of that network on the folder's drawing and mask.
void check_segmented(const fs::path& character, const fs::path& weights, const SegmentationOptions& options) {
    const Segmenter network(read_file(weights), weights.string());
    GreyImage mask = load_grey(character / "mask.png");
    for (std::uint8_t& pixel : mask) pixel = pixel >= 128;
    const Segmentation expected =
        network.segment(read_ink(character, load_image(character / "drawing.png", 1)), mask, options);
    const Json json = Json::parse(read(character / "segmentation.json"));
    CHECK(json["expert"] == expected.expert);
    CHECK(json["router"].size() == expected.router.size());
    for (const auto& [name, probability] : expected.router) CHECK(json["router"][name] == probability);
    CHECK(json["sureness"] == expected.confidence);
    for (std::size_t i = 0; i < pose_names.size(); ++i)
        CHECK(json["pose"][pose_names[i]] == expected.pose[i]);
    CHECK(load_grey(character / "labels.png") == expected.labels);
}

Bytes bytes_of(const fs::path& file) { return read_file(file); }
void write_bytes(const fs::path& file, const Bytes& bytes) {
    write(file, std::string(bytes.begin(), bytes.end()));
}

// The page's characters and their parts are those of direct calls of the folder's networks. Returns how many
// there are.
std::size_t check_animated(const Setup& setup, const std::string& preset, const std::string& expert) {
    const Outcome outcome = setup.run({"animate", page, "-o", setup.out().string(), "--preset", preset});
    INFO(outcome.err);
    CHECK((outcome.code == 0 || outcome.code == 7)); // random labels may not make a character that moves

    const Options options = setup.options(preset);
    const CharacterFinder finder(read_file(setup.detector()), "detector");
    const Detection detection = detect(load_image(page), options.detection, &finder);
    const Json characters = Json::parse(read(setup.out() / "page.json"))["characters"];
    REQUIRE(characters.size() == detection.characters.size());
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Box& box = detection.characters[i].box;
        CHECK(characters[i]["box"] == Json{box.x, box.y, box.width, box.height});
        CHECK(characters[i]["score"] == detection.characters[i].score);
        const fs::path folder = setup.out() / characters[i]["folder"].get<std::string>();
        check_segmented(folder, setup.segmenter(), options.segmentation);
        CHECK(Json::parse(read(folder / "segmentation.json"))["router"].contains(expert));
    }
    return characters.size();
}

} // namespace

TEST_CASE("animate takes Mask R-CNN and SketchParse from a folder of weights", "[cli][end-to-end]") {
    const Setup setup;
    check_animated(setup, "default", "land");
}

TEST_CASE("A page runs through the thesis's two networks at their own depth, in both presets",
          "[cli][end-to-end]") {
    const Setup setup;
    write_bytes(
        setup.detector(),
        narrow_mask_rcnn().file(
            {{"model", "pantin.mask_rcnn"}, {"version", "1"}, {"min_size", "240"}, {"max_size", "320"}}));
    write_bytes(setup.segmenter(),
                narrow_sketch_parse().file({{"model", "pantin.sketch_parse"},
                                            {"version", "1"},
                                            {"experts", "ground,winged"},
                                            {"parts", "background,head,body,limb,tail;"
                                                      "background,head,body,limb,tail,wing"},
                                            {"poses", "E,NE,N,NW,W,SW,S,SE"}}));
    for (const char* preset : {"default", "thesis"}) {
        CAPTURE(preset);
        CHECK(check_animated(setup, preset, "winged") > 0);
        fs::remove_all(setup.out());
    }
}

TEST_CASE("segment takes the network that the weight file's metadata names", "[cli][end-to-end]") {
    const Setup setup;
    REQUIRE(run_pantin({"detect", page, "-o", setup.out().string()}).code == 0);
    const fs::path character = setup.out() / "character-1";
    REQUIRE(setup.run({"segment", character.string()}).code == 0);
    check_segmented(character, setup.segmenter(), setup.options("default").segmentation);
    CHECK(Json::parse(read(character / "segmentation.json"))["router"].contains("air"));

    fs::copy_file("testdata/segmenter_tiny.safetensors", setup.segmenter(),
                  fs::copy_options::overwrite_existing);
    REQUIRE(setup.run({"segment", character.string()}).code == 0);
    check_segmented(character, setup.segmenter(), setup.options("default").segmentation);
    CHECK(Json::parse(read(character / "segmentation.json"))["router"].contains("winged"));
}

TEST_CASE("A network that the program does not know is one line with the file and its value", "[cli]") {
    const Setup setup;
    const auto refused = [&](const fs::path& file, const std::string& fact) {
        const Outcome outcome = setup.run({"animate", page, "-o", setup.out().string()});
        CHECK(outcome.code == 5);
        CHECK(outcome.err == "pantin: " + file.string() + ": " + fact + "\n");
        CHECK_FALSE(fs::exists(setup.out()));
    };
    write_bytes(setup.segmenter(), with_header(bytes_of(setup.segmenter()), "pantin.sketch_parse", "unet"));
    refused(setup.segmenter(), "metadata 'model' is 'unet', which is no segmentation network "
                               "(pantin.segmenter, pantin.sketch_parse)");
    fs::copy_file("testdata/segmenter_tiny.safetensors", setup.segmenter(),
                  fs::copy_options::overwrite_existing);
    write_bytes(setup.detector(), with_header(bytes_of(setup.detector()), "pantin.mask_rcnn", "detr"));
    refused(setup.detector(), "metadata 'model' is 'detr', which is no detection network (pantin.mask_rcnn)");
}
