// SPDX-License-Identifier: MIT
// Calls that add parts in, a figure in painter's order out.
#include "doodle/figure.hpp"

#include <algorithm>

namespace pantin::doodle {

Manner random_manner(Random& random) {
    Manner manner;
    manner.flow = random.pick(std::vector<double>{0.0, 0.1, 0.5, 0.9, 1.0});
    manner.see_through = random.chance(0.12) ? random.uniform(0.2, 0.8) : 0.0;
    manner.open_feet = random.chance(0.3) ? random.uniform(0.3, 1.0) : 0.0;
    manner.stick_limbs = random.chance(0.5) ? 0.0 : random.uniform(0.2, 1.0);
    manner.details = random.chance(0.4) ? 0.08 : random.uniform(0.3, 0.9);
    manner.symmetry = random.uniform(0.3, 1.0);
    return manner;
}

Builder::Builder(Random& r, std::string type, std::string species) : random(r), manner(random_manner(r)) {
    figure.type = std::move(type);
    figure.species = std::move(species);
}

int Builder::region(Label label, Path outline, double depth) {
    return region(label, Outline{std::move(outline), {}, true}, depth);
}

int Builder::region(Label label, Outline outline, double depth) {
    Part part;
    part.label = label;
    part.outline = std::move(outline);
    part.outline.undrawn.resize(part.outline.points.size(), 0);
    part.depth = depth;
    part.paint = static_cast<int>(label);
    figure.parts.push_back(std::move(part));
    return static_cast<int>(figure.parts.size()) - 1;
}

int Builder::limb(Label label, const Path& midline, const std::vector<double>& radii, double depth,
                  RibbonEnds ends) {
    return region(label, ribbon(midline, radii, ends), depth);
}

int Builder::stick(Label label, Path line, double depth, double thickness) {
    const int index = region(label, Outline{std::move(line), {}, false}, depth);
    part(index).kind = PartKind::stick;
    part(index).thickness = thickness;
    return index;
}

int Builder::piece(int owner, Label label, Path area) {
    const int index = region(label, std::move(area), part(owner).depth);
    Part& piece = part(index);
    piece.within = owner, piece.paint = part(owner).paint;
    std::fill(piece.outline.undrawn.begin(), piece.outline.undrawn.end(), 1);
    merge(index, owner); // marks of one are seen on the other
    return index;
}

int Builder::mark(int owner, Path line, bool closed, double ink_width) {
    const Label label = owner >= 0 ? part(owner).label : Label::background;
    const int index = region(label, Outline{std::move(line), {}, closed}, 1000.0);
    part(index).kind = PartKind::mark;
    part(index).owner = owner;
    part(index).ink_width = ink_width;
    return index;
}

int Builder::spot(int owner, Path outline) {
    const int index = mark(owner, std::move(outline), true);
    part(index).solid = true;
    return index;
}

void Builder::attach(int a, int b) {
    if (random.chance(manner.flow))
        figure.merged.push_back({a, b});
    else if (random.chance(manner.see_through))
        figure.see_through.push_back({a, b});
}

} // namespace pantin::doodle
