// SPDX-License-Identifier: MIT
// `pantin evaluate --sweep`: each combination is what a run of its own with these options is.
#include <catch2/catch.hpp>

#include <sstream>

#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "evaluation/dataset.hpp"
#include "pantin/sweep.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"

namespace pantin::test {
namespace {

namespace fs = std::filesystem;

std::string refusal(const std::string& text) {
    try {
        parse_sweep(text);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::usage);
        return error.what();
    }
    return "";
}

// Without what differs from run to run.
nlohmann::json without_times(const fs::path& file) {
    nlohmann::json json = nlohmann::json::parse(read_text(file));
    nlohmann::json kept = nlohmann::json::array();
    for (const nlohmann::json& row : json["measurements"])
        if (row["table"] != "seconds") kept.push_back(row);
    CHECK(kept.size() + 5 == json["measurements"].size());
    json["measurements"] = kept;
    return json;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

} // namespace

TEST_CASE("A sweep is options with values, by their names or the ends of them") {
    const auto two = parse_sweep("identification.k_v=1, 2.5 ; skeletonization.residual=arc,\"chord\"");
    REQUIRE(two.size() == 2);
    CHECK((two[0].name == "identification.k_v" && two[0].values == std::vector<std::string>{"1", "2.5"}));
    CHECK(two[1].name == "skeletonization.residual");
    CHECK(two[1].values == std::vector<std::string>{"\"arc\"", "\"chord\""});
    const auto thesis = parse_sweep("K_v=1,2,K_l=3,use_evidence=true"); // as the thesis writes them
    REQUIRE(thesis.size() == 3);
    CHECK((thesis[0].name == "identification.k_v" && thesis[0].values.size() == 2));
    CHECK((thesis[1].name == "identification.k_l" && thesis[2].name == "identification.use_evidence"));
}

TEST_CASE("A wrong sweep is refused with the fact") {
    CHECK(refusal("") == "--sweep: '' is not option=value,value;option=value");
    CHECK(refusal("1,2") == "--sweep: '1' is not option=value,value;option=value");
    CHECK(refusal("identificaton.k_v=1") ==
          "--sweep: there is no option 'identificaton.k_v'; did you mean 'identification.k_v'?");
    CHECK(refusal("tolerance=0.1") ==
          "--sweep: 'tolerance' may be 'segmentation.tolerance' or 'modeling.tolerance'");
    CHECK(refusal("k_v=1,2000") == "--sweep: identification.k_v: must lie between 0 and 1000");
    CHECK(refusal("k_v=much") == "--sweep: identification.k_v: must be a number");
    CHECK(refusal("residual=angle") == "--sweep: skeletonization.residual: must be arc or chord");
    CHECK(refusal("k_v=1,1") == "--sweep: identification.k_v: 1 stands twice");
    CHECK(refusal("k_v=1;identification.k_v=2") == "--sweep: 'identification.k_v' stands twice");
    CHECK(refusal("k_v=[1]") == "--sweep: identification.k_v: '[1]' is no single value");
    CHECK(refusal("k_v=") != "");
    std::string many;
    for (const char* name : {"k_v", "k_e", "k_l"}) {
        many += std::string(many.empty() ? "" : ";") + name + "=";
        for (int i = 0; i < 11; ++i) many += (i == 0 ? "" : ",") + std::to_string(i);
    }
    CHECK(refusal(many) == "--sweep: more than 1000 combinations");
}

TEST_CASE("Each combination of a sweep is byte for byte what a run with --config is", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    write_dataset(folder / "data", 2);
    const std::string data = (folder / "data").string();
    // The first step that changes: identification, after shared steps; and detection, without any.
    const auto [option, first, second, shared] = GENERATE(table<std::string, std::string, std::string, bool>(
        {{"identification.use_evidence", "true", "false", true},
         {"skeletonization.residual_threshold", "15", "60", true},
         {"detection.detector", "mask-rcnn", "contour", false}}));
    CAPTURE(option);
    const Outcome outcome = run_pantin({"evaluate", data, "-o", (folder / "sweep").string(), "--sweep",
                                        option + "=" + first + "," + second + ";rigging.limb_segments=1,2"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(fs::exists(folder / "sweep/shared") == shared);
    const std::vector<std::string> lines = lines_of(outcome.out);
    REQUIRE(lines.size() == 5);
    CHECK(lines[0].starts_with(option + " "));
    const bool word = option == "detection.detector";
    int combination = 0;
    for (const std::string& value : {first, second})
        for (const char* segments : {"1", "2"}) {
            const std::string json = word ? '"' + value + '"' : value;
            write_file(folder / "config.json",
                       std::string_view("{\"" + option + "\": " + json +
                                        ", \"rigging.limb_segments\": " + segments + "}"));
            const fs::path alone = folder / "alone",
                           swept = folder / "sweep" / ("combination-" + std::to_string(++combination));
            fs::remove_all(alone);
            REQUIRE(run_pantin({"evaluate", data, "-o", alone.string(), "--config",
                                (folder / "config.json").string()})
                        .code == 0);
            CHECK(without_times(alone / "evaluation.json") == without_times(swept / "evaluation.json"));
            CHECK(read_all(alone / "pages") == read_all(swept / "pages"));
            CHECK(lines[static_cast<std::size_t>(combination)].starts_with(json + " "));
            CHECK(read_text(swept / "evaluation.txt").starts_with("2 pages, 4 characters"));
        }
    const std::vector<std::string> csv = lines_of(read_text(folder / "sweep/sweep.csv"));
    CHECK(csv[0] == option + ",rigging.limb_segments,table,group,measure,value,low,high,count,hits");
    for (const std::string& value : {first, second})
        for (const char* segments : {"1", "2"}) {
            const auto rows = std::count_if(csv.begin(), csv.end(), [&](const std::string& line) {
                return line.starts_with(value + "," + segments + ",");
            });
            CHECK(rows > 40);
        }
}

} // namespace pantin::test
