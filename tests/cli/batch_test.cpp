// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <numeric>
#include <sstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"
#include "pantin/image.hpp"
#include "pipeline/batch.hpp"

using namespace pantin;
using namespace pantin::test;
using Json = nlohmann::ordered_json;

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

// One short clip in few formats: what is tested here are lines.
const Words quick = Words{"--clip", "idle", "--format", "apng"} + small_films;

Outcome batch(const std::string& input, const Words& more = {}) {
    return run_pantin(Words{"batch"} + quick + more, {}, "", input);
}

std::vector<Json> lines_of(const Outcome& outcome) {
    std::vector<Json> lines;
    std::istringstream stream(outcome.out);
    for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
    return lines;
}

std::string line_for(const std::string& image, const fs::path& out) {
    return Json{{"image", image}, {"out", out.string()}}.dump() + "\n";
}

void check_same(const fs::path& ours, const fs::path& wanted) {
    CAPTURE(ours.string());
    CHECK((read_all(ours) == read_all(wanted)));
}

// Tasks that take longer the earlier they come, in groups of four.
struct Numbers {
    int count, given = 0;
    std::vector<int> written = {};

    BatchTask next() {
        if (given == count) return {};
        return [number = given++] {
            std::this_thread::sleep_for(std::chrono::milliseconds(3 - number % 4));
            BatchResult result;
            result.code = number;
            return result;
        };
    }
};

} // namespace

TEST_CASE("Results come in the order of the tasks, for any number of threads", "[batch]") {
    for (const int threads : {1, 2, 4}) {
        Numbers numbers{50};
        run_in_order(
            threads, [&] { return numbers.next(); },
            [&](const BatchResult& result) { return numbers.written.push_back(result.code), true; });
        std::vector<int> wanted(50);
        std::iota(wanted.begin(), wanted.end(), 0);
        CHECK(numbers.written == wanted);
    }
}

