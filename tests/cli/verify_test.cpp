// SPDX-License-Identifier: MIT
// pantin verify: exit codes, table, folders.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "cli/demo.hpp"
#include "pantin/image.hpp"
#include "pantin/verify.hpp"
#include "pantin/version.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

// One line on standard error that holds the fact.
void check_line(const Outcome& outcome, int code, const std::string& fact) {
    CAPTURE(outcome.out, outcome.err);
    CHECK(outcome.code == code);
    CHECK(outcome.err.starts_with("pantin: "));
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    CHECK(outcome.err.find(fact) != std::string::npos);
}

} // namespace

TEST_CASE("verify prints a table, writes what is asked for only, and its output equals itself",
          "[cli][verify]") {
    const TemporaryFolder folder;
    const Outcome one = run_pantin({"verify", "--threads", "1", "-o", (folder / "one").string()});
    CAPTURE(one.out, one.err);
    REQUIRE(one.code == 0);
    CHECK(one.out.starts_with("preset default\nstage       humanoid    quadruped   flyer\n"));
    CHECK(one.out.find("\n\npreset thesis\nstage       hole        unpaired    crossed\n") !=
          std::string::npos);
    CHECK(one.out.find("\nskeletonize ok          ok          ok\n") != std::string::npos);
    CHECK(one.out.find("DIFFERS") == std::string::npos);
    CHECK(fs::exists(folder / "one/humanoid/character-1/model/solid.json"));
    CHECK(fs::exists(folder / "one/thesis/hole/character-1/character.glb"));
    const Outcome two =
        run_pantin({"verify", "--threads", "2", "--end-to-end", "-o", (folder / "two").string()});
    CHECK(two.out == one.out); // the digest is in it
    const Outcome same =
        run_pantin({"verify", (folder / "one").string(), "--against", (folder / "two").string()});
    CHECK(same.code == 0);
    CHECK(same.out.find("0 of ") == 0);
    const Outcome quiet = run_pantin({"verify", "--quiet"});
    CHECK(quiet.code == 0);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
}

TEST_CASE("verify --preset runs that one alone; a difference in it is named", "[cli][verify]") {
    const TemporaryFolder folder;
    const std::string all = (folder / "all").string();
    const Outcome outcome = run_pantin({"verify", "--preset", "thesis", "-o", all});
    CAPTURE(outcome.out, outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.starts_with("preset thesis\nstage       hole "));
    CHECK(outcome.out.find("60 of 60 agree, digest ") != std::string::npos);
    CHECK(fs::exists(folder / "all/thesis/crossed/character-1/mesh.obj"));
    CHECK_FALSE(fs::exists(folder / "all/humanoid"));
    write(folder / "options.json", R"({"identification.k_v": 1.5})");
    check_line(run_pantin({"verify", "--preset", "thesis", "--config", (folder / "options.json").string()}),
               8, "stage identify differs on the hole (thesis/hole/character-1/identification.json)");
    check_line(run_pantin({"verify", "--preset", "best"}), 2, "--preset");
}

// The stages of verification are the pipeline's: what `animate` makes of the same pages is what is stored.
TEST_CASE("animate --preset thesis makes the stored shapes and mappings", "[cli][verify]") {
    const fs::path stored = "testdata/vectors/thesis";
    for (const char* drawing : {"hole", "unpaired", "crossed"}) {
        const fs::path& made = animated_thesis() / drawing;
        for (const char* name : {"mask.png", "labels.png", "contour.json", "skeleton.png", "skeleton.json",
                                 "identification.json", "mapping.json"}) {
            CAPTURE(drawing, name);
            const std::string file = std::string("character-1/") + name;
            CHECK_FALSE(compare_files(name, read(stored / drawing / file), read(made / file)));
        }
    }
}

