// SPDX-License-Identifier: MIT
// `pantin evaluate`: measures against values worked out by hand, a generated dataset, datasets with faults.
#include <catch2/catch.hpp>

#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "evaluation/dataset.hpp"
#include "pantin/error.hpp"
#include "pantin/evaluation.hpp"
#include "pantin/image.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"

namespace pantin::test {
namespace {

namespace fs = std::filesystem;

FoundCharacter found(const char* page, double score, int character, double overlap) {
    return {page, score, character, character, overlap, overlap};
}

std::string failure(const fs::path& folder) {
    try {
        const Dataset dataset(folder);
        for (std::size_t i = 0; i < dataset.size(); ++i) dataset.page(i);
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("Average precision is the area under the monotone precision, worked out by hand") {
    Evaluation evaluation;
    evaluation.characters.resize(4);
    // By score: hit, miss (too little), hit, a second answer for a character that is taken.
    evaluation.found = {found("a", 0.9, 0, 0.8), found("a", 0.8, 1, 0.4), found("b", 0.7, 0, 0.9),
                        found("b", 0.6, 0, 0.7)};
    CHECK(average_precision(evaluation, 0.5, true) == Approx((1 + 2.0 / 3) / 4));
    CHECK(average_precision(evaluation, 0.85, true) == Approx(1.0 / 3 / 4));
    CHECK(average_precision(evaluation, 0.3, false) == Approx(3.0 / 4));
    CHECK(std::isnan(average_precision(Evaluation{}, 0.5, true)));
}

TEST_CASE("Perfect answers get an average precision of one whatever their scores") {
    Evaluation evaluation;
    evaluation.characters.resize(3);
    evaluation.found = {found("a", 0.1, 1, 1), found("a", 0.1, 0, 1), found("b", 0.9, 0, 1)};
    CHECK(average_precision(evaluation, 0.5, true) == 1);
}

TEST_CASE("A page without a label map changes neither average precision nor the stages",
          "[cli][end-to-end]") {
    const TemporaryFolder folder;
    write_dataset(folder / "data");
    const auto result = [&](const std::string& out) {
        const Outcome outcome =
            run_pantin({"evaluate", (folder / "data").string(), "-o", (folder / out).string()});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        CHECK((outcome.out.find("\n1 without a label map: ") != std::string::npos) == (out == "more"));
        return nlohmann::json::parse(read_text(folder / out / "evaluation.json"));
    };
    const nlohmann::json before = result("before");
    fs::copy_file(folder / "data/image/page-1.png", folder / "data/image/more.png");
    const std::string index = read_text(folder / "data/index.ndjson");
    write_file(folder / "data/index.ndjson",
               std::string_view(index + "{\"id\": \"more\", \"type\": \"humanoid\"}\n"));
    const nlohmann::json after = result("more");
    CHECK((before["unlabelled_pages"] == 0 && after["unlabelled_pages"] == 1));
    CHECK((before["pages"] == 2 && after["pages"] == 3));
    for (const char* key : {"characters", "detection", "stages"}) CHECK(before[key] == after[key]);
    int types = 0; // its type is known, so it is in that table
    for (const auto& [answer, count] : after["identification"]["humanoid"].items()) types += count.get<int>();
    CHECK(types == 3);
    CHECK(after["results"].size() == before["results"].size() + 1);
}

TEST_CASE("Average precision is of labelled pages alone; a page that is known to be empty is one") {
    Evaluation evaluation;
    evaluation.characters.resize(3);
    evaluation.found = {found("a", 0.9, 0, 0.8), found("a", 0.8, 1, 0.9)};
    CHECK(average_precision(evaluation, 0.5, true) == Approx(2.0 / 3));
    evaluation.characters[2].labelled = false;
    CHECK(average_precision(evaluation, 0.5, true) == 1);
    TruePage page;
    CHECK(page.is_labelled());
    page.characters.resize(1);
    CHECK_FALSE(page.is_labelled());
    page.labels = LabelMap(2, 2, 0);
    CHECK(page.is_labelled());
}

TEST_CASE("pantin evaluate judges every character of a generated dataset", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    write_dataset(folder / "data");
    const Outcome outcome = run_pantin({"evaluate", (folder / "data").string(), "-o",
                                        (folder / "out").string(), "--csv", (folder / "tables").string()});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.find("\nseconds (detect: a page; else a character)\n  detect ") != std::string::npos);
    const std::string csv = read_text(folder / "tables" / "measurements.csv");
    CHECK(csv.find("\nseconds,page,detect,") != std::string::npos);
    CHECK(csv.find("\nseconds,character,rig,") != std::string::npos);
    const std::string rows = read_text(folder / "tables" / "characters.csv");
    CHECK(std::count(rows.begin(), rows.end(), '\n') == 5);
    CHECK(outcome.out.starts_with("2 pages, 4 characters, "));
    const nlohmann::json json = nlohmann::json::parse(read_text(folder / "out" / "evaluation.json"));
    CHECK(json["pages"] == 2);
    CHECK(json["results"].size() == 4);
    const int detected = json["stages"]["detected"], missed = json["detection"]["missed"];
    CHECK(detected + missed == 4);
    CHECK(detected >= 3);
    for (const nlohmann::json& result : json["results"])
        CHECK(result["found"] == (result["mask_overlap"] >= 0.5));
    const double ap50 = json["detection"]["mask_ap50"], ap75 = json["detection"]["mask_ap75"];
    CHECK(ap50 >= ap75);
    const double head = json["segmentation"]["all"]["head"];
    CHECK((head > 0.3 && head <= 1));
    const std::string html = read_text(folder / "out" / "evaluation.html");
    CHECK(html.find("pages/page-1/character-1/drawing.png") != std::string::npos);
    CHECK(fs::exists(folder / "out" / "pages" / "page-1" / "character-1" / "drawing.png"));
}

TEST_CASE("An evaluation counts the characters with a warning of each kind", "[warnings]") {
    Evaluation evaluation;
    evaluation.characters.resize(3);
    evaluation.characters[0].warnings = {{WarningKind::lost_ink, 0.5, ""},
                                         {WarningKind::unsure_type, 0.25, ""}};
    evaluation.characters[2].warnings = {{WarningKind::unsure_type, 0.125, ""}};
    const nlohmann::json json = nlohmann::json::parse(evaluation_to_json(evaluation));
    CHECK(json["warnings"].size() == warning_table.size());
    for (const WarningRow& row : warning_table)
        CHECK(json["warnings"][std::string(row.name)] == (row.kind == WarningKind::lost_ink      ? 1
                                                          : row.kind == WarningKind::unsure_type ? 2
                                                                                                 : 0));
    CHECK(json["results"][0]["warnings"] == nlohmann::json{"lost_ink", "unsure_type"});
    CHECK(json["results"][1]["warnings"] == nlohmann::json::array());
    const std::string text = evaluation_to_text(evaluation);
    const std::string table = text.substr(text.find("\nwarnings (of all characters)\n"));
    CHECK(std::regex_search(table, std::regex("\n  any +2 of 3   +0\\.667 \\[0\\.21–0\\.94\\]\n")));
    CHECK(std::regex_search(table, std::regex("\n  lost_ink +1 of 3 ")));
    CHECK(std::regex_search(table, std::regex("\n  unsure_type +2 of 3 ")));
    CHECK(table.find("filled_crop") == std::string::npos); // nobody has it
}

TEST_CASE("Both ends of a share's interval are where the share is 1.96 standard deviations away") {
    for (const auto& [hits, count] : {std::pair{0, 5}, {1, 3}, {7, 10}, {53, 60}, {40, 40}, {900, 1000}}) {
        const Interval interval = share_interval(hits, count);
        const double share = static_cast<double>(hits) / count;
        CAPTURE(hits, count, interval.low, interval.high);
        CHECK((interval.low <= share && share <= interval.high));
        CHECK((interval.low >= 0 && interval.high <= 1));
        for (const double end : {interval.low, interval.high})
            if (end > 0 && end < 1)
                CHECK(std::fabs(share - end) ==
                      Approx(1.959964 * std::sqrt(end * (1 - end) / count)).epsilon(1e-5));
    }
    CHECK(std::isnan(share_interval(0, 0).low));
}

TEST_CASE("The interval of a mean is 1.96 standard errors to both sides") {
    const Interval interval = mean_interval({1, 2, 3, 4}); // deviation √(5/3), error √(5/12)
    CHECK(interval.low == Approx(2.5 - 1.959964 * std::sqrt(5.0 / 12)));
    CHECK(interval.high == Approx(2.5 + 1.959964 * std::sqrt(5.0 / 12)));
    CHECK(mean_interval({7, 7, 7}).low == mean_interval({7, 7, 7}).high);
    CHECK(std::isnan(mean_interval({1}).low));
}

namespace {

// Pages a, b, … with one character each; the answer on page i overlaps it by overlaps[i].
Evaluation one_a_page(const std::vector<double>& overlaps) {
    Evaluation evaluation;
    evaluation.characters.resize(overlaps.size());
    for (std::size_t i = 0; i < overlaps.size(); ++i) {
        const std::string page(1, static_cast<char>('a' + i));
        evaluation.characters[i].page = page;
        evaluation.labelled_pages.push_back(page);
        evaluation.found.push_back(found(page.c_str(), 0.9 - 0.01 * static_cast<double>(i), 0, overlaps[i]));
    }
    return evaluation;
}

} // namespace

TEST_CASE("The interval of average precision comes from draws of pages") {
    const auto interval_of = [](const std::vector<double>& overlaps) {
        return average_precision_interval(one_a_page(overlaps), 0.5, true);
    };
    const Interval perfect = interval_of({1, 1, 1, 1});
    CHECK((perfect.low == 1 && perfect.high == 1));
    // Of two pages, one of them without a hit: a quarter of all draws has the good one alone, a quarter the
    // bad.
    const Interval two = interval_of({1, 0});
    CHECK((two.low == 0 && two.high == 1));
    // Of 24 pages with 12 hits of the highest scores the precision is 1 at every hit, so the average
    // precision is the share of good pages in the draw: binomial, 0.5 ± 1.96 √(0.25 / 24).
    std::vector<double> overlaps(24, 0);
    std::fill(overlaps.begin(), overlaps.begin() + 12, 1);
    const Interval half = interval_of(overlaps);
    CHECK(half.low == Approx(0.5 - 1.96 * std::sqrt(0.25 / 24)).margin(0.03));
    CHECK(half.high == Approx(0.5 + 1.96 * std::sqrt(0.25 / 24)).margin(0.03));
    CHECK(interval_of(overlaps).low == half.low); // the same draws every time
    CHECK(std::isnan(interval_of({1}).low));
}

TEST_CASE("Every value of the tables has its interval and its count, in JSON and CSV alike") {
    Evaluation evaluation = one_a_page({0.9, 0.8, 0.2, 0.7});
    evaluation.pages = 4;
    for (CharacterResult& c : evaluation.characters) {
        c.type = "humanoid", c.species = "person, running", c.status = "ok";
        c.part_overlap.fill(-1), c.part_overlap[1] = 0.5, c.part_overlap[2] = c.page == "a" ? 0.1 : 0.95;
        c.ends = {5, 4, true};
    }
    evaluation.characters[0].found = evaluation.characters[1].found = evaluation.characters[3].found = true;
    evaluation.characters[0].identified = evaluation.characters[1].identified = "humanoid";
    evaluation.characters[3].identified = "quadruped";
    evaluation.seconds[0] = {0.1, 0.2, 0.3, 0.2};
    const nlohmann::json json = nlohmann::json::parse(evaluation_to_json(evaluation));
    const std::string csv = measurements_to_csv(measurements_of(evaluation));
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "table,group,measure,value,low,high,count,hits");
    std::set<std::string> tables;
    for (const nlohmann::json& row : json["measurements"]) {
        CAPTURE(row.dump());
        REQUIRE(std::getline(lines, line));
        const std::string table = row["table"];
        tables.insert(table);
        CHECK(line.starts_with(table + ","));
        if (!row["hits"].is_null()) {
            const int hits = row["hits"], count = row["count"];
            CHECK(line.ends_with("," + std::to_string(count) + "," + std::to_string(hits)));
            if (count > 0) CHECK(row["value"] == static_cast<double>(hits) / count);
        }
        const bool counted = row["measure"] != "characters" && row["count"] > 1;
        CHECK(row["low"].is_null() == !counted);
        if (counted) CHECK((row["low"] <= row["value"] && row["value"] <= row["high"]));
        if (counted && table != "seconds") CHECK((row["low"] >= 0 && row["high"] <= 1));
    }
    CHECK_FALSE(std::getline(lines, line));
    CHECK(tables == std::set<std::string>{"detection", "segmentation", "identification", "stages", "ends",
                                          "warnings", "seconds"});
    CHECK(csv.find("\nstages,all,rigged,0.75,") != std::string::npos);
    CHECK(csv.find("\nseconds,page,detect,0.2,") != std::string::npos);
    CHECK(csv.find("\nsegmentation,\"all, humanoid, person, running\",head,0.5,0.5,0.5,4,\n") !=
          std::string::npos);
    CHECK(json["identification"]["humanoid"] ==
          nlohmann::json{{"humanoid", 2}, {"none", 1}, {"quadruped", 1}});
    const std::string characters = characters_to_csv(evaluation);
    CHECK(std::count(characters.begin(), characters.end(), '\n') == 5);
    CHECK(characters.find("\na,humanoid,\"person, running\",true,true,") != std::string::npos);
}

TEST_CASE("A dataset with a fault is refused with the fact") {
    const TemporaryFolder folder;
    const fs::path data = folder / "data", index = data / "index.ndjson";
    CHECK(failure(data) == index.string() + ": no such file");
    fs::create_directories(data);
    write_file(index, std::string_view("\n"));
    CHECK(failure(data) == index.string() + ": lists no drawing");
    write_file(index, std::string_view("{\"id\": \"a\"}\n{\"name\": \"b\"}\n"));
    CHECK(failure(data) == index.string() + ":2: misses \"id\"");
    write_file(index, std::string_view("{\"id\": \"../a\"}\n"));
    CHECK(failure(data) == index.string() + ":1: id: is no name of a file");
    write_dataset(data);
    fs::remove(data / "instance" / "page-2.png");
    fs::copy_file("testdata/demo.png", data / "instance" / "page-2.png");
    CHECK(failure(data) ==
          (data / "instance" / "page-2.png").string() + ": has another size than the label map");
}

} // namespace pantin::test
