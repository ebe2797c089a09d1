// SPDX-License-Identifier: MIT
// `pantin evaluate`: measures against values worked out by hand, a generated dataset, datasets with faults.
#include <catch2/catch.hpp>

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

TEST_CASE("pantin evaluate judges every character of a generated dataset", "[cli][end-to-end]") {
    const TemporaryFolder folder;
    write_dataset(folder / "data");
    const Outcome outcome =
        run_pantin({"evaluate", (folder / "data").string(), "-o", (folder / "out").string()});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
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
    CHECK(text.find("\nwarnings: 2 characters, filled_crop 0, lost_ink 1, ") != std::string::npos);
    CHECK(text.find(", unsure_type 2, unproven_distance 0\n") != std::string::npos);
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
