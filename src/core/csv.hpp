// SPDX-License-Identifier: MIT
// Tables as comma-separated values (RFC 4180), for spreadsheets and data frames.
#pragma once

#include <string>
#include <vector>

namespace pantin {

// One record with its line feed. A field with a comma, a quote or a line break is quoted. No error.
std::string csv_line(const std::vector<std::string>& fields);

} // namespace pantin
