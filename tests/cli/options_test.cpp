// SPDX-License-Identifier: MIT
// `pantin options`: every option, in all three forms, is what the two presets say.
#include <catch2/catch.hpp>

#include <sstream>

#include "core/csv.hpp"
#include "pantin/pipeline.hpp"
#include "support/program.hpp"
#include "support/schemas.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

struct Row {
    std::string name, ours, thesis;
};
std::vector<Row> expected(const std::string& prefix = "") {
    const auto ours = list_options(make_preset("default")), thesis = list_options(make_preset("thesis"));
    std::vector<Row> rows;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        REQUIRE(ours[i].first == thesis[i].first);
        if (ours[i].first.rfind(prefix, 0) == 0)
            rows.push_back({ours[i].first, ours[i].second, thesis[i].second});
    }
    return rows;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string plain(std::string value) {
    value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
    return value;
}

} // namespace

TEST_CASE("pantin options prints every option with both values and marks those that differ", "[cli]") {
    const Outcome outcome = run_pantin({"options"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    const std::vector<std::string> lines = lines_of(outcome.out);
    const std::vector<Row> rows = expected();
    REQUIRE(lines.size() == rows.size() + 3);
    const std::size_t ours = lines[0].find("default"), thesis = lines[0].find("thesis");
    int differing = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string& line = lines[i + 1];
        CAPTURE(line);
        CHECK(line.substr(0, 2) == (rows[i].ours == rows[i].thesis ? "  " : "* "));
        CHECK(line.compare(2, rows[i].name.size() + 1, rows[i].name + " ") == 0);
        CHECK(line.compare(ours, rows[i].ours.size() + 1, rows[i].ours + " ") == 0); // aligned
        CHECK(line.substr(thesis) == rows[i].thesis);
        differing += rows[i].ours != rows[i].thesis;
    }
    CHECK(differing > 10);
    CHECK(lines.back() == "* differs: " + std::to_string(differing) + " of " + std::to_string(rows.size()));
}

TEST_CASE("pantin options prints the same as CSV and JSON", "[cli]") {
    const std::vector<Row> rows = expected("identification.");
    CHECK((rows.size() > 5 && rows.size() < expected().size()));
    const std::vector<std::string> lines = lines_of(run_pantin({"options", "identification", "--csv"}).out);
    REQUIRE(lines.size() == rows.size() + 1);
    CHECK(lines[0] == "option,default,thesis,differs");
    const nlohmann::json json =
        nlohmann::json::parse(run_pantin({"options", "identification", "--json"}).out);
    CHECK(schema_violation("options", json) == "");
    REQUIRE(json.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& [name, ours, thesis] = rows[i];
        CAPTURE(name);
        CHECK(lines[i + 1] ==
              name + "," + plain(ours) + "," + plain(thesis) + (ours == thesis ? ",false" : ",true"));
        CHECK(json[name]["default"] == nlohmann::json::parse(ours));
        CHECK(json[name]["thesis"] == nlohmann::json::parse(thesis));
        CHECK(json[name]["differs"] == (ours != thesis));
    }
}

TEST_CASE("pantin options filters by the beginning of the name and refuses one that no option has", "[cli]") {
    const Outcome one = run_pantin({"options", "identification.k_v"});
    CHECK(lines_of(one.out).size() == 4);
    CHECK(one.out.find("identification.k_v") != std::string::npos);
    const Outcome none = run_pantin({"options", "identificaton"});
    CHECK(none.code == 2);
    CHECK(none.out.empty());
    CHECK(none.err == "pantin: there is no option that begins with 'identificaton'; did you mean "
                      "'identification'?\n");
    CHECK(run_pantin({"options", "--csv", "--json"}).code == 2);
}

TEST_CASE("A field of CSV is quoted when it must be") {
    CHECK(csv_line({"a", "", "1.5"}) == "a,,1.5\n");
    CHECK(csv_line({"a,b", "say \"no\"", "two\nlines"}) == "\"a,b\",\"say \"\"no\"\"\",\"two\nlines\"\n");
}