TEST_CASE("Few tasks are begun before the first result is written, however long it takes", "[batch]") {
    for (const int threads : {1, 3}) {
        int given = 0, most_ahead = 0, written = 0;
        const auto next = [&]() -> BatchTask {
            if (given == 40) return {};
            return [number = given++] {
                if (number == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
                return BatchResult{};
            };
        };
        run_in_order(threads, next, [&](const BatchResult&) {
            most_ahead = std::max(most_ahead, ++written == 1 ? given : 0);
            return true;
        });
        CHECK(written == 40);
        CHECK(most_ahead <= 2 * threads);
    }
}

TEST_CASE("Work ends when nobody reads the results, and exceptions come through", "[batch]") {
    Numbers numbers{1000};
    run_in_order(
        4, [&] { return numbers.next(); },
        [&](const BatchResult& result) { return numbers.written.push_back(result.code), result.code < 5; });
    CHECK(numbers.written == std::vector<int>{0, 1, 2, 3, 4, 5});
    CHECK(numbers.given < 20);

    Numbers more{1000};
    CHECK_THROWS_AS(run_in_order(
                        4, [&] { return more.next(); },
                        [&](const BatchResult& result) {
                            if (result.code == 5) throw Error(ErrorKind::output, "full");
                            return true;
                        }),
                    Error);
    // What was begun before the input broke off is written.
    Numbers broken{1000};
    const auto next = [&] {
        if (broken.given == 7) throw Error(ErrorKind::input, "gone");
        return broken.next();
    };
    CHECK_THROWS_AS(
        run_in_order(3, next,
                     [&](const BatchResult& result) { return broken.written.push_back(result.code), true; }),
        Error);
    CHECK(broken.written == std::vector<int>{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("A batch gives the bytes of animate, with the options of each line", "[batch][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path ours = folder / "ours", wanted = folder / "wanted";
    write(folder / "config.json", R"({"rigging": {"limb_segments": 1}, "animation.clips": "default"})");
    const RgbImage page = load_image(small_page);
    save_png(folder / "mask.png", GreyImage(page.width(), page.height(), 255));
    const Json turned = {{"image", "testdata/flying.png"},
                         {"out", (ours / "turned").string()},
                         {"rotate", 180},
                         {"scene", true}};
    const Json given = {{"image", small_page},
                        {"out", (ours / "given").string()},
                        {"mask", (folder / "mask.png").string()},
                        {"reference", "bird"},
                        {"size", 48},
                        {"fps", 4},
                        {"formats", {"apng", "png"}}};
    const Json config = {{"image", "testdata/quadruped.png"},
                         {"config", {{"rigging.limb_segments", 1}, {"animation.clips", "default"}}},
                         {"preset", "thesis"},
                         {"background", "#ff8800"},
                         {"perspective", true},
                         {"detector", "contour"}};
    const auto run = [&](const std::string& image, const std::string& name, const Words& more) {
        const int code = run_pantin(Words{"animate", image, "-o", (wanted / name).string()} + more).code;
        CHECK(code == 0);
    };
    run(small_page, "humanoid", quick);
    run("testdata/flying.png", "turned", quick + Words{"--rotate", "180", "--scene"});
    run(small_page, "given",
        {"--clip", "idle", "--mask", (folder / "mask.png").string(), "--reference", "bird", "--size", "48",
         "--fps", "4", "--format", "apng,png"});
    run("testdata/quadruped.png", "quadruped",
        quick + Words{"--config", (folder / "config.json").string(), "--preset", "thesis", "--background",
                      "#ff8800", "--perspective", "--detector", "contour"});

    const std::string input = small_page + "\n" + turned.dump() + "\n" + given.dump() + "\r\n" +
                              config.dump(); // the last line need not be ended
    const Outcome outcome = batch(input, {"-o", ours.string(), "--threads", "2", "--quiet"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    check_same(ours, wanted);
    const std::vector<Json> lines = lines_of(outcome);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0].dump() == R"({"image":")" + small_page + R"(","out":")" + (ours / "humanoid").string() +
                                 R"(","status":"ok","code":0,"characters":[)" +
                                 R"({"folder":"character-1","status":"ok","type":"humanoid"}]})");
    CHECK(lines[2]["characters"][0]["type"] == "bird");
    CHECK(lines[3]["out"] == (ours / "quadruped").string());
}

TEST_CASE("A batch does not depend on the number of threads and goes on after failures",
          "[batch][end-to-end]") {
    const TemporaryFolder folder;
    write(folder / "broken.png", "no picture");
    std::string input;
    for (const std::string& line :
         {std::string("testdata/quadruped.png"), std::string("missing.png"), (folder / "broken.png").string(),
          std::string("testdata/rejects.png"), small_page, std::string("{\"image\": 5}"), small_page,
          std::string("testdata/flying.png")})
        input += line + "\n";
    const fs::path out = folder / "out", first = folder / "first";
    std::string lines;
    for (const std::string threads : {"1", "4"}) {
        const Outcome outcome = batch(input, {"-o", out.string(), "--threads", threads});
        CHECK(outcome.code == 3);
        CHECK(outcome.err ==
              "pantin: 5 done, 3 failed, first number 2 (missing.png): error: missing.png: no such file\n");
        if (threads == "1") {
            lines = outcome.out;
            fs::rename(out, first);
        }
        CHECK(outcome.out == lines);
        const std::vector<Json> found = lines_of(outcome);
        REQUIRE(found.size() == 8);
        std::vector<int> codes;
        for (const Json& line : found) codes.push_back(line["code"]);
        CHECK(codes == std::vector<int>{0, 3, 3, 0, 0, 2, 0, 0});
        CHECK(found[3]["characters"].size() > 1);
        CHECK(found[3]["characters"][1]["type"].is_null());
        CHECK(found[6]["out"] == (out / "humanoid-2").string());
    }
    check_same(out, first);
    check_same(out / "humanoid", out / "humanoid-2");
}

TEST_CASE("A page without any character that can be animated tells the step and the reason",
          "[batch][end-to-end]") {
    const TemporaryFolder folder;
    const std::string line =
        Json{{"image", small_page}, {"out", (folder / "out").string()}, {"clip", "fly"}}.dump();
    for (const bool again : {false, true}) {
        const Outcome outcome = batch(line, again ? Words{"--skip-done"} : Words{});
        CHECK(outcome.code == 7);
        const Json found = lines_of(outcome).at(0);
        CHECK(found["code"] == 7);
        CHECK(found["status"].get<std::string>().starts_with("render: the humanoid has no clip 'fly'"));
        CHECK(found["characters"][0]["type"] == "humanoid");
        CHECK(found.contains("skipped") == again);
    }
}

TEST_CASE("A second run with --skip-done does what is missing and nothing else", "[batch][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out", wanted = folder / "wanted";
    const std::string input = small_page + "\ntestdata/quadruped.png\ntestdata/flying.png\n";
    REQUIRE(batch(input, {"-o", out.string()}).code == 0);
    fs::copy(out, wanted, fs::copy_options::recursive);
    // A run that was killed: half a film, and page.json as it is from detection on.
    std::string page = read(out / "quadruped/page.json");
    page.replace(page.find("\"ok\""), 4, "\"unfinished\"");
    write(out / "quadruped/page.json", page);
    fs::rename(out / "quadruped/character-1/animation-idle.apng",
               out / "quadruped/character-1/.animation-idle.apng.123.part");
    // Detection alone is not the whole way.
    fs::remove_all(out / "flying");
    REQUIRE(run_pantin({"detect", "testdata/flying.png", "-o", (out / "flying").string()}).code == 0);
    // Whatever is done again would be seen by its time.
    const auto time = fs::last_write_time(out / "humanoid/page.json");
    const Outcome outcome = batch(input, {"-o", out.string(), "--skip-done", "--seconds"});
    CHECK(outcome.code == 0);
    const std::vector<Json> lines = lines_of(outcome);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0]["skipped"] == true);
    CHECK(lines[0]["characters"][0]["type"] == "humanoid");
    CHECK(fs::last_write_time(out / "humanoid/page.json") == time);
    for (const std::size_t i : {1u, 2u}) CHECK_FALSE(lines[i].contains("skipped"));
    for (const Json& line : lines) CHECK(line["seconds"].is_number());
    check_same(out, wanted);
    // Another picture for the same folder is not done already.
    const Outcome other = batch(line_for("testdata/flying.png", out / "humanoid"), {"--skip-done"});
    CHECK_FALSE(lines_of(other).at(0).contains("skipped"));
    check_same(out / "humanoid", out / "flying");
}

TEST_CASE("A run that breaks off half-way leaves no page.json that looks finished", "[batch][end-to-end]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    fs::create_directories(out / "character-1/weights.txt/in the way");
    const Outcome broken = batch(line_for(small_page, out));
    CHECK(broken.code == 6);
    CHECK(Json::parse(read(out / "page.json"))["characters"][0]["status"] == "unfinished");
    fs::remove_all(out / "character-1/weights.txt");
    const Outcome outcome = batch(line_for(small_page, out), {"--skip-done"});
    CHECK(outcome.code == 0);
    CHECK_FALSE(lines_of(outcome).at(0).contains("skipped"));
    CHECK(Json::parse(read(out / "page.json"))["characters"][0]["status"] == "ok");
}

TEST_CASE("A line that is no page is a failure of that line, with its reason", "[batch]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    struct Bad {
        std::string line;
        int code;
        std::string reason;
    };
    const std::vector<Bad> all = {
        {"{\"image\": \"a.png\"", 3, "the line is not valid JSON"},
        {"{\"image\": \"a.png\"} 5", 3, "the line is not valid JSON"},
        {"\xff\xfe.png", 3, "the line is not UTF-8"},
        {"{\"image\": \"\xc3\x28\"}", 3, "the line is not UTF-8"},
        {std::string("a\0b.png", 7), 3, "the line holds a zero byte"},
        {std::string((1 << 20) + 1, 'x'), 3, "the line has more than 1048576 bytes"},
        {"{}", 2, "line: misses \"image\""},
        {"{\"image\": \"\"}", 2, "line: image: must not be empty"},
        {"{\"image\": 5}", 2, "line: image: must be a string"},
        {"{\"image\": \"a\\u0000b\"}", 2, "line: image: holds a zero byte"},
        {"{\"image\": \"a.png\", \"out\": null}", 2, "line: out: must be a string"},
        {"{\"image\": \"a.png\", \"colour\": 1}", 2, "line: colour: there is no such option"},
        {"{\"image\": \"a.png\", \"threads\": 1}", 2, "line: threads: there is no such option"},
        {"{\"image\": \"a.png\", \"rotate\": 45}", 2, "line: rotate: must be 0, 90, 180 or 270"},
        {"{\"image\": \"a.png\", \"size\": 8}", 2, "line: size: must lie between 16 and 4096"},
        {"{\"image\": \"a.png\", \"fps\": \"25\"}", 2, "line: fps: must be a number"},
        {"{\"image\": \"a.png\", \"formats\": \"gif\"}", 2, "line: formats: must be a list"},
        {"{\"image\": \"a.png\", \"formats\": [\"avi\"]}", 2, "--format: 'avi'"},
        {"{\"image\": \"a.png\", \"preset\": \"best\"}", 2, "--preset: there is no preset 'best'"},
        {"{\"image\": \"a.png\", \"config\": {\"speed\": 1}}", 3, "config: there is no option 'speed'"},
        {"{\"image\": \"a.png\", \"config\": \"none.json\"}", 3, "none.json: no such file"},
        {"{\"image\": \"a.png\", \"reference\": \"unicorn\"}", 3, "there is no reference 'unicorn'"},
        {" {not a name}", 3, "the line is not valid JSON"},
    };
    std::string input;
    for (const Bad& bad : all) input += bad.line + "\n \r\n\n"; // empty lines are none
    const Outcome outcome = batch(input, {"-o", out, "--threads", "2"});
    CHECK(outcome.code == 3);
    const std::vector<Json> lines = lines_of(outcome);
    REQUIRE(lines.size() == all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        CAPTURE(all[i].reason);
        CHECK(lines[i]["code"] == all[i].code);
        CHECK(lines[i]["status"].get<std::string>().starts_with("error: " + all[i].reason));
        CHECK(lines[i]["characters"].empty());
    }
    CHECK(lines[11]["image"] == "a.png");
    CHECK_FALSE(fs::exists(out));
}

