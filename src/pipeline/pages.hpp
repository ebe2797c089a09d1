// SPDX-License-Identifier: MIT
// The page's folder: page.json and the folders of its characters.
#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/character.hpp"

namespace pantin {

struct DetectedPage {
    Page page;
    std::vector<Character> characters; // drawing and mask in memory, in the order of the page's list
    RgbImage picture; // as it was looked at, and its ink, when the workshop keeps intermediate products
    Mask ink;
};

// Step 1 with its files. Nothing is written when the picture is bad or holds no character. In page.json the
// characters are unfinished.
DetectedPage run_detect(const std::filesystem::path& image, const std::filesystem::path& out,
                        Workshop& workshop);

// All steps with their files: the page and its characters, which stay in memory when the workshop keeps
// intermediate products. When no character could be animated the page says why.
DetectedPage run_animate(const std::filesystem::path& image, const std::filesystem::path& out,
                         Workshop& workshop);
// As wanted, and what follows from the kind of input: the characters of AnimatedDrawings are human figures.
Settings settings_for(const std::filesystem::path& image, const Settings& wanted);
// Error(not_animated) names the reasons when the status of no character is "ok".
void require_animated(const std::filesystem::path& image, const Page& page);

void write_page(const std::filesystem::path& out, const Page& page);

} // namespace pantin
