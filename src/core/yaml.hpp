// SPDX-License-Identifier: MIT
// YAML as JSON values, so that one kind of reader serves both.
#pragma once

#include <string>

#include "core/json.hpp"

namespace pantin {

// Whether this program was built with yaml-cpp.
bool yaml_available();

// The text of a file: maps, lists, numbers, true and false, null; every other scalar and whatever stands in
// quotes is a string. Error(input) names `source` when the text is not YAML, has a map with keys that are no
// scalars, or when this program was built without yaml-cpp.
Json parse_yaml(const std::string& text, const std::string& source);

} // namespace pantin
