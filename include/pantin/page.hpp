// SPDX-License-Identifier: MIT
// A page and the characters that were found on it, as page.json lists them (docs/formats.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pantin/detection.hpp"
#include "pantin/sheet.hpp"
#include "pantin/warnings.hpp"

namespace pantin {

// A reference skeleton and how sure it is that the character moves like it, 0 to 1.
struct TypeGuess {
    std::string type;
    double confidence = 0;
};

struct PageCharacter {
    std::string folder;          // name below the page's folder, "character-1"
    Box box;                     // page pixels
    double scale = 1, score = 0; // working pixels per page pixel; detector's score, 0 to 1
    std::string status = "ok";   // or "step: reason", or unfinished_status
    bool exact_mask = false;     // mask.png is the silhouette to the pixel: the user gave it
    std::optional<TypeGuess> found{},
        second{};                    // what it moves like, and the best other one; of identification
    std::vector<Warning> warnings{}; // of the last `rig` or `render`
};
// Of a character whose page `animate` is still at work on, or was when it was cut off.
inline constexpr const char* unfinished_status = "unfinished";

struct Page {
    std::string source;                    // file name of the picture
    std::optional<SheetCorners> sheet;     // in the picture, if it shows more than the sheet; first flattened
    int rotate = 0;                        // degrees by which it was then turned clockwise
    int width = 0, height = 0;             // after that, pixels
    std::string detector = "contour";      // or "mask-rcnn", or "given"
    std::vector<PageCharacter> characters; // left to right, then top to bottom
    // What was wrong with the given files and could be helped: one line each that names the file.
    std::vector<std::string> remarks{};
};

// Reads a page.json. Error(input) names the file, the place and the fact. Own format.
Page read_page(const std::filesystem::path& file);

} // namespace pantin
