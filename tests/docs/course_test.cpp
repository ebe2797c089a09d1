// SPDX-License-Identifier: MIT
// The exercises of docs/course, run as they stand there.
#include <catch2/catch.hpp>

#include <algorithm>

#include "cli/demo.hpp"

using namespace pantin::test;

namespace {

namespace fs = std::filesystem;

// A fenced block of a page.
struct Block {
    std::string language, text;
};

std::vector<Block> blocks_of(const std::string& page) {
    std::vector<Block> blocks;
    for (std::size_t at = page.find("\n```"); at != std::string::npos;) {
        const std::size_t line_end = page.find('\n', at + 1), end = page.find("\n```", line_end - 1);
        REQUIRE(end != std::string::npos);
        blocks.push_back({page.substr(at + 4, line_end - at - 4), page.substr(line_end + 1, end - line_end)});
        at = page.find("\n```", end + 4);
    }
    return blocks;
}

std::vector<fs::path> pages() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator("docs/course"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

int count(const std::string& text, const std::string& what) {
    int number = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++number;
    return number;
}

} // namespace

// Commands stand in blocks of `sh`; the block of `text` in the fold below is what the last one printed.
TEST_CASE("Every exercise of the course has the answer that the program gives",
          "[docs][course][end-to-end]") {
    const TemporaryFolder folder;
    for (const char* name : {"testdata", "references"})
        fs::create_directory_symlink(fs::absolute(name), folder / name);
    fs::create_directory(folder / "out");
    copy_demo(folder / "out/demo"); // as `make demo`, with smaller films
    for (const fs::path& page : pages()) {
        std::string printed;
        int answers = 0;
        for (const Block& block : blocks_of(read(page))) {
            CAPTURE(page.string(), block.text);
            if (block.language == "text") {
                CHECK(printed == block.text);
                ++answers;
            }
            if (block.language != "sh") continue;
            const Outcome outcome = run_shell(block.text, folder.path());
            CHECK(outcome.code == 0);
            CHECK(outcome.err == "");
            printed = outcome.out;
        }
        CAPTURE(page.string());
        CHECK(answers == 3);
    }
}

TEST_CASE("Every page of the course has its sections and stands in the contents", "[docs][course]") {
    const std::string contents = read("docs/README.md");
    CHECK(pages().size() == 9);
    for (const fs::path& page : pages()) {
        CAPTURE(page.string());
        const std::string text = read(page);
        for (const char* section :
             {"\n**In:** ", "\n## Why\n", "\n## How", "\n## In the source\n", "\n## Exercises\n"})
            CHECK(text.find(section) != std::string::npos);
        CHECK(text.find("\n![") != std::string::npos); // a figure
        CHECK(text.find("errat") != std::string::npos);
        CHECK(count(text, "<details><summary>Answer</summary>") == 3);
        CHECK(count(text, "</details>") == 3);
        CHECK(contents.find("(course/" + page.filename().string() + ")") != std::string::npos);
    }
}
