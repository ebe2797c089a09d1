// SPDX-License-Identifier: MIT
// What several of the JSON files have in common: limits, integers and lists of pixels.
#pragma once

#include <vector>

#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "pantin/point.hpp"

namespace pantin {

constexpr long max_side = 16384; // of a page, pixels (docs/formats.md, "Limits")
constexpr double huge = 1e15;    // beyond any number that a run writes

inline int read_int(const JsonReader& reader, long low, long high) {
    return static_cast<int>(reader.integer(low, high));
}

// [[x, y], …].
inline Json point_list(const std::vector<Point2i>& points) {
    Json list = Json::array();
    for (const Point2i p : points) list.push_back(Json::array({p.x, p.y}));
    return list;
}

// The same back; Error(input) for a pixel outside width × height.
inline std::vector<Point2i> read_points(const JsonReader& reader, int width, int height) {
    std::vector<Point2i> points;
    for (const JsonReader& pair : reader.elements()) {
        const std::vector<JsonReader> xy = pair.elements(2, 2);
        points.push_back(
            {static_cast<int>(xy[0].integer(0, width - 1)), static_cast<int>(xy[1].integer(0, height - 1))});
    }
    return points;
}

} // namespace pantin
