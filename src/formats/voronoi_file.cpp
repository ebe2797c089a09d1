// SPDX-License-Identifier: MIT
// Edges of the Voronoi diagram with their residuals to the text of voronoi.json (thesis 3.4, 4.4).
#include "formats/voronoi_file.hpp"

#include <cmath>

#include "formats/json_values.hpp"

namespace pantin {

std::string voronoi_to_json(const std::vector<VoronoiEdge>& edges, const std::vector<double>& residuals) {
    Json json;
    json["edges"] = Json::array();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        Json item;
        item["from"] = Json::array({edges[i].from.x, edges[i].from.y});
        item["to"] = Json::array({edges[i].to.x, edges[i].to.y});
        item["sites"] = Json::array({edges[i].site_a, edges[i].site_b});
        item["residual"] =
            std::isfinite(residuals[i]) ? Json(residuals[i]) : Json(nullptr); // between two borders
        json["edges"].push_back(item);
    }
    return to_json_text(json);
}

} // namespace pantin
