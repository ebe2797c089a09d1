// SPDX-License-Identifier: MIT
// YAML (1.2, as yaml-cpp reads it) to JSON values.
#include "core/json.hpp"
#include "core/yaml.hpp"

#include <yaml-cpp/yaml.h>

#include "pantin/error.hpp"

namespace pantin {

namespace {

// An alias may stand for much, so a small text can be a huge value.
constexpr int deepest = 100, most_nodes = 1'000'000;

// `nodes` counts those so far.
Json to_json(const YAML::Node& node, int depth, int& nodes) {
    if (depth > deepest || ++nodes > most_nodes) throw YAML::Exception(node.Mark(), "too deep or too large");
    if (node.IsScalar()) return node.Scalar();
    if (node.IsSequence()) {
        Json list = Json::array();
        for (const YAML::Node& element : node) list.push_back(to_json(element, depth + 1, nodes));
        return list;
    }
    if (!node.IsMap()) return nullptr;
    Json map = Json::object();
    for (const auto& entry : node) {
        const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
        if (!key.empty() && !map.contains(key)) map[key] = to_json(entry.second, depth + 1, nodes);
    }
    return map;
}

} // namespace

bool yaml_available() { return true; }

Json parse_yaml(const std::string& text, const std::string& source) {
    try {
        int nodes = 0;
        return to_json(YAML::Load(text), 0, nodes);
    } catch (const YAML::Exception& error) {
        throw Error(ErrorKind::input, source + ": is not valid YAML: " + error.msg);
    }
}

} // namespace pantin
