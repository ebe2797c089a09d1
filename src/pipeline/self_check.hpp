// SPDX-License-Identifier: MIT
// The result of the steps, looked at by the program itself (docs/warnings.md).
#pragma once

#include <vector>

#include "pantin/warnings.hpp"
#include "pipeline/character.hpp"

namespace pantin {

// Of a rigged character: the warnings about what the settings show of it.
std::vector<Warning> check_result(const Character& character, Context& context);

} // namespace pantin
