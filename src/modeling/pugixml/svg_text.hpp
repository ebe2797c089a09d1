// SPDX-License-Identifier: MIT
// Elements and attributes of an SVG document as text.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace pantin::svg {

// No function here throws but load().

bool among(std::string_view word, std::initializer_list<std::string_view> words);
// One line without white space around it or doubled.
std::string one_line(std::string_view text);
std::string small(std::string text);
std::string attribute(pugi::xml_node node, const char* name);
// `href`, or the older `xlink:href`.
std::string reference(pugi::xml_node node);
// Without the prefix that some programs write before SVG's own elements.
std::string_view kind_of(pugi::xml_node node);
// All text and CDATA of the node itself.
std::string text_of(pugi::xml_node node);
// "path 'tail'"; "path" without a name.
std::string described(pugi::xml_node node, const std::string& name);
bool is_shape(pugi::xml_node node);

// The document of a file's text: a byte order mark and what stands behind the end are passed over, and
// entities that the document itself declares (Illustrator's) are put in. Error(input) names `file` and the
// line.
void load(pugi::xml_document& document, const std::string& text, const std::string& file);

} // namespace pantin::svg
