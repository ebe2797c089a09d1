// SPDX-License-Identifier: MIT
// The painted shapes of a drawing, gathered in painting order, and which of them are parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/json.hpp"
#include "modeling/svg_viewport.hpp"
#include "pantin/strokes.hpp"

namespace pantin::svg {

struct GatheredShape {
    std::string element;                                  // "path 'tail'", for messages
    std::string name;                                     // asked for; empty: none
    Label label = Label::background;                      // that a class or a group around it tells
    Json attributes = Json::object();                     // keys of strokes.json
    std::vector<std::vector<Point2d>> outlines;           // of its parts, canvas
    std::vector<std::vector<std::vector<Point2d>>> holes; // of each outline of a filled shape
    bool filled = false;
    bool open = false;                 // an outline was closed
    std::optional<std::string> colour; // "#rrggbb"
    std::vector<std::string> notes;    // behind the part's name
    Painting painting;
};

// The strokes of the shapes. No part: what is outside the page, a ground behind everything, an outline of a
// shape that is already there. Lines about it, and those in `repairs` before them. page: what is seen of the
// canvas, when the drawing says so; origin: of the model, empty: none given. Error(input) names `file`. Own.
Strokes strokes_of(std::vector<GatheredShape> shapes, const std::optional<ViewBox>& page, const Json& origin,
                   std::vector<std::string> repairs, const std::string& file);

} // namespace pantin::svg
