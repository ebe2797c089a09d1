// SPDX-License-Identifier: MIT
// What a run says at its end and on its way: a line for each character, the recorded motion, refusals that
// are overruled.
#include <catch2/catch.hpp>

#include <algorithm>

#include "cli/character_lines.hpp"
#include "cli/demo.hpp"
#include "formats/page_file.hpp"
#include "pantin/error.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace fs = std::filesystem;

namespace {

std::string small_run(const std::vector<std::string>& line) {
    const Outcome outcome = run_pantin(line + small_films);
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
    return outcome.out;
}

} // namespace

TEST_CASE("A character's line has type, confidence, clips and film", "[cli][end-to-end][needs-webp]") {
    const Page page = read_page(animated_demo() / "page.json");
    const auto person = std::find_if(page.characters.begin(), page.characters.end(),
                                     [](const PageCharacter& c) { return c.found->type == "humanoid"; });
    REQUIRE(person != page.characters.end());
    const std::string folder = (animated_demo() / person->folder).string();
    const std::string line = cli::character_line(animated_demo(), *person, false);
    CHECK_THAT(line, StartsWith(folder + ": ok · humanoid (0.99) · "));
    CHECK_THAT(line, Catch::Matchers::EndsWith(" clips · " + folder + "/animation.webp"));
    CHECK_THAT(cli::character_line(animated_demo(), *person, true), Contains(": ok · humanoid · "));
}

TEST_CASE("With low confidence the second choice is said, with its option", "[cli]") {
    PageCharacter character;
    character.folder = "character-1";
    character.found = TypeGuess{"humanoid", 0.69};
    character.second = TypeGuess{"quadruped", 0.25};
    CHECK(cli::character_line("out", character, false) ==
          "out/character-1: ok · humanoid (0.69), or quadruped (0.25): --reference quadruped");
    character.found->confidence = 0.71;
    CHECK(cli::character_line("out", character, false) == "out/character-1: ok · humanoid (0.71)");
}

TEST_CASE("The line of a refused character says what to do", "[cli]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "my out";
    PageCharacter character;
    character.folder = "character-1";
    const auto advice = [&](const std::string& status, bool reference_given) {
        character.status = status;
        const std::string line = cli::character_line(out, character, reference_given);
        const std::string start = (out / "character-1").string() + ": " + status;
        REQUIRE_THAT(line, StartsWith(start));
        return line.substr(start.size());
    };
    CHECK(advice("segment: a scribble", false) == " · try --reference NAME");
    CHECK(advice("skeletonize: a point", false).empty());
    CHECK(advice("rig: nothing to map", true) == " · try another --reference NAME");
    CHECK(advice("render: no clip", false).empty());
    fs::create_directories(out / "character-1");
    std::ofstream(out / "character-1/labels.png") << "labels";
    const std::string labels = (out / "character-1/labels.png").string() + " and run: pantin skeletonize '" +
                               (out / "character-1").string() + "'";
    CHECK(advice("identify: a scribble", false) == " · try --reference NAME, or correct " + labels);
    CHECK(advice("skeletonize: a point", false) == " · correct " + labels);
}

TEST_CASE("page.json of an earlier version, without types, is read", "[formats]") {
    const std::string character =
        R"({"folder": "character-1", "box": [0, 0, 5, 5], "scale": 1, "score": 1, "status": "ok")";
    const std::string start = R"({"source": "a.png", "width": 9, "height": 9, "detector": "given",
        "characters": [)";
    const Page old = page_from_json(start + character + "}]}", "page.json");
    CHECK_FALSE(old.characters[0].found);
    CHECK_FALSE(old.characters[0].second);
    const std::string types =
        R"(, "type": "bird", "confidence": 0.5, "second": {"type": "fish", "confidence": 0.25})";
    const Page page = page_from_json(start + character + types + "}]}", "page.json");
    CHECK(page.characters[0].found->type == "bird");
    CHECK(page.characters[0].second->confidence == 0.25);
    CHECK(page_to_json(page_from_json(page_to_json(page), "page.json")) == page_to_json(page));
    CHECK_THROWS_AS(page_from_json(start + character + R"(, "type": "bird"}]})", "page.json"), Error);
}

