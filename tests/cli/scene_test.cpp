// SPDX-License-Identifier: MIT
// Films for other programs: MP4 through an ffmpeg of the test's own, and the page as one film.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "cli/demo.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

// A program called ffmpeg in a folder of its own.
fs::path fake_ffmpeg(const TemporaryFolder& folder, const std::string& script) {
    const fs::path file = folder / "ffmpeg";
    write(file, "#!/bin/sh\n" + script);
    fs::permissions(file, fs::perms::owner_all);
    return folder.path();
}

Environment with_path(const fs::path& first) { return {{"PATH", first.string() + ":/usr/bin:/bin"}}; }

std::vector<std::string> to_mp4(const fs::path& out) {
    return std::vector<std::string>{"animate",  small_page, "-o",     out.string(),
                                    "--format", "mp4",      "--clip", "walk"} +
           small_films;
}

double difference(const RgbImage& a, const RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a.data()[i].g - b.data()[i].g);
    return sum / static_cast<double>(a.size());
}

} // namespace

TEST_CASE("--format mp4 hands ffmpeg the raw frames of three seconds", "[cli][mp4]") {
    const TemporaryFolder folder, programs;
    // It writes down how it was called and how many bytes came, to the file that its last argument names.
    const fs::path path =
        fake_ffmpeg(programs, "for last; do :; done\necho \"$*\" > \"$last\"\nwc -c >> \"$last\"\n");
    const Outcome outcome = run_pantin(to_mp4(folder / "out"), with_path(path));
    REQUIRE(outcome.code == 0);
    const std::string film = read(folder / "out/character-1/animation.mp4");
    CHECK(film.find("-f rawvideo -pix_fmt rgb24 -s ") != std::string::npos);
    CHECK(film.find(" -r 5 ") != std::string::npos);
    const std::size_t size = film.find(" -s ") + 4;
    const int width = std::stoi(film.substr(size)), height = std::stoi(film.substr(film.find('x', size) + 1));
    CHECK(width % 2 == 0);
    CHECK(height % 2 == 0);
    CHECK(std::stol(film.substr(film.find('\n') + 1)) == 3L * 5 * width * height * 3);
    CHECK_FALSE(fs::exists(folder / "out/character-1/animation.mp4.part"));
}

TEST_CASE("An ffmpeg that fails is one line, exit code 6 and no file", "[cli][mp4]") {
    const TemporaryFolder folder, programs;
    const fs::path path = fake_ffmpeg(programs, "echo 'Unknown encoder' >&2\nexit 1\n");
    const Outcome outcome = run_pantin(to_mp4(folder / "out"), with_path(path));
    CHECK(outcome.code == 6);
    CHECK(outcome.err.find("animation.mp4: ffmpeg failed: Unknown encoder") != std::string::npos);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    CHECK_FALSE(fs::exists(folder / "out/character-1/animation.mp4"));
    CHECK_FALSE(fs::exists(folder / "out/character-1/animation.mp4.part"));
}

TEST_CASE("--format mp4 without ffmpeg is a usage error before anything is written", "[cli][mp4]") {
    const TemporaryFolder folder;
    const Outcome outcome = run_pantin(to_mp4(folder / "out"), {{"PATH", folder.path().string()}});
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("there is no ffmpeg") != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "out"));
}

TEST_CASE("--scene shows the page with every character in its place, moving", "[cli][scene]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const std::vector<std::string> line{"animate",  demo_page, "-o",     out.string(), "--scene",
                                        "--format", "png",     "--size", "210",        "--fps",
                                        "4",        "--clip",  "idle"};
    REQUIRE(run_pantin(line).code == 0);
    const RgbImage page = resize(load_image(demo_page), 210, 150);
    std::vector<RgbImage> frames;
    for (const auto& [name, bytes] : read_all(out / "frames/scene"))
        frames.push_back(load_image(out / "frames/scene" / name));
    REQUIRE(frames.size() >= 8);
    for (const RgbImage& frame : frames) {
        REQUIRE(frame.width() == page.width());
        REQUIRE(frame.height() == page.height());
        CHECK(difference(frame, page) < 6); // idle moves little
    }
    CHECK(difference(frames[0], frames[frames.size() / 4]) > 0.05);
    CHECK(frames[0](0, 0) == page(0, 0)); // the paper is the page's
    CHECK(frames[0](0, 0) == frames[4](0, 0));
}

TEST_CASE("--blend is the same in one go and step by step", "[cli][blend]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    REQUIRE(run_pantin({"animate", small_page, "-o", out.string(), "--blend", "--format", "bvh"}).code == 0);
    const auto before = read_all(out / "character-1");
    REQUIRE(run_pantin({"rig", (out / "character-1").string(), "--blend"}).code == 0);
    REQUIRE(run_pantin({"render", (out / "character-1").string(), "--blend", "--format", "bvh"}).code == 0);
    CHECK(read_all(out / "character-1") == before);
}

TEST_CASE("skeletonize --skeleton takes another kind of skeleton, and the next steps go on from it",
          "[cli][skeleton]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out", character = out / "character-1";
    REQUIRE(run_pantin({"animate", small_page, "-o", out.string(), "--format", "bvh"}).code == 0);
    const std::string voronoi = read(character / "skeleton.json");
    for (const std::string method : {"straight", "thinning", "chordal", "voronoi"}) {
        CAPTURE(method);
        REQUIRE(run_pantin({"skeletonize", character.string(), "--skeleton", method}).code == 0);
        CHECK((read(character / "skeleton.json") == voronoi) == (method == "voronoi"));
        CHECK(run_pantin({"identify", character.string()}).code == 0);
        CHECK(run_pantin({"rig", character.string()}).code == 0);
    }
    CHECK(run_pantin({"skeletonize", character.string(), "--skeleton", "medial"}).code == 2);
}
