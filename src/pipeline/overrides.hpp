// SPDX-License-Identifier: MIT
// What the user gives instead of a step's result.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pantin/detection.hpp"
#include "pantin/settings.hpp"

namespace pantin {

struct GivenCharacter {
    DetectedCharacter detected;
    std::optional<LabelMap> labels; // of the mask's size
    // What was wrong with the files and could be helped, one line each that names the file.
    std::vector<std::string> remarks;
};

// The picture of a page: the file itself, or the texture of an AnimatedDrawings folder.
std::filesystem::path picture_of(const std::filesystem::path& image);

// Whether the user gives a character: a mask, labels, or an AnimatedDrawings folder.
bool has_given_character(const std::filesystem::path& image, const Settings& settings);
// The character of the given mask or labels, or of an AnimatedDrawings folder; none when there is neither. A
// folder whose joints cannot be used, or do not say what its parts are, gives no labels, and a remark.
// `page` is turned already. Error(input) names the file that does not fit.
std::optional<GivenCharacter> given_character(const RgbImage& page, const PageInk& ink,
                                              const std::filesystem::path& image, const Settings& settings,
                                              const DetectionOptions& options);

} // namespace pantin