TEST_CASE("A difference is exit code 8 and names the stage, the file, the place and both values",
          "[cli][verify]") {
    const TemporaryFolder folder;
    write(folder / "options.json", R"({"rigging.limb_segments": 1})");
    const Outcome outcome = run_pantin({"verify", "--config", (folder / "options.json").string()});
    check_line(outcome, 8, "stage bones differs on the humanoid (humanoid/character-1/trace/bones.json)");
    CHECK(outcome.out.find("\nbones       DIFFERS     DIFFERS     ok\n") != std::string::npos);
    CHECK(outcome.out.find("bones: humanoid/character-1/trace/bones.json: bones: ") != std::string::npos);
    CHECK(outcome.out.find(" elements, stored ") != std::string::npos);
}

TEST_CASE("Output folders of animate are compared by values, with pictures of where they differ",
          "[cli][verify]") {
    const TemporaryFolder folder;
    copy_demo(folder / "other");
    const std::string demo = animated_demo().string(), other = (folder / "other").string();
    CHECK(run_pantin({"verify", demo, "--against", other}).code == 0);
    const fs::path labels = folder / "other/character-1/labels.png";
    GreyImage image = load_grey(labels);
    for (int x = 10; x < 20; ++x) image(x, 30) = 3 - image(x, 30) / 2;
    save_png(labels, image);
    const Outcome outcome =
        run_pantin({"verify", demo, "--against", other, "-o", (folder / "where").string()});
    check_line(outcome, 8, "first in segment (character-1/labels.png)");
    CHECK(outcome.out.starts_with("segment\n  character-1/labels.png: pixel (10, 30), red: "));
    const RgbImage where = load_image(folder / "where/character-1/labels.png");
    CHECK(where.width() == image.width());
    CHECK(where(10, 30).r > where(10, 30).g);
    CHECK(where(10, 31).r == where(10, 31).g);
}

TEST_CASE("verify: wrong calls and folders", "[cli][verify]") {
    const std::string demo = animated_demo().string();
    check_line(run_pantin({"verify", demo}), 2, "--against");
    check_line(run_pantin({"verify", "--against", demo}), 2, "--against");
    check_line(run_pantin({"verify", demo, "--against", demo + "/none"}), 3, "none: no such folder");
    check_line(run_pantin({"verify", "--threads", "0"}), 2, "--threads");
    check_line(run_pantin({"verify", "-o", "/dev/null/out"}), 6, "/dev/null/out");
}

TEST_CASE("make vectors: the same archive twice, and its checksums hold", "[cli][verify]") {
    const TemporaryFolder folder;
    const std::string build = fs::path(std::getenv("PANTIN")).parent_path().string(),
                      name = "pantin-vectors-" PANTIN_VERSION;
    const auto shell = [](const std::string& line) {
        return std::system((line + " >/dev/null 2>&1").c_str());
    };
    for (const char* side : {"a", "b"})
        REQUIRE(shell("env -u MAKEFLAGS -u MAKELEVEL make vectors-files BUILD=" + build +
                      " vectors_out=" + (folder / side).string()) == 0);
    const std::string archive = read(folder / "a" / (name + ".tar.gz"));
    CHECK(archive.size() > 1'000'000); // with the weights
    CHECK(archive == read(folder / "b" / (name + ".tar.gz")));
    REQUIRE(shell("mkdir " + (folder / "c").string() + " && tar -C " + (folder / "c").string() + " -xzf " +
                  (folder / "a").string() + "/" + name + ".tar.gz") == 0);
    CHECK(shell("cd " + (folder / "c").string() + "/" + name + " && sha256sum --strict -c SHA256SUMS") == 0);
    const std::string sums = read(folder / "c" / name / "SHA256SUMS");
    for (const auto& [file, bytes] : read_all(folder / "c" / name)) {
        CAPTURE(file);
        CHECK((file == "SHA256SUMS") == (sums.find("  " + file + "\n") == std::string::npos));
    }
    write(folder / "c" / name / "README.md", "changed");
    CHECK(shell("cd " + (folder / "c").string() + "/" + name + " && sha256sum --strict -c SHA256SUMS") != 0);
}
