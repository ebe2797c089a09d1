// SPDX-License-Identifier: MIT
// The tables of docs/thesis-to-code.md.
#pragma once

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/folders.hpp"

namespace pantin::test {

inline const std::filesystem::path thesis_to_code = "docs/thesis-to-code.md";

struct Row {
    std::string place, what, claim, code;
};

// Of the tables whose header begins with "place".
inline std::vector<Row> rows_of(const std::string& text) {
    std::vector<Row> rows;
    bool inside = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) inside = false;
        if (line.starts_with("| place |")) inside = true;
        if (!inside || line.starts_with("| place |") || line.starts_with("|---")) continue;
        CAPTURE(line);
        std::vector<std::string> cells;
        std::size_t begin = 2;
        for (std::size_t end = line.find(" | "); end != std::string::npos; end = line.find(" | ", begin)) {
            cells.push_back(line.substr(begin, end - begin));
            begin = end + 3;
        }
        cells.push_back(line.substr(begin, line.rfind(" |") - begin));
        REQUIRE(cells.size() == 4);
        rows.push_back({cells[0], cells[1], cells[2], cells[3]});
    }
    return rows;
}

// [`name`](file)
struct Link {
    std::string name, file;
};

inline std::vector<Link> links_in(const std::string& cell) {
    static const std::regex link(R"(\[`([^`]+)`\]\(([^)]+)\))");
    std::vector<Link> found;
    for (std::sregex_iterator match(cell.begin(), cell.end(), link), end; match != end; ++match)
        found.push_back({(*match)[1], (*match)[2]});
    return found;
}

// What stands between two `.
inline std::vector<std::string> quoted_in(const std::string& cell) {
    static const std::regex quoted("`([^`]+)`");
    std::vector<std::string> found;
    for (std::sregex_iterator match(cell.begin(), cell.end(), quoted), end; match != end; ++match)
        found.push_back((*match)[1]);
    return found;
}

} // namespace pantin::test
