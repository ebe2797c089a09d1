// SPDX-License-Identifier: MIT
// HTML text: escapes, data inside the page, templates with places to fill.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "core/json.hpp"
#include "pantin/grid.hpp"

namespace pantin {

std::string escaped(std::string_view text); // for text and attribute values
// Rounded to so many decimals, without trailing zeros.
std::string decimal(double value, int decimals = 1);
std::string percent(double share, int decimals = 0);

std::string data_uri(std::string_view type, std::span<const unsigned char> bytes); // RFC 2397, base64
std::string picture_uri(const RgbImage& image);
std::string picture_uri(const RgbaImage& image);
std::string picture_uri(const GreyImage& image);

// JSON that may stand in a <script> element.
std::string script_json(const Json& value);

// A file of src/explain/assets, compiled in. Error(internal) when there is none.
std::string_view asset(const std::string& name);

// What a template's places {{name}} are filled with. A place without a value is Error(internal), so that no
// page shows one.
using Values = std::map<std::string, std::string>;
std::string filled(std::string_view text, const Values& values);

} // namespace pantin
