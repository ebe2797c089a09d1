// SPDX-License-Identifier: MIT
// Borders of the silhouette to the text of contour.json (thesis 4.4).
#include "formats/contour_file.hpp"

#include "formats/json_values.hpp"

namespace pantin {

std::string contour_to_json(const std::vector<Border>& contour) {
    Json borders = Json::array();
    for (const Border& border : contour) {
        Json item;
        item["outer"] = border.outer;
        item["parent"] = border.parent;
        item["points"] = point_list(border.points);
        borders.push_back(item);
    }
    Json json;
    json["borders"] = borders;
    return to_json_text(json);
}

} // namespace pantin
