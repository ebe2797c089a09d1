// SPDX-License-Identifier: MIT
// docs/references.md, followed step by step.
#include <catch2/catch.hpp>

#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/demo.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

// What stands between the fences of the first block in that language.
std::string block(const std::string& page, const std::string& language) {
    const std::string fence = "```" + language + "\n";
    const std::size_t begin = page.find(fence) + fence.size();
    return page.substr(begin, page.find("```", begin) - begin);
}

} // namespace

TEST_CASE("The reference that docs/references.md makes is chosen and dances", "[cli][references]") {
    const std::string page = read("docs/references.md");
    const TemporaryFolder folder;
    fs::create_directory(folder / "my-references");
    write(folder / "my-references/dancer.json", block(page, "json"));
    std::istringstream line(block(page, "sh"));
    std::vector<std::string> words;
    for (std::string word; line >> word;) words.push_back(word);
    REQUIRE(words.at(0) == "pantin");
    words.erase(words.begin());
    for (std::string& word : words)
        if (word == "out" || word == "my-references") word = (folder / word).string();
    const Outcome outcome = run_pantin(words + small_films);
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
    const auto json = nlohmann::json::parse(read(folder / "out/character-1/identification.json"));
    CHECK(json["reference"] == "dancer");
    CHECK(json["type"] == "humanoid");
    CHECK(read(folder / "out/character-1/character.glb").find("\"name\":\"dance\"") != std::string::npos);
}