TEST_CASE("Who does not follow the recorded motion, or a part of it, is said", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const std::string motion = "testdata/dance.bvh";
    const std::string whole =
        small_run({"animate", small_page, "-o", out, "--motion", motion, "--clip", "dance"});
    CHECK(whole.find("follow") == std::string::npos);
    CHECK_THAT(whole, Contains(" · 1 clip · ")); // one is singular
    const std::string config = (folder / "config.json").string();
    std::ofstream(config) << R"({"animation.motion_start": 0.5, "animation.motion_seconds": 1})";
    CHECK_THAT(small_run({"animate", small_page, "-o", out, "--motion", motion, "--config", config}),
               Contains(out + "/character-1: follows testdata/dance.bvh from 0.5 s to 1.5 s of 2.0 s"));
    CHECK_THAT(small_run({"animate", "testdata/quadruped.png", "-o", out, "--motion", motion}),
               Contains(out + "/character-1: does not follow testdata/dance.bvh, which is for humanoids; it "
                              "moves like: quadruped (--reference humanoid)"));
}

TEST_CASE("--reference overrules the refusal of a scribble", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const auto refused = [&](const std::vector<std::string>& options) {
        small_run(std::vector<std::string>{"animate", "testdata/rejects.png", "-o", out.string()} + options);
        std::vector<std::string> statuses;
        for (const PageCharacter& character : read_page(out / "page.json").characters)
            if (character.status.starts_with("segment: ") || character.status.starts_with("identify: "))
                statuses.push_back(character.status);
        return statuses;
    };
    CHECK_FALSE(refused({}).empty());
    CHECK(refused({"--reference", "humanoid"}).empty());
}

TEST_CASE("identify alone keeps the type in page.json up to date", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    copy_demo(folder / "out");
    const auto first = [&] { return read_page(folder / "out/page.json").characters[0]; };
    const std::string before = first().found->type;
    REQUIRE(before != "humanoid");
    REQUIRE(run_pantin({"identify", (folder / "out/character-1").string(), "--reference", "humanoid"}).code ==
            0);
    CHECK(first().found->type == "humanoid");
    CHECK(first().second->type == before);
}

TEST_CASE("Lossy films are smaller, keep their alpha, and do not depend on the threads",
          "[cli][end-to-end][needs-webp]") {
    const TemporaryFolder folder;
    copy_demo(folder / "out");
    const fs::path character = folder / "out/character-1";
    const auto film = [&](const std::string& quality, const std::string& threads) {
        REQUIRE(run_pantin({"render", character.string(), "--clip", "fly", "--format", "webp", "--size",
                            "200", "--fps", "5", "--quality", quality, "--threads", threads})
                    .code == 0);
        return read(character / "animation.webp");
    };
    const std::string lossless = film("lossless", "1"), lossy = film("60", "1");
    CHECK(lossy.size() < lossless.size());
    CHECK((film("60", "3") == lossy));
    CHECK((film("95", "2") != lossy));
}

TEST_CASE("explain says where its page is also when a character was refused", "[cli][explain][end-to-end]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const Outcome some =
        run_pantin(std::vector<std::string>{"explain", "testdata/rejects.png", "-o", out} + small_films);
    CHECK(some.code == 0);
    CHECK_THAT(some.out, Contains(out + "/index.html\n"));
    CHECK_THAT(some.err, StartsWith("pantin: " + out + "/character-"));
    const Outcome none =
        run_pantin(std::vector<std::string>{"explain", "testdata/rejects.png", "-o", out, "--clip", "none"} +
                   small_films);
    CHECK(none.code == 7);
    CHECK_THAT(none.out, Contains(out + "/index.html\n"));
    CHECK_THAT(none.err, Contains("no character could be animated"));
}
