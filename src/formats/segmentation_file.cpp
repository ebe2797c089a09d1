// SPDX-License-Identifier: MIT
// The network's answers and the areas of the parts to the text of segmentation.json (thesis 4.3).
#include "formats/segmentation_file.hpp"

#include "formats/json_values.hpp"

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
    std::array<long, label_count> areas{};
    for (const std::uint8_t label : segmentation.labels)
        if (label < label_count) ++areas[label];
    json["areas"] = Json::object();
    for (std::size_t i = 0; i < areas.size(); ++i) json["areas"][std::string(label_names[i])] = areas[i];
    return to_json_text(json);
}

} // namespace pantin
