// SPDX-License-Identifier: MIT
// Names of parts and joints as words.
#pragma once

#include <string>
#include <vector>

namespace pantin {

// Runs of letters in small letters, also split before the capital of "leftArm" and "LEFTArm"; digits and
// all else divide words. No error. Own.
std::vector<std::string> words_of(const std::string& name);

} // namespace pantin
