// SPDX-License-Identifier: MIT
// docs/presets.md: every option in which the presets differ, with its two values.
#include <catch2/catch.hpp>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "pantin/options.hpp"
#include "support/folders.hpp"

using namespace pantin;
using pantin::test::read;

namespace {

struct Row {
    std::string place, option, thesis, standard, gain;
};

std::string without_quotes(std::string text) {
    std::erase(text, '"');
    return text;
}

// Rows `| place | words | `option` | thesis | default | gain |`.
std::vector<Row> rows_of(const std::string& page) {
    static const std::regex row(
        R"(^\| ([^|]+) \| [^|]+ \| `([a-z_.]+)` \| ([^|]+) \| ([^|]+) \| ([^|]+) \|$)");
    std::vector<Row> rows;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_match(line, match, row))
            rows.push_back({match[1], match[2], match[3], match[4], match[5]});
    }
    return rows;
}

std::map<std::string, std::string> values_of(const char* preset) {
    std::map<std::string, std::string> values;
    for (const auto& [name, value] : list_options(make_preset(preset))) values[name] = without_quotes(value);
    return values;
}

} // namespace

TEST_CASE("The table of the presets names every option that differs, and its values", "[docs]") {
    const auto standard = values_of("default"), thesis = values_of("thesis");
    std::set<std::string> differing, listed;
    for (const auto& [name, value] : standard)
        if (thesis.at(name) != value) differing.insert(name);
    for (const Row& row : rows_of(read("docs/presets.md"))) {
        CAPTURE(row.option);
        REQUIRE(standard.count(row.option) == 1);
        CHECK(listed.insert(row.option).second);
        CHECK(row.thesis == thesis.at(row.option));
        CHECK(row.standard == standard.at(row.option));
        CHECK(row.gain != "");
    }
    CHECK(listed == differing);
}

TEST_CASE("The places that the table of the presets names are rows of thesis-to-code.md", "[docs]") {
    const std::string code = read("docs/thesis-to-code.md");
    for (const Row& row : rows_of(read("docs/presets.md"))) {
        CAPTURE(row.place);
        CHECK((row.place == "own" || code.find("\n| " + row.place + " |") != std::string::npos));
    }
}
