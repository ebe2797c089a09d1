// SPDX-License-Identifier: MIT
// From a figure to ink on white and its label map.
#pragma once

#include <array>
#include <optional>

#include "doodle/doodle.hpp"
#include "doodle/figure.hpp"
#include "doodle/raster.hpp"
#include "pantin/grid.hpp"

namespace pantin::doodle {

using Colour = std::array<float, 3>; // 0 … 255

enum class Filling { none, flat, hatched, wash };

// One person's pen and way of drawing, in pixels where not said otherwise.
struct Hand {
    double pen = 3.0;
    Colour ink{20, 20, 20};
    double opacity = 1.0;
    double grain = 0.0;     // 0 … 1: how much the paper's tooth shows through
    double pressure = 0.1;  // relative variation of the width
    double taper = 0.0;     // how thin the ends get, 0 … 1
    double misplace = 1.0;  // how far parts are from where they belong
    double closure = 0.02;  // relative overlap or gap where a closed outline ends
    double bulge = 0.02;    // slow deviation of outlines, relative to a part's size
    double wobble = 0.6;    // slow deviation of single strokes
    double tremor = 0.2;    // fast deviation
    double corners = 0.0;   // tolerance of the polyline that replaces curves; 0: smooth
    double overshoot = 2.0; // how far ends run over or stop short
    double gap = 0.1;       // probability that a stroke is interrupted
    double again = 0.05;    // probability that a stroke is drawn twice
    double open = 0.0;      // probability that a stroke is several that do not meet
    int strokes = 1;        // how often it is drawn again then
    double dash = 0.0;      // length of dashes; 0: none
    double hatch = 1.0;     // distance of hatches, relative to the usual one
    bool solid = false;     // areas are filled evenly
    Filling filling = Filling::none;
    std::vector<Colour> paints;       // per Part::paint
    bool coloured_lines = false;      // lines in the paint of their part
    bool fill_all = false;            // every part is coloured in
    bool outlines = true;             // closed areas have a line around them
    Colour ground{255, 255, 255};     // what is drawn on
    std::optional<Colour> second_ink; // of marks: faces, patterns
};
Hand random_hand(Random& random, const DoodleOptions& options);
// Another manner of drawing now and then (manners.cpp).
void vary_hand(Hand& hand, Random& random, const DoodleOptions& options);
// The hand as it draws things: with crayons of their natural colours (things.hpp), one for each.
Hand natural_hand(const Hand& hand, Random& random);

struct Layer {
    Grid<Colour> ink; // on the hand's ground
    LabelMap labels;
    int limbs = 0; // that are seen: arms, legs, fins, without hands and feet of their own
};

// Scales, mirrors, tilts and moves the figure into the given area; returns the way it faces then.
std::string place_figure(Figure& figure, Random& random, Box area, const DoodleOptions& options);
// Draws a figure whose points are pixels.
Layer draw_figure(const Figure& figure, const Hand& hand, Random& random, int width, int height);

// Makes the silhouette one 8-connected piece without holes, every pixel with a part (truth.cpp).
void complete_silhouette(LabelMap& labels, double pen);
Box label_box(const LabelMap& labels);

// Ink strokes (stroke.cpp). Draws the open line with the hand's habits; gives `label` to pixels of ink that
// have none.
void ink_line(Layer& layer, const Path& line, const Hand& hand, const Colour& colour, double width,
              Random& random, std::uint8_t label);
void fill_ink(Layer& layer, const Path& outline, const Hand& hand, const Colour& colour);
// Colours the pixels of `where` in (part of `area`).
void colour_in(Layer& layer, const Grid<std::uint8_t>& where, const Box& area, const Hand& hand,
               const Colour& colour, Random& random);

// Value noise in [0, 1) that depends on the pixel and the seed only.
double pixel_noise(int x, int y, std::uint64_t seed);

enum class Finish {
    screen, // white, as a drawing program leaves it
    paper,  // tinted, perhaps ruled
    photo,  // paper under a camera
};
Finish random_finish(Random& random, const DoodleOptions& options);
// Multiplies the ink onto a paper (paper.cpp).
RgbImage on_paper(const Grid<Colour>& ink, Random& random, Finish finish);
// A view (0 … 255) through a camera: uneven light, softness, noise.
RgbImage under_camera(Grid<Colour> view, Random& random);

} // namespace pantin::doodle
