// SPDX-License-Identifier: MIT
// YAML as JSON values, so that one kind of reader serves both.
#pragma once

#include <string>

#include "core/json.hpp"

namespace pantin {

// Whether this program was built with yaml-cpp.
bool yaml_available();

// The text of a file: maps, lists and null; every other scalar is a string as it stands in the file, because
// whether 012 or no is a number or a word is for its reader to say. Of a key given twice the first counts;
// keys that are no scalars are left out. Error(input) names `source` when the text is not YAML or stands for
// too much, or when this program was built without yaml-cpp.
Json parse_yaml(const std::string& text, const std::string& source);

} // namespace pantin
