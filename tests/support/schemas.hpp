// SPDX-License-Identifier: MIT
// JSON against the schemas in docs/schemas.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace pantin::test {

// "" when the value is as docs/schemas/<schema>.schema.json says, else where it is not, and why.
std::string schema_violation(const std::string& schema, const nlohmann::json& value);

// The schema itself.
nlohmann::json read_schema(const std::string& schema);

} // namespace pantin::test
