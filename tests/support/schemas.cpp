// SPDX-License-Identifier: MIT
// The only file with valijson, which takes long to compile.
#include "support/schemas.hpp"

#include <map>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "support/folders.hpp"

namespace pantin::test {
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

const valijson::Schema& parsed(const std::string& name) {
    static std::map<std::string, valijson::Schema> known;
    const auto [found, is_new] = known.try_emplace(name);
    if (is_new) {
        const nlohmann::json text = read_schema(name);
        valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
        parser.populateSchema(Adapter(text), found->second);
    }
    return found->second;
}

} // namespace

nlohmann::json read_schema(const std::string& schema) {
    return nlohmann::json::parse(read("docs/schemas/" + schema + ".schema.json"));
}

std::string schema_violation(const std::string& schema, const nlohmann::json& value) {
    valijson::ValidationResults results;
    if (valijson::Validator().validate(parsed(schema), Adapter(value), &results)) return "";
    valijson::ValidationResults::Error error;
    std::string text = schema + ": no further reason";
    if (results.popError(error)) {
        text = schema + ": ";
        for (const std::string& place : error.context) text += place;
        text += ": " + error.description;
    }
    return text;
}

} // namespace pantin::test
