// SPDX-License-Identifier: MIT
// What the user has to know of a recorded motion on a character.
#pragma once

#include <filesystem>

#include "pipeline/character.hpp"

namespace pantin {

// A line to `notice` when the character does not follow the recorded motion of the settings, or follows a
// part of it. The character has its reference. `folder` names it.
void notice_motion(const std::filesystem::path& folder, const Character& character, Context& context);

} // namespace pantin
