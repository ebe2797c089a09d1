// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "pantin/image.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

std::string png_of(const RgbImage& image) {
    const std::vector<unsigned char> bytes = encode_png(image);
    return {bytes.begin(), bytes.end()};
}

// A PNG whose header says width × height; nothing behind it fits.
std::string huge_png(unsigned side) {
    std::string png = png_of(RgbImage(16, 16, Rgb8{255, 255, 255}));
    for (std::size_t i = 0; i < 4; ++i)
        png[16 + i] = png[20 + i] = static_cast<char>(side >> (24 - 8 * i) & 255);
    return png;
}

void check_one_line(const Outcome& outcome, int code, const std::string& name) {
    CAPTURE(outcome.err);
    CHECK(outcome.code == code);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("pantin: "));
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    CHECK(outcome.err.find(name) != std::string::npos);
}

struct BadPicture {
    std::string name, bytes;
    int code;
};

std::vector<BadPicture> bad_pictures() {
    const std::string good = png_of(RgbImage(64, 64, Rgb8{200, 100, 50}));
    return {{"empty.png", "", 3},
            {"truncated.png", good.substr(0, good.size() / 2), 3},
            {"header-only.png", good.substr(0, 20), 3},
            {"text.png", "This is no picture.\n", 3},
            {"text.jpg", "\xFF\xD8 but no more", 3},
            {"tiny.png", png_of(RgbImage(1, 1)), 3},
            {"huge.png", huge_png(20000), 3},
            {"white.png", png_of(RgbImage(200, 150, Rgb8{255, 255, 255})), 4},
            {"black.png", png_of(RgbImage(200, 150, Rgb8{0, 0, 0})), 4}};
}

} // namespace

TEST_CASE("A bad picture is one line that names it, the documented code, and no output", "[cli]") {
    const TemporaryFolder folder;
    for (const BadPicture& picture : bad_pictures()) {
        CAPTURE(picture.name);
        write(folder / picture.name, picture.bytes);
        const std::string out = (folder / "out").string();
        check_one_line(run_pantin({"detect", (folder / picture.name).string(), "-o", out}), picture.code,
                       picture.name);
        CHECK_FALSE(std::filesystem::exists(out));
    }
    check_one_line(run_pantin({"detect", (folder / "missing.png").string(), "-o", "out"}), 3, "missing.png");
    check_one_line(run_pantin({"detect", folder.path().string(), "-o", "out"}), 3, folder.path().string());
}

TEST_CASE("A file name with a line feed still makes one line", "[cli]") {
    const TemporaryFolder folder;
    const Outcome outcome = run_pantin({"detect", (folder / "a\nb.png").string(), "-o", "out"});
    CHECK(outcome.code == 3);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
}

TEST_CASE("Weights that are missing or damaged are exit code 5, before anything is written", "[cli]") {
    const TemporaryFolder folder;
    const std::string page = "testdata/demo.png", out = (folder / "out").string();
    check_one_line(run_pantin({"animate", page, "-o", out, "--weights", (folder / "none").string()}), 5,
                   "segmenter.safetensors");
    const std::filesystem::path file = folder / "segmenter.safetensors";
    for (const std::string& bytes : {std::string(), std::string("no weights"), std::string(4096, '\xff'),
                                     std::string("\x02\0\0\0\0\0\0\0{}", 10)}) {
        write(file, bytes);
        check_one_line(run_pantin({"animate", page, "-o", out, "--weights", folder.path().string()}), 5,
                       "segmenter.safetensors");
        check_one_line(run_pantin({"animate", page, "-o", out}, {{"PANTIN_WEIGHTS", folder.path().string()}}),
                       5, "segmenter.safetensors");
    }
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("A wrong configuration or reference is exit code 3 and names its file", "[cli]") {
    const TemporaryFolder folder;
    const std::string page = "testdata/demo.png", out = (folder / "out").string();
    write(folder / "config.json", "{\"detection\": {\"speed\": 1}}");
    check_one_line(run_pantin({"animate", page, "-o", out, "--config", (folder / "config.json").string()}), 3,
                   "config.json: there is no option 'detection.speed'");
    check_one_line(run_pantin({"animate", page, "-o", out, "--config", (folder / "none.json").string()}), 3,
                   "none.json");
    std::filesystem::create_directory(folder / "references");
    write(folder / "references/fish.json", "{\"name\": \"fish\"}");
    check_one_line(run_pantin({"animate", page, "-o", out, "--references", (folder / "references").string()}),
                   3, "fish.json");
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("An output folder that cannot be made is exit code 6, also for root", "[cli]") {
    const TemporaryFolder folder;
    write(folder / "file", "in the way");
    for (const std::string& out :
         {(folder / "file").string(), (folder / "file/out").string(), std::string("/proc/pantin")}) {
        CAPTURE(out);
        check_one_line(run_pantin({"detect", "testdata/demo.png", "-o", out}), 6, out);
    }
    CHECK(read(folder / "file") == "in the way");
}

TEST_CASE("Something in the place of a result is exit code 6 and leaves no temporary file", "[cli]") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "out/page.json/occupied");
    const Outcome outcome = run_pantin({"detect", "testdata/demo.png", "-o", (folder / "out").string()});
    check_one_line(outcome, 6, "page.json");
    for (const auto& [name, bytes] : read_all(folder / "out")) CHECK_FALSE(name.ends_with(".part"));
}

TEST_CASE("A folder that is none, or lacks the files of the steps before, is exit code 3", "[cli]") {
    const TemporaryFolder folder;
    for (const std::string command : {"segment", "skeletonize", "identify", "rig", "render"}) {
        CAPTURE(command);
        check_one_line(run_pantin({command, (folder / "none").string()}), 3, "none");
        check_one_line(run_pantin({command, folder.path().string()}), 3, folder.path().string());
        CHECK(read_all(folder.path()).empty());
    }
}
