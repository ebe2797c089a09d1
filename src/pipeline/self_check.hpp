// SPDX-License-Identifier: MIT
// The result of the steps, looked at by the program itself (docs/warnings.md).
#pragma once

#include <vector>

#include "pantin/warnings.hpp"
#include "pipeline/clip_films.hpp"

namespace pantin {

// Of a rigged character: the warnings about it and the films that the settings show of it.
std::vector<Warning> check_result(const Character& character, const std::vector<ClipFilm>& films,
                                  Context& context);

} // namespace pantin
