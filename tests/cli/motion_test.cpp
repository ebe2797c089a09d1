// SPDX-License-Identifier: MIT
// Recorded motions on the command line: films, files, joints named by hand, long ways.
#include <catch2/catch.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"
#include "pantin/motion.hpp"
#include "support/performers.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

std::string whole_way(const TemporaryFolder& folder) {
    const fs::path file = folder / "whole.json";
    write(file, R"({"animation.motion_way": "whole"})");
    return file.string();
}

} // namespace

TEST_CASE("--motion gives humanoids one more clip, prints its joints, and writes films, GLB and BVH",
          "[cli][motion]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "jack.bvh", out = folder / "out";
    write(file, performer(mixamo, jumping_jack, 16));
    const std::vector<std::string> line{"animate",     small_page, "-o",   out.string(), "--motion",
                                        file.string(), "--clip",   "jack", "--format",   "bvh,png"};
    const Outcome outcome = run_pantin(line + small_films);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("jack: left upper arm: mixamorig:LeftArm\n") != std::string::npos);
    CHECK(fs::exists(out / "character-1/frames/jack/0002.png"));
    CHECK_FALSE(fs::exists(out / "character-1/frames/walk"));
    CHECK(read(out / "character-1/animation-jack.bvh").starts_with("HIERARCHY\nROOT hips\n"));
    CHECK(read(out / "character-1/character.glb").find("\"name\":\"jack\"") != std::string::npos);
    // Step by step it is the same.
    const auto before = read_all(out / "character-1");
    REQUIRE(run_pantin({"rig", (out / "character-1").string(), "--motion", file.string()}).code == 0);
    CHECK((read_all(out / "character-1") == before));
}

TEST_CASE("--in-place and --follow show a long way from near, and a scene keeps its figure",
          "[cli][motion]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "far.bvh";
    // Ten seconds straight on: 400 units, five legs.
    write(file, performer(mixamo, walking, 301));
    const auto film = [&](const std::vector<std::string>& more) {
        const fs::path out = folder / ("out" + std::to_string(more.size()) + (more.empty() ? "" : more[0]));
        const std::vector<std::string> line{"animate",     small_page, "-o",     out.string(), "--motion",
                                            file.string(), "--clip",   "far",    "--format",   "png,bvh",
                                            "--fps",       "2",        "--size", "64"};
        REQUIRE(run_pantin(line + more).code == 0);
        return out / "character-1";
    };
    const auto shape = [](const fs::path& character) {
        const RgbaImage frame = load_rgba(character / "frames/far/0003.png");
        return static_cast<double>(frame.width()) / frame.height();
    };
    const auto last_x = [](const fs::path& character) {
        const Motion m = parse_bvh(read(character / "animation-far.bvh"), "far.bvh");
        return joint_positions(m, m.frames() - 1)[0].x - joint_positions(m, 0)[0].x;
    };
    const fs::path whole = film({"--config", whole_way(folder)}), automatic = film({}),
                   follow = film({"--follow"}), in_place = film({"--in-place"});
    CHECK(shape(whole) > 2);
    CHECK(shape(automatic) < 1.6);
    CHECK(shape(follow) == shape(automatic));
    CHECK(shape(in_place) < 1.6);
    CHECK(last_x(whole) > 100); // the character is 100 high
    CHECK(last_x(follow) == last_x(whole));
    CHECK(last_x(in_place) == 0);
}

TEST_CASE("A map of joints, a motion with a frame too many and options that exclude each other",
          "[cli][motion]") {
    const TemporaryFolder folder;
    const std::string file = (folder / "jack.bvh").string(), map = (folder / "map.json").string(),
                      out = (folder / "out").string();
    std::string text = performer(mixamo, jumping_jack, 16);
    text.replace(text.find("Frames: 16"), 10, "Frames: 15");
    write(file, text);
    write(map, R"({"left hand": "mixamorig:RightHand", "left forearm": "mixamorig:RightForeArm",
        "left upper arm": "mixamorig:RightArm"})");
    const std::vector<std::string> line{"animate",  small_page, "-o",       out,
                                        "--motion", file,       "--format", "bvh"};
    const Outcome outcome = run_pantin(line + std::vector<std::string>{"--motion-map", map});
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("jack.bvh: 16 frames are there, not 15 as declared; all are used\n") !=
          std::string::npos);
    CHECK(outcome.out.find("jack: left upper arm: mixamorig:RightArm\n") != std::string::npos);
    write(map, R"({"left wrist": "x"})");
    const std::string fresh = (folder / "fresh").string();
    const Outcome bad =
        run_pantin({"animate", small_page, "-o", fresh, "--motion", file, "--motion-map", map});
    CHECK(bad.code == 3);
    CHECK(bad.err.find("map.json: 'left wrist' is no part of a body") != std::string::npos);
    CHECK_FALSE(fs::exists(fresh));
    CHECK(run_pantin({"animate", small_page, "-o", fresh, "--motion-map", map}).code == 2);
    CHECK(run_pantin({"animate", small_page, "-o", fresh, "--motion", file, "--in-place", "--follow"}).code ==
          2);
}

TEST_CASE("A motion that cannot be used is one line and exit code 3 before anything is written",
          "[cli][motion]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    for (const std::string text : {"HIERARCHY", ""}) {
        write(folder / "bad.bvh", text);
        const Outcome outcome = run_pantin(
            {"animate", small_page, "-o", out.string(), "--motion", (folder / "bad.bvh").string()});
        CHECK(outcome.code == 3);
        CHECK(outcome.err.find("bad.bvh: line 1: ") != std::string::npos);
        CHECK_FALSE(fs::exists(out));
    }
}
