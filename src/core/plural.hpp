// SPDX-License-Identifier: MIT
// Numbers of things in messages.
#pragma once

#include <string>

namespace pantin {

// "1 clip", "3 clips".
inline std::string count_of(long number, const std::string& singular, const std::string& plural = "") {
    return std::to_string(number) + " " + (number == 1 ? singular : plural.empty() ? singular + "s" : plural);
}

} // namespace pantin
