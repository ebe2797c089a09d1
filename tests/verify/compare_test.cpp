// SPDX-License-Identifier: MIT
// Files side by side: which place is named, which values, how large the difference is.
#include <catch2/catch.hpp>

#include "export/glb_buffer.hpp"
#include "export/rigs.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/verify.hpp"
#include "support/folders.hpp"
#include "verify/bytes.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

FileDifference difference(const std::string& name, const std::string& first, const std::string& second) {
    const std::optional<FileDifference> found = compare_files(name, first, second);
    REQUIRE(found.has_value());
    CHECK(found->file == name);
    return *found;
}

template <class Image> std::string png(const Image& image) { return as_text(encode_png(image)); }

RgbaImage checks(Rgba8 one = {255, 0, 0, 255}) {
    RgbaImage image(20, 10, Rgba8{0, 0, 255, 128});
    for (int y = 0; y < 10; ++y)
        for (int x = y % 2; x < 20; x += 2) image(x, y) = one;
    return image;
}

std::string square_glb(double moved = 0, Rgba8 colour = {255, 0, 0, 255}) {
    Rig rig = square_rig();
    rig.mesh.vertices[4].x += moved;
    return as_text(to_glb(rig, checks(colour), {swing()}));
}

} // namespace

TEST_CASE("JSON: numbers by their bits, with place, values and the largest difference", "[verify]") {
    const FileDifference d = difference("a.json", R"({"list": [{"x": 1.5}, {"x": 2}], "name": "n"})",
                                        R"({"list": [{"x": 1.25}, {"x": 3}], "name": "m"})");
    CHECK(d.place == "list[0].x");
    CHECK(d.first == "1.5");
    CHECK(d.second == "1.25");
    CHECK(d.values == 3);
    CHECK(d.largest == 1);
    CHECK(d.largest_place == "list[1].x");
    // Spaces and the order of keys are no values; the last bit is one.
    CHECK_FALSE(compare_files("a.json", R"({"a": 1, "b": [2]})", "{\"b\":[2.0],\n\"a\":1}").has_value());
    CHECK(difference("a.json", "[0.1]", "[0.10000000000000002]").values == 1);
    CHECK(difference("a.json", "[0.0]", "[-0.0]").largest == 0);
}

TEST_CASE("JSON: structure", "[verify]") {
    const FileDifference shorter = difference("a.json", R"({"a": [1, 2]})", R"({"a": [1]})");
    CHECK(shorter.place == "a");
    CHECK(shorter.first == "2 elements");
    CHECK(shorter.second == "1 elements");
    const FileDifference missing =
        difference("a.json", R"({"a": 1, "b": {"c": "text"}})", R"({"a": 1, "b": {}, "d": null})");
    CHECK(missing.place == "b.c");
    CHECK(missing.first == "\"text\"");
    CHECK(missing.second == "missing");
    CHECK(missing.values == 2);
    CHECK(difference("a.json", R"({"a": 1})", R"({"a": "1"})").second == "\"1\"");
    const std::string deep(100'000, '['), ends(100'000, ']');
    CHECK_THROWS_WITH(difference("a.json", deep + "1" + ends, deep + "2" + ends),
                      "a.json: nested too deeply");
    const std::string open(400, '['), close(400, ']');
    CHECK(difference("a.json", open + "1" + close, open + "2" + close).first == "nested too deeply");
}

TEST_CASE("Text: words that are numbers by their values", "[verify]") {
    const FileDifference d =
        difference("mesh.obj", "# mesh\nv 1 2.5 3\nv 4 5 6\n", "# mesh\nv 1 2.25 3\nv 4 5 -6\n");
    CHECK(d.place == "line 2, word 3");
    CHECK(d.values == 2);
    CHECK(d.largest == 12);
    CHECK_FALSE(compare_files("weights.txt", "v 1 0.50\n", "v  1 0.5\n").has_value());
    CHECK(difference("weights.txt", "v 1 0.5\n", "v 1 0.5\nv 2 1\n").second == "2 lines");
    CHECK(difference("weights.txt", "bone 0 hips\n", "bone 0 chest\n").second == "chest");
    CHECK(difference("weights.txt", "bone 0\n", "bone 0 chest\n").place == "line 1");
}

TEST_CASE("Pictures: decoded pixels, and a picture of where they differ", "[verify]") {
    RgbaImage other = checks();
    other(4, 3).g = 30;
    other(7, 3).a = 100;
    const FileDifference d = difference("frame.png", png(checks()), png(other));
    CHECK(d.place == "pixel (4, 3), green");
    CHECK(d.first == "0");
    CHECK(d.second == "30");
    CHECK(d.values == 2);
    CHECK(d.largest == 155);
    CHECK(d.largest_place == "pixel (7, 3), alpha");
    REQUIRE(d.picture.has_value());
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) {
            const Rgb8 p = (*d.picture)(x, y);
            CHECK((p.r != p.g) == ((x == 4 || x == 7) && y == 3));
        }
    CHECK(difference("frame.png", png(checks()), png(RgbaImage(20, 11))).place == "size");
    // The same pixels from another encoder.
    GreyImage grey(16, 16, std::uint8_t{7});
    RgbImage colour(16, 16, Rgb8{7, 7, 7});
    CHECK_FALSE(compare_files("mask.png", png(grey), png(colour)).has_value());
}

