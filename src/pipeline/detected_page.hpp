// SPDX-License-Identifier: MIT
// Step 1 (thesis 4.2) with its files: a picture to page.json and a folder for each character.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/animated_page.hpp"

namespace pantin {

// Detection, or the characters that the user gives (overrides.hpp). In the page they are unfinished.
// Error(input, no_character) names the picture; nothing is written.
AnimatedPage detect_characters(const std::filesystem::path& image, Context& context);

// Replaces the results of a former run in `out` by page.json, the overview, drawings and masks. A page.png
// that no former run wrote is the user's and stays; `notice` is told.
void save_detection(const std::filesystem::path& out, const AnimatedPage& detected, const Context& context);

// Error(input) when it is none.
void require_folder(const std::filesystem::path& folder);
// Whether the page.json beside a character's folder says that its mask is the silhouette to the pixel.
bool is_exact_mask(const std::filesystem::path& folder);
// Keeps the entry of the character in the page.json beside its folder; a folder may also stand alone. Without
// warnings those of the entry stay.
void set_result(const std::filesystem::path& folder, const std::string& status,
                const std::optional<std::vector<Warning>>& warnings);

} // namespace pantin
