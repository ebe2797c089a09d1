// SPDX-License-Identifier: MIT
// What an element is painted with: inherited properties, colours, gradients, visibility (SVG 2, chapters 6,
// 13 and 14).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "modeling/pugixml/svg_geometry.hpp"
#include "modeling/pugixml/svg_style.hpp"
#include "modeling/svg_outlines.hpp"
#include "modeling/thick_line.hpp"
#include "pantin/grid.hpp"

namespace pantin::svg {

// Fill or stroke of a shape.
struct Paint {
    std::optional<Rgb8> colour; // nothing: painted with something that has no plain colour
    double opacity = 0;         // 0: not painted
    bool given = false;         // by the drawing; else SVG's black fill
    std::string odd;            // what could not be read as a colour
    bool seen() const;
};

// Elements by their id, the first of each.
using Identified = std::map<std::string, pugi::xml_node>;

// Properties that hold for an element. Own.
class Look {
public:
    // Of an element inside one of this look, whose own declarations are given.
    Look inside(const Style& own) const;
    bool displayed() const { return displayed_; }
    bool visible() const;
    Paint fill(const StyleSheets& sheets, const Identified& identified) const;
    Paint stroke(const StyleSheets& sheets, const Identified& identified) const;
    FillRule fill_rule() const;
    // Error(input): a width that is no length; `where` names the element.
    LineStyle line(const Viewport& viewport, const std::string& where) const;
    bool width_given() const;
    bool scales_lines() const { return value("vector-effect") != "non-scaling-stroke"; }
    bool clipped() const { return clipped_; }

private:
    std::string value(const std::string& name, const std::string& missing = "") const;
    Paint paint(const std::string& property, const std::string& missing, const StyleSheets& sheets,
                const Identified& identified) const;

    Style values_;       // inherited ones, and those of the element itself
    double opacity_ = 1; // of the element and all groups around it
    bool displayed_ = true, clipped_ = false;
};

} // namespace pantin::svg
