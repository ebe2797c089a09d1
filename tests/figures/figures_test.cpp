// SPDX-License-Identifier: MIT
// The figures of docs/figures, drawn again: the same bytes.
#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <set>

#include "figures/figures.hpp"
#include "figures/svg.hpp"
#include "support/folders.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

std::set<std::string> names_in(const std::string& text, const std::string& pattern) {
    std::set<std::string> names;
    const std::regex expression(pattern);
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
        names.insert((*match)[1].str());
    return names;
}

} // namespace

TEST_CASE("docs/figures is what make figures draws today, and its index lists every figure", "[figures]") {
    std::set<std::string> drawn;
    for (const figures::Figure& figure : figures::all_figures("testdata")) {
        INFO(figure.name << ": make figures");
        drawn.insert(figure.name);
        CHECK((read("docs/figures/" + figure.name) == figure.svg)); // in brackets: no pictures in the report
    }
    std::set<std::string> there;
    for (const auto& entry : std::filesystem::directory_iterator("docs/figures"))
        if (entry.path().extension() != ".md") there.insert(entry.path().filename());
    CHECK(there == drawn);
    CHECK(names_in(read("docs/figures/README.md"), R"(\]\(([\w.-]+\.svg)\))") == drawn);
}

TEST_CASE("figures write numbers with few decimals and text that XML allows", "[figures]") {
    CHECK(figures::shown(3) == "3");
    CHECK(figures::shown(-0.254) == "−0.25");
    CHECK(figures::shown(-2.5, 2, true) == "−2.50");
    figures::Svg svg(10, 20);
    svg.circle({1.0 / 3, -0.001}, 2, {});
    svg.text({1, 2}, "a < b & \"c\"");
    svg.image({0, 0, 1, 1}, {'M', 'a', 'n', '!'});
    const std::string document = svg.document("A & B");
    CHECK(document.find("a &lt; b &amp; &quot;c&quot;") != std::string::npos);
    CHECK(document.find("<title>A &amp; B</title>") != std::string::npos);
    CHECK(document.find("cx=\"0.33\" cy=\"0\" r=\"2\"") != std::string::npos);
    CHECK(document.find("base64,TWFuIQ==\"") != std::string::npos);
    CHECK(document.find("fill=\"#ffffff\"") != std::string::npos); // readable in dark mode
}
