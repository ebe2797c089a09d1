// SPDX-License-Identifier: MIT
// Pairs of end-effectors with their costs to the text of mapping.json, and back (thesis 4.6).
#include "formats/mapping_file.hpp"

#include <algorithm>

#include "formats/json_values.hpp"

namespace pantin {

std::string mapping_to_json(const Mapping& mapping) {
    Json json;
    json["pairs"] = Json::array();
    for (const EndPair& pair : mapping.pairs) {
        Json item;
        item["end"] = pair.end;
        item["reference_end"] = pair.reference_end;
        item["cost"] = pair.cost;
        json["pairs"].push_back(item);
    }
    json["costs"] = Json::array();
    for (const std::vector<double>& row : mapping.costs) json["costs"].push_back(row);
    return to_json_text(json);
}

Mapping mapping_from_json(const std::string& text, const std::string& file, const SkeletonGraph& graph,
                          const ReferenceSkeleton& reference) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    const long vertices = static_cast<long>(graph.vertices.size()),
               nodes = static_cast<long>(reference.nodes.size());
    Mapping mapping;
    for (const JsonReader& item : reader.at("pairs").elements(0, 1000)) {
        EndPair pair;
        pair.end = read_int(item.at("end"), 0, vertices - 1);
        pair.reference_end = read_int(item.at("reference_end"), 0, nodes - 1);
        pair.cost = item.at("cost").number(-huge, huge);
        const auto same_end = [&](const EndPair& other) { return other.end == pair.end; };
        if (std::any_of(mapping.pairs.begin(), mapping.pairs.end(), same_end))
            item.at("end").fail("is mapped twice");
        mapping.pairs.push_back(pair);
    }
    std::sort(mapping.pairs.begin(), mapping.pairs.end(),
              [](const EndPair& a, const EndPair& b) { return a.end < b.end; });
    for (const JsonReader& row : reader.at("costs").elements(0, 10'000)) {
        mapping.costs.emplace_back();
        for (const JsonReader& cost : row.elements(0, 10'000))
            mapping.costs.back().push_back(cost.number(-huge, huge));
    }
    return mapping;
}

} // namespace pantin
