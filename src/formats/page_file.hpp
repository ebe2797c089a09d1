// SPDX-License-Identifier: MIT
// page.json: the page and its characters (docs/formats.md).
// Every double survives the way there and back to the bit. Readers throw Error(input) that names `file`, the
// place and the fact.
#pragma once

#include <string>

#include "pantin/page.hpp"

namespace pantin {

std::string page_to_json(const Page& page);
Page page_from_json(const std::string& text, const std::string& file);

// The file in the page's folder `out`.
void write_page(const std::filesystem::path& out, const Page& page);

} // namespace pantin
