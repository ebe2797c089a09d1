// SPDX-License-Identifier: MIT
// What `animate` says of each character when it is done.
#pragma once

#include <filesystem>
#include <string>

#include "pantin/page.hpp"

namespace pantin::cli {

// With less confidence the second choice is said, too: below it a third of the choices and more were wrong
// (docs/accuracy.md, "What the confidence means").
inline constexpr double low_confidence = 0.7;

// "out/character-1: ok · humanoid (0.93) · 3 clips · out/character-1/animation.webp"; of a character that was
// refused why, and what to do. `out`: the page's folder. `reference_given`: nothing is to be said of the
// choice.
std::string character_line(const std::filesystem::path& out, const PageCharacter& character,
                           bool reference_given);

} // namespace pantin::cli
