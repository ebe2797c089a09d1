// SPDX-License-Identifier: MIT
// Commands in messages.
#pragma once

#include <string>

namespace pantin {

// The text as a POSIX shell takes it for one word: as it is, or in single quotes. No error.
std::string shell_word(const std::string& text);

} // namespace pantin
