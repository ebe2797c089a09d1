// SPDX-License-Identifier: MIT
// The network's answers and the areas of the parts to the text of segmentation.json (thesis 4.3).
#include "formats/segmentation_file.hpp"

#include "formats/json_values.hpp"
#include "image/label_map.hpp"

namespace pantin {

std::string segmentation_to_json(const Segmentation& segmentation) {
    Json json;
    json["expert"] = segmentation.expert;
    json["router"] = Json::object();
    for (const auto& [expert, probability] : segmentation.router) json["router"][expert] = probability;
    json["sureness"] = segmentation.confidence;
    json["stroke_ratio"] = segmentation.stroke_ratio;
    json["pose"] = Json::object();
    for (std::size_t i = 0; i < pose_names.size(); ++i) json["pose"][pose_names[i]] = segmentation.pose[i];
    if (segmentation.type) {
        json["type"] = Json::object();
        for (std::size_t i = 0; i < type_names.size(); ++i)
            json["type"][type_names[i]] = (*segmentation.type)[i];
    }
    const auto areas = part_areas(segmentation.labels);
    json["areas"] = Json::object();
    for (std::size_t i = 0; i < areas.size(); ++i) json["areas"][std::string(label_names[i])] = areas[i];
    return to_json_text(json);
}

TypeProbabilities type_probabilities_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    if (!reader.has("type")) return {};
    const JsonReader types = reader.at("type");
    TypeProbabilities read(std::in_place);
    for (std::size_t i = 0; i < type_names.size(); ++i) (*read)[i] = types.at(type_names[i]).number(0, 1);
    return read;
}

} // namespace pantin
