// SPDX-License-Identifier: MIT
// Shape elements as subpaths (SVG 2, chapters 9 and 10).
#pragma once

#include <string>
#include <vector>

#include <pugixml.hpp>

#include "modeling/svg_path.hpp"

namespace pantin::svg {

// What percentages are of (SVG 2, 8.9), user units.
struct Viewport {
    double width = 300, height = 150; // of a drawing that says nothing (CSS 2.1, 10.3.2)
    double diagonal() const;          // over √2
};

// A length; 0 or `missing` when it is not there. whole: user units that 100 % are. Error(input): `where`, the
// attribute, the fact.
double length_of(pugi::xml_node node, const char* name, double whole, const std::string& where,
                 double missing = 0);
// The same, and not negative.
double extent_of(pugi::xml_node node, const char* name, double whole, const std::string& where,
                 double missing = 0);
// The subpaths of a path, polygon, polyline, rect, circle, ellipse or line, moved by the transform. Empty
// when it has no extent. Error(input): `where` and the fact.
std::vector<Subpath> subpaths_of(pugi::xml_node node, const Affine& transform, const Viewport& viewport,
                                 const std::string& where);

} // namespace pantin::svg
