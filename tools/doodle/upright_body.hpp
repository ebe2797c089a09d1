// SPDX-License-Identifier: MIT
// An upright body in parts: head, trunk, arms, legs, ears, tail. Units: about 100 from head to foot, x = 0
// the middle, y down from the head's.
#pragma once

#include "doodle/figure.hpp"

namespace pantin::doodle::upright {

enum class Limbs { lines, ribbons, loops, open };
enum class Trunk { line, oval, box, pear, dress, flowing };

struct Body {
    double hx, hy;         // half axes of the head
    double top, length, w; // the trunk from `top` down, half its width
    double arm, leg, thick;
    Trunk trunk;
    Limbs arms, legs;
    double middle() const { return top + 0.5 * length; }
    double bottom() const { return top + length; }
};

Body random_body(Builder& b);
int add_head(Builder& b, const Body& s, bool face);
// No trunk of its own width where it is a line: sets s.w to 0.
int add_trunk(Builder& b, Body& s, int head);
// One limb of any kind through its joints, from the trunk outwards.
int add_limb(Builder& b, int trunk, const Path& line, double thick, Limbs kind, double depth, bool joined);
// Straight down is angle 0; outwards on side −1 or 1.
Point2d outwards(double angle, int side);
// Returns the right hand.
Point2d add_arms(Builder& b, const Body& s, int trunk);
void add_legs(Builder& b, const Body& s, int trunk);
// A thing in the hand: a small one is labelled with the limb, a balloon, a flag or an umbrella is paper.
void add_held(Builder& b, Point2d hand);
void add_side_ears(Builder& b, const Body& s, int head, double from, double to, bool pointed);
// A line where `thick` is 0.
void add_long_tail(Builder& b, Point2d root, double side, double l, double thick);

} // namespace pantin::doodle::upright
