// SPDX-License-Identifier: MIT
// A species of thing in, its figure out: nothing of it has a label.
#include "doodle/things.hpp"

#include "core/math.hpp"
#include "pantin/error.hpp"

namespace pantin::doodle {
namespace {

std::vector<const ThingTable*> tables() {
    return {&sky_things(), &scenery_things(), &object_things(), &written_things()};
}

} // namespace

std::vector<std::string> thing_species() {
    std::vector<std::string> names;
    for (const ThingTable* table : tables())
        for (const auto& [name, build] : *table) names.push_back(name);
    return names;
}

Figure build_thing(Random& random, const std::string& species) {
    Builder b(random, "thing", species);
    b.figure.heading = 0.5 * math::pi;
    b.figure.max_tilt = 0.06;
    for (const ThingTable* table : tables())
        for (const auto& [name, build] : *table)
            if (name == species) build(b);
    return std::move(b.figure);
}

int add_area(Builder& b, Path outline, Crayon crayon, double depth) {
    const int index = b.region(Label::background, std::move(outline), depth);
    b.part(index).paint = static_cast<int>(crayon);
    return index;
}

int add_line(Builder& b, Path line, Crayon crayon, double depth) {
    const int index = b.stick(Label::background, std::move(line), depth, 1.0);
    b.part(index).paint = static_cast<int>(crayon);
    return index;
}

Path arc_of(Point2d centre, double rx, double ry, double from, double to) {
    constexpr int steps = 20;
    Path out;
    for (int i = 0; i <= steps; ++i) {
        const Point2d d = direction(from + (to - from) * i / steps);
        out.push_back({centre.x + rx * d.x, centre.y + ry * d.y});
    }
    return out;
}

} // namespace pantin::doodle
