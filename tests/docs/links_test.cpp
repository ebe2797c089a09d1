// SPDX-License-Identifier: MIT
// Links between the pages of the documentation lead somewhere, and so do the names of tests in
// docs/robustness.md.
#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <set>

#include "support/folders.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pages() {
    std::vector<fs::path> found = {"README.md", "weights/README.md"};
    for (const auto& entry : fs::recursive_directory_iterator("docs"))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    return found;
}

// What a heading is called in a link: in small letters, without punctuation, blanks as hyphens.
std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == ' ')
            anchor += '-';
        else if (c == '-' || c == '_' || byte >= 0x80 || std::isalnum(byte))
            anchor += static_cast<char>(std::tolower(byte));
    }
    return anchor;
}

std::set<std::string> anchors_of(const std::string& page) {
    static const std::regex heading("(^|\n)#+ ([^\n]+)");
    std::set<std::string> anchors;
    for (std::sregex_iterator match(page.begin(), page.end(), heading), end; match != end; ++match)
        anchors.insert(anchor_of((*match)[2]));
    return anchors;
}

std::vector<std::string> targets_in(const std::string& page) {
    static const std::regex link(R"(\]\(([^()\s]+)\))");
    std::vector<std::string> targets;
    for (std::sregex_iterator match(page.begin(), page.end(), link), end; match != end; ++match)
        targets.push_back((*match)[1]);
    return targets;
}

} // namespace

TEST_CASE("Every link of the documentation leads to a file, and to a heading in it", "[docs][links]") {
    int links = 0;
    for (const fs::path& page : pages()) {
        const std::string text = read(page);
        for (const std::string& target : targets_in(text)) {
            if (target.find("://") != std::string::npos) continue;
            CAPTURE(page.string(), target);
            const std::size_t hash = target.find('#');
            const std::string file = target.substr(0, hash);
            const fs::path path = file.empty() ? page : page.parent_path() / file;
            CHECK(fs::exists(path));
            if (hash != std::string::npos && fs::is_regular_file(path))
                CHECK(anchors_of(read(path)).contains(target.substr(hash + 1)));
            ++links;
        }
    }
    CHECK(links > 300);
}

TEST_CASE("Every test that docs/robustness.md names is there", "[docs][links]") {
    static const std::regex named("\\]\\(\\.\\./(tests/[^)]+)\\): \"([^\"]+)\"");
    const std::string page = std::regex_replace(read("docs/robustness.md"), std::regex("\\s+"), " ");
    int count = 0;
    for (std::sregex_iterator match(page.begin(), page.end(), named), end; match != end; ++match, ++count) {
        CAPTURE((*match)[0].str());
        CHECK(read(std::string((*match)[1])).find('"' + (*match)[2].str()) != std::string::npos);
    }
    CHECK(count >= 40);
}
