// SPDX-License-Identifier: MIT
// What is drawn, before it is drawn: the parts of a figure in painter's order, in units of its own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "doodle/curve.hpp"
#include "pantin/label.hpp"

namespace pantin::doodle {

enum class PartKind {
    region, // a closed outline: covers what is behind it
    stick,  // a single line that is a part: its region is a few pens thick
    mark,   // ink without a region of its own: an eye, a stripe
};

struct Part {
    PartKind kind = PartKind::region;
    Label label = Label::body;
    Outline outline;
    double depth = 0.0;     // smaller is farther back; equal depths in order of insertion
    double ink_width = 1.0; // relative to the pen
    double thickness = 2.5; // of a stick's region, in pens
    bool solid = false;     // filled with ink
    int owner = -1;         // of a mark: the region on which it is visible; −1: everywhere
    int paint = 0;          // index of the crayon that colours it in
    int within = -1;        // a piece of that region: clipped to it, hides no line
    bool continues = false; // a hand, toes, what it holds: no limb of its own, but more of the one before
};

struct Figure {
    std::string type, species;
    double heading =
        0.0; // the way it faces on the page, as an angle: 0 right, π/2 down (towards us), −π/2 up
    double max_tilt = 0.12; // how far it may be turned
    bool may_mirror = true; // writing may not
    std::vector<Part> parts;
    std::vector<std::pair<int, int>> merged;      // no line between the two: their outline flows
    std::vector<std::pair<int, int>> see_through; // both lines are drawn where the two overlap
};

// What one person does in the whole drawing.
struct Manner {
    double flow = 0.5;         // probability that a limb's outline flows into the body's
    double see_through = 0.05; // probability that a line behind a part is drawn all the same
    double open_feet = 0.1;    // probability that a leg has no line at its end
    double stick_limbs = 0.4;  // probability that limbs are single lines
    double details = 0.6;      // probability of each optional detail
    double symmetry = 0.8;     // how alike left and right are
};
Manner random_manner(Random& random);

// Adds parts to a figure; every function returns the part's index.
class Builder {
public:
    Builder(Random& random, std::string type, std::string species);

    int region(Label label, Path outline, double depth = 0.0);
    int region(Label label, Outline outline, double depth = 0.0);
    int limb(Label label, const Path& midline, const std::vector<double>& radii, double depth,
             RibbonEnds ends = {});
    int stick(Label label, Path line, double depth = 0.0, double thickness = 2.5);
    int continued(int index) { return part(index).continues = true, index; }
    // A piece of a region with a label of its own and no line: the head of an outline drawn in one go.
    int piece(int region, Label label, Path area);
    int mark(int owner, Path line, bool closed = false, double ink_width = 1.0);
    int spot(int owner, Path outline); // a mark filled with ink
    // The line between a and b is left out with the drawing's probability of flowing outlines.
    void attach(int a, int b);
    void merge(int a, int b) { figure.merged.push_back({a, b}); }
    Part& part(int index) { return figure.parts[static_cast<std::size_t>(index)]; }

    double jitter(double value, double share) { return value * random.uniform(1.0 - share, 1.0 + share); }

    Random& random;
    Manner manner;
    Figure figure;
};

// A species and what draws it, which finds the name in figure.species.
struct Sketch {
    const char* name;
    void (*draw)(Builder&);
};

// The lists and choices of species follow from tables whose rows have a `name`.
template <class Row> std::vector<std::string> names_of(const std::vector<Row>& table) {
    std::vector<std::string> names;
    for (const Row& row : table) names.push_back(row.name);
    return names;
}
// The first row where there is none of that name.
template <class Row> const Row& row_of(const std::vector<Row>& table, const std::string& name) {
    for (const Row& row : table)
        if (name == row.name) return row;
    return table.front();
}

// Figures of one type; `species` is one of species_of(type).
Figure build_humanoid(Random& random, const std::string& species);
Figure build_quadruped(Random& random, const std::string& species);
Figure build_flyer(Random& random, const std::string& species);
// Not characters: "head", "blob", "scribble".
Figure build_decoy(Random& random, const std::string& type);

std::vector<std::string> humanoid_species();
std::vector<std::string> quadruped_species();
std::vector<std::string> flyer_species();

// --- details shared by the builders (details.cpp)
// -----------------------------------------------------------

struct Frame { // a place on the figure: centre, half extents, angle
    Point2d centre;
    double rx = 1, ry = 1, angle = 0;
    Point2d at(double u, double v) const { return centre + rotated({u * rx, v * ry}, angle); }
};
void add_frontal_face(Builder& b, int head, Frame frame);
void add_eye(Builder& b, int head, Point2d centre, double size);
void add_hair(Builder& b, int head, Frame frame);
void add_hat(Builder& b, int head, Frame frame);
// Stripes, spots or hatching inside a region.
void add_pattern(Builder& b, int region, Frame frame, const std::string& kind = "");
// A round, spiral, zigzag or bushy line for tails.
Path curl(Point2d start, double angle, double size, double turns, double tightness);
// A cloud-like outline around an ellipse (sheep).
Path fluffy(Random& random, Frame frame, int bumps);

} // namespace pantin::doodle