TEST_CASE("Two lines cannot have one folder", "[batch]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const std::string input =
        line_for("none.png", folder / "out/a") + line_for("none.png", folder / "out/b/../a/") + "x/a.png\n";
    const std::vector<Json> lines = lines_of(batch(input, {"-o", out}));
    REQUIRE(lines.size() == 3);
    CHECK(lines[0]["code"] == 3);
    for (const std::size_t i : {1u, 2u}) {
        CHECK(lines[i]["code"] == 2);
        CHECK(lines[i]["status"].get<std::string>().ends_with(": is the folder of an earlier line"));
    }
    const Outcome nowhere = batch("none.png\n");
    CHECK(lines_of(nowhere).at(0)["status"] ==
          "error: where to? The line has no \"out\", and there is no --output");
}

TEST_CASE("What is wrong with the whole batch is said once", "[batch]") {
    const TemporaryFolder folder;
    const Words none = {(folder / "none").string()};
    const std::vector<std::pair<Words, int>> all = {{Words{"--weights"} + none, 5},
                                                    {Words{"--config"} + none, 3},
                                                    {{"--preset", "best"}, 2},
                                                    {{"--reference", "unicorn"}, 3}};
    for (const auto& [words, code] : all) {
        const Outcome outcome = batch("a.png\nb.png\n", words);
        CHECK(outcome.code == code);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    }
    const Outcome empty = batch("");
    CHECK(empty.code == 0);
    CHECK((empty.out + empty.err).empty());
}

TEST_CASE("A batch whose output cannot be written ends; one whose reader has gone ends quietly", "[batch]") {
    if (fs::exists("/dev/full")) {
        const Outcome full = run_pantin({"batch", "-o", "none"}, {}, "/dev/full", "none.png\n");
        CHECK(full.code == 6);
        CHECK(full.err == "pantin: standard output: cannot be written\n");
    }
    const TemporaryFolder folder;
    std::string many;
    for (int i = 0; i < 5000; ++i) many += "none" + std::to_string(i) + ".png\n";
    write(folder / "in", many);
    // The shell's `true` reads nothing; the sleep lets it be gone.
    const std::string command = "(sleep 0.2; \"$PANTIN\" batch -o none < '" + (folder / "in").string() +
                                "' 2> '" + (folder / "err").string() + "') | true";
    CHECK(std::system(command.c_str()) == 0);
    CHECK(read(folder / "err").empty());
}
