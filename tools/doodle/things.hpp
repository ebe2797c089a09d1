// SPDX-License-Identifier: MIT
// What children draw around their characters: sun, house, tree, words. None of it is labelled.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "doodle/figure.hpp"

namespace pantin::doodle {

// The natural colours of things, as indices into natural_paints() (canvas.hpp).
enum class Crayon { yellow, orange, red, green, blue, brown, grey, pink };

using ThingBuilder = void (*)(Builder&);
using ThingTable = std::vector<std::pair<std::string, ThingBuilder>>;

// The tables of sky.cpp, scenery.cpp, objects.cpp and writing.cpp.
const ThingTable& sky_things();
const ThingTable& scenery_things();
const ThingTable& object_things();
const ThingTable& written_things();

std::vector<std::string> thing_species();
Figure build_thing(Random& random, const std::string& species);

// Parts of a thing: a closed area, an open line. Both return the part's index.
int add_area(Builder& b, Path outline, Crayon crayon, double depth = 0.0);
int add_line(Builder& b, Path line, Crayon crayon, double depth = 0.0);
// Points on the ellipse around `centre` between two angles.
Path arc_of(Point2d centre, double rx, double ry, double from, double to);

} // namespace pantin::doodle
