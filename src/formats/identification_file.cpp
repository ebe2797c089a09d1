// SPDX-License-Identifier: MIT
// Candidates and decision to the text of identification.json, and back (thesis 4.5).
#include "formats/identification_file.hpp"

#include <algorithm>

#include "formats/json_values.hpp"

namespace pantin {

namespace {

Json candidate_to_json(const Candidate& candidate) {
    Json evidence = Json::object();
    for (const auto& [name, value] : candidate.evidence) evidence[name] = value;
    Json pairs = Json::array();
    for (const auto& [vertex, node] : candidate.pairs) pairs.push_back(Json::array({vertex, node}));
    Json json;
    json["reference"] = candidate.reference;
    json["mirrored"] = candidate.mirrored;
    json["distance"] = candidate.distance;
    json["score"] = candidate.score;
    json["evidence"] = evidence;
    json["optimal"] = candidate.optimal;
    json["pairs"] = pairs;
    return json;
}

Candidate read_candidate(const JsonReader& reader, const SkeletonGraph& graph,
                         const std::vector<ReferenceSkeleton>& references) {
    Candidate candidate;
    candidate.reference = reader.at("reference").text();
    const auto reference =
        std::find_if(references.begin(), references.end(),
                     [&](const ReferenceSkeleton& r) { return r.name == candidate.reference; });
    if (reference == references.end())
        reader.at("reference").fail("there is no reference '" + candidate.reference + "'");
    candidate.mirrored = reader.at("mirrored").boolean();
    candidate.distance = reader.at("distance").number(-huge, huge);
    candidate.score = reader.at("score").number(-huge, huge);
    for (const auto& [name, value] : reader.at("evidence").entries())
        candidate.evidence.emplace_back(name, value.number(-huge, huge));
    candidate.optimal = reader.at("optimal").boolean();
    const long vertices = static_cast<long>(graph.vertices.size()),
               nodes = static_cast<long>(reference->nodes.size());
    for (const JsonReader& pair : reader.at("pairs").elements()) {
        const std::vector<JsonReader> both = pair.elements(2, 2);
        candidate.pairs.emplace_back(read_int(both[0], 0, vertices - 1), read_int(both[1], 0, nodes - 1));
    }
    return candidate;
}

} // namespace

std::string identification_to_json(const Identification& identification) {
    Json json;
    json["reference"] = identification.reference;
    json["type"] = identification.type;
    json["confidence"] = identification.confidence;
    json["candidates"] = Json::array();
    for (const Candidate& candidate : identification.candidates)
        json["candidates"].push_back(candidate_to_json(candidate));
    return to_json_text(json);
}

Identification identification_from_json(const std::string& text, const std::string& file,
                                        const SkeletonGraph& graph,
                                        const std::vector<ReferenceSkeleton>& references) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    Identification identification;
    identification.reference = reader.at("reference").text();
    if (reader.has("type")) identification.type = reader.at("type").text();
    identification.confidence = reader.at("confidence").number(0, 1);
    for (const JsonReader& item : reader.at("candidates").elements(1, 1000))
        identification.candidates.push_back(read_candidate(item, graph, references));
    // The reference may be changed by hand to another candidate.
    const auto chosen = [&](const Candidate& c) { return c.reference == identification.reference; };
    if (std::none_of(identification.candidates.begin(), identification.candidates.end(), chosen))
        reader.at("reference").fail("is none of the candidates");
    return identification;
}

std::string reference_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    return JsonReader(json, file).at("reference").text();
}

} // namespace pantin