TEST_CASE("GLB: values of the accessors and pixels of the picture", "[verify]") {
    CHECK_FALSE(compare_files("character.glb", square_glb(), square_glb()).has_value());
    const FileDifference moved = difference("character.glb", square_glb(), square_glb(0.5));
    CHECK(moved.place.starts_with("accessors[0].values["));
    CHECK(moved.largest > 0);
    const FileDifference painted = difference("character.glb", square_glb(), square_glb(0, {255, 9, 0, 255}));
    CHECK(painted.place.starts_with("picture, pixel (0, 0), green"));
    CHECK(painted.largest == 9);
}

TEST_CASE("Films: frame, pixel and delay", "[verify][needs-webp][needs-gif]") {
    std::vector<RgbaImage> frames; // encoders join equal ones
    for (int i = 0; i < 3; ++i) frames.push_back(checks({255, 0, static_cast<std::uint8_t>(60 * i), 255}));
    std::vector<RgbaImage> others = frames;
    others[1](2, 2) = {0, 255, 0, 255};
    const FileDifference webp =
        difference("a.webp", as_text(encode_webp(frames, 25)), as_text(encode_webp(others, 25)));
    CHECK(webp.place == "frame 2, pixel (2, 2), red");
    CHECK(webp.picture.has_value());
    CHECK(difference("a.webp", as_text(encode_webp(frames, 25)), as_text(encode_webp(frames, 20))).place ==
          "frame 1, delay");
    CHECK(difference("a.gif", as_text(encode_gif(frames, 25)), as_text(encode_gif(others, 25)))
              .place.starts_with("frame 2, pixel (2, 2)"));
    frames.pop_back();
    CHECK(difference("a.gif", as_text(encode_gif(others, 25)), as_text(encode_gif(frames, 25))).second ==
          "2 frames");
}

TEST_CASE("Other files as bytes", "[verify]") {
    const FileDifference d = difference("a.mp4", "abc", "abd!");
    CHECK(d.place == "byte 2");
    CHECK(d.values == 2);
    CHECK(d.largest == 1);
}

TEST_CASE("A damaged file is an error that names it", "[verify]") {
    const std::string good = png(checks()), glb = square_glb();
    std::string long_text = glb;
    long_text.replace(12, 4, "\xfc\xff\xff\xff"); // length of the JSON chunk
    const std::string long_accessor = as_text(pack_glb(
        R"({"asset": {}, "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4611686018427387904, "type": "SCALAR"}],
            "bufferViews": [{"byteOffset": 0, "byteLength": 4}]})",
        {0, 0, 0, 0}));
    for (const auto& [name, first, second] : std::vector<std::tuple<std::string, std::string, std::string>>{
             {"a.json", "{}", "{"},
             {"a.png", good, good.substr(0, good.size() / 2)},
             {"a.glb", glb, glb.substr(0, glb.size() / 2)},
             {"a.glb", glb, long_text},
             {"a.glb", glb, long_accessor},
             {"a.webp", "RIFF", "nothing"},
             {"a.gif", "GIF89a", "nothing"},
         }) {
        CAPTURE(name);
        if ((name == "a.webp" && !webp_available()) || (name == "a.gif" && !gif_available())) continue;
        try {
            compare_files(name, first, second);
            FAIL("no error");
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::input);
            CHECK(std::string(error.what()).starts_with(name + ": "));
        }
    }
}

TEST_CASE("Folders: by the stages that made the files, in the order of the flow", "[verify]") {
    const TemporaryFolder folder;
    for (const char* side : {"a", "b"}) {
        std::filesystem::create_directories(folder / side / "character-1/trace");
        write(folder / side / "page.json", "{\"width\": 10}");
        write(folder / side / "character-1/skeleton.json", "{\"x\": 1}");
    }
    const auto compare = [&] { return compare_folders(folder / "a", folder / "b"); };
    CHECK(compare().stages.empty());
    CHECK(compare().files == 2);
    CHECK(comparison_table(compare()) == "0 of 2 files differ");
    write(folder / "b/character-1/weights.txt", "v 1 0 1\n");
    write(folder / "b/character-1/skeleton.json", "{\"x\": 1.5}");
    write(folder / "a/notes", "seen");
    const FolderComparison found = compare();
    REQUIRE(found.stages.size() == 3);
    CHECK(found.stages[0].stage == "h2");
    CHECK(found.stages[1].stage == "weights");
    CHECK(found.stages[2].stage == "other files");
    CHECK(comparison_table(found) == "h2\n  character-1/skeleton.json: x: 1 and 1.5\nweights\n  "
                                     "character-1/weights.txt: missing and a file\n"
                                     "other files\n  notes: a file and missing\n3 of 4 files differ");
    CHECK_THROWS_AS(compare_folders(folder / "a", folder / "none"), Error);
}
