// SPDX-License-Identifier: MIT
// docs/thesis-to-code.md is complete, and what it names exists.
#include <algorithm>

#include "docs/thesis_to_code.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

// What both publications number, but for what has a row for a range of figures.
std::vector<std::string> numbered() {
    std::vector<std::string> places;
    const auto add = [&](const std::string& prefix, int first, int last) {
        for (int i = first; i <= last; ++i) places.push_back(prefix + std::to_string(i));
    };
    add("Eq. 3.", 1, 6);
    add("Eq. 4.", 1, 14);
    add("Algorithm 4.", 1, 4);
    add("Fig. 3.", 1, 14);
    add("Fig. 4.", 1, 19);
    add("3.", 1, 4);
    add("4.", 1, 6);
    add("6.", 1, 3);
    for (const char* place : {"1", "2", "7", "Def. 3.4.1", "Table 5.1", "Fig. 6.9", "Fig. 6.10",
                              "RealSkel Eq. (1)", "RealSkel 4.1, weights", "RealSkel Table 2"})
        places.emplace_back(place);
    add("RealSkel Algorithm ", 1, 3);
    add("RealSkel Def. ", 1, 6);
    add("RealSkel 3.", 1, 3);
    add("RealSkel Fig. ", 2, 11);
    for (const char* place : {"RealSkel 1", "RealSkel 2", "RealSkel 4", "RealSkel 4.2", "RealSkel 5"})
        places.emplace_back(place);
    return places;
}

bool is_word(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); }

// Whether only words, ::, <>, &, * and blanks stand between the line's beginning and the name, and none is a
// statement's keyword.
bool begins_declaration(const std::string& before) {
    static const std::regex type(R"([\w\s:<>,&*\[\]]*)"), statement(R"(\b(return|else|throw|case|new)\b)");
    return before.find_first_not_of(' ') != std::string::npos && std::regex_match(before, type) &&
           !std::regex_search(before, statement);
}

// Whether the parameter list that opens at `open` is followed by a body and not by a semicolon.
bool has_body(const std::string& text, std::size_t open) {
    int depth = 0;
    std::size_t i = open;
    for (; i < text.size(); ++i) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (depth == 0) break;
    }
    const std::size_t next = text.find_first_of("{;", i);
    return next != std::string::npos && text[next] == '{';
}

// Whether the source defines the function, method or type. A.b may be defined in the class A.
bool defines(const std::string& source, const std::string& qualified) {
    const std::size_t colons = qualified.rfind("::");
    const std::string name = colons == std::string::npos ? qualified : qualified.substr(colons + 2);
    const std::string owner = colons == std::string::npos ? "" : qualified.substr(0, colons);
    if (std::regex_search(source,
                          std::regex("(^|\n)(template <[^\n]*> )?(struct|class|enum class|def|using) " +
                                     name + "\\b(?!;)")))
        return true;
    for (std::size_t at = source.find(name + "("); at != std::string::npos;
         at = source.find(name + "(", at + 1)) {
        if (at > 0 && is_word(source[at - 1])) continue;
        const std::size_t line = source.rfind('\n', at) + 1;
        const std::string before = source.substr(line, at - line);
        if (!owner.empty() && !std::regex_search(before, std::regex(owner + "(<\\w+>)?::$")) &&
            !std::regex_search(source, std::regex("(struct|class) " + owner + " ")))
            continue;
        if (begins_declaration(before) && has_body(source, at + name.size())) return true;
    }
    return false;
}

} // namespace

TEST_CASE("Every numbered equation, algorithm, definition and figure of both publications has one row",
          "[docs]") {
    const std::vector<Row> rows = rows_of(read(thesis_to_code));
    for (const std::string& place : numbered()) {
        CAPTURE(place);
        CHECK(std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return row.place == place; }) ==
              1);
    }
}

TEST_CASE("Every row names a function that its file defines, or says why none does", "[docs]") {
    for (const Row& row : rows_of(read(thesis_to_code))) {
        CAPTURE(row.place, row.code);
        const std::vector<Link> functions = links_in(row.code);
        CHECK((!functions.empty() || row.code.starts_with("not applicable: ")));
        for (const auto& [name, file] : functions) {
            CAPTURE(name, file);
            const fs::path path = thesis_to_code.parent_path() / file;
            REQUIRE(fs::is_regular_file(path));
            CHECK(defines(read(path), name));
        }
    }
}

TEST_CASE("A declaration, a call and another name are no definition", "[docs]") {
    CHECK(defines("int a;\nMask thin(const Mask& m) {\n", "thin"));
    CHECK(defines("    bool step(int i,\n              int j) const {\n", "step"));
    CHECK(defines("Tensor Linear::forward(const Tensor& t) const {", "Linear::forward"));
    CHECK(defines("struct Head {\n  int forward(int x) const { return x; }\n};", "Head::forward"));
    CHECK(defines("class Model {\n", "Model"));
    CHECK_FALSE(defines("Mask thin(const Mask& m);\n", "thin"));
    CHECK_FALSE(defines("    return thin(m); }\nvoid f() {", "thin"));
    CHECK_FALSE(defines("    if (thin(m)) {\n", "thin"));
    CHECK_FALSE(defines("    image = thin(m); if (x) {", "thin"));
    CHECK_FALSE(defines("Mask thinned(const Mask& m) {", "thin"));
    CHECK_FALSE(defines("Tensor Linear::forward(const Tensor& t) const {", "Convolution::forward"));
    CHECK_FALSE(defines("class Model;\n", "Model"));
}
