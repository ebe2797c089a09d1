// SPDX-License-Identifier: MIT
// A shape element as outlines of parts and as painted areas (SVG 2, chapters 9, 10 and 13).
#pragma once

#include <string>
#include <vector>

#include <pugixml.hpp>

#include "modeling/pugixml/svg_geometry.hpp"
#include "modeling/pugixml/svg_paint.hpp"
#include "modeling/pugixml/svg_parts.hpp"

namespace pantin::svg {

// Where and how a shape is drawn.
struct Setting {
    const Affine& transform; // to the canvas
    const Viewport& viewport;
    const Look& look;
    Paint fill, stroke;
    std::string where; // file and element, for messages
};
struct ShapeOutlines {
    bool empty = false; // there is nothing to draw
    // Lines without a width of their own: marks, and parts only of a drawing that has nothing else.
    std::vector<std::vector<Point2d>> thin;
};
// Adds outlines, colour, notes and painting to `shape`. Canvas units. Error(input): `where` and the fact.
// Own, by SVG 2.
ShapeOutlines add_outlines(GatheredShape& shape, pugi::xml_node node, const Setting& setting);
// Adds the keys of strokes.json that the element's data attributes stand for. Error(input) as above.
void add_attributes(pugi::xml_node node, const std::string& where, Json& part);

} // namespace pantin::svg
