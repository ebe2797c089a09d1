// SPDX-License-Identifier: MIT
// JSON in our files: keys in the order of insertion, two-space indent, shortest round-trip decimals.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace pantin {

// Text of a value. An array that holds no object and no array is written in one line, so that a list of
// points stays readable; everything else has one element a line. Ends with a line feed.
std::string to_json_text(const nlohmann::ordered_json& value);
// The same without any white space (for glTF).
std::string to_compact_json_text(const nlohmann::ordered_json& value);

// Parses the text of a file. Error(input) names `source` and the place.
nlohmann::ordered_json parse_json(const std::string& text, const std::string& source);

} // namespace pantin
