// The page's folder: page.json and the folders of its characters.
#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/character.hpp"

namespace pantin {

struct DetectedPage {
    Page page;
    std::vector<Character> characters; // drawing and mask in memory, in the order of the page's list
};

// Step 1 with its files. Nothing is written when the picture is bad or holds no character. In page.json the characters are
// unfinished.
DetectedPage run_detect(const std::filesystem::path& image, const std::filesystem::path& out,
                        Workshop& workshop);

void write_page(const std::filesystem::path& out, const Page& page);

} // namespace pantin
