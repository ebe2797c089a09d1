// SPDX-License-Identifier: MIT
// What the reports share.
#pragma once

#include <cstdio>
#include <string>

#include "pantin/evaluation.hpp"

namespace pantin {

// As printf does; at most 511 bytes.
std::string printed(const char* format, auto... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

int unlabelled_pages(const Evaluation& evaluation);
int labelled_characters(const Evaluation& evaluation);

} // namespace pantin
