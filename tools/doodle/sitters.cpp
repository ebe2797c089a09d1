// SPDX-License-Identifier: MIT
// Animals that sit, lie, hop or are seen from above: cats and dogs, frogs, squirrels, turtles. Units: about
// 60 long, the trunk's middle the origin, y down, facing right.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/contour.hpp"
#include "doodle/species.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

void add_two_ears(Builder& b, int head, const Frame& f, const std::string& species) {
    Random& r = b.random;
    const bool pointed = species.find("cat") != std::string::npos || r.chance(0.25);
    const double out = r.uniform(0.55, 0.95), high = r.uniform(1.2, 1.7);
    for (int s = -1; s <= 1; s += 2) {
        int ear = 0;
        if (pointed)
            ear = b.region(Label::head, {f.at(0.95 * s, -0.25), f.at(out * s, -high), f.at(0.15 * s, -0.9)},
                           r.chance(0.6) ? 0.9 : 1.2);
        else if (species.find("dog") != std::string::npos)
            ear = b.limb(Label::head, {f.at(0.7 * s, -0.75), f.at(1.15 * s, -0.3), f.at(1.2 * s, 0.5)},
                         {0.12 * f.rx, 0.25 * f.rx, 0.16 * f.rx}, 1.2);
        else
            ear = b.region(Label::head, ellipse(f.at(0.8 * s, -0.85), 0.32 * f.rx, 0.32 * f.rx), 0.9);
        if (r.chance(0.4)) b.merge(ear, head);
    }
}

void add_whiskers(Builder& b, const Frame& f) {
    for (int s = -1; s <= 1; s += 2)
        for (int i = -1; i <= 1; ++i)
            b.stick(Label::head, {f.at(0.35 * s, 0.25 + 0.08 * i), f.at(1.3 * s, 0.2 + 0.22 * i)}, 1.3, 1.0);
}

void add_any_tail(Builder& b, Point2d root, double side, double l, int trunk) {
    Random& r = b.random;
    const double rise = r.uniform(-0.2, 0.9);
    const Path line{root, root + Point2d{side * 0.6 * l, 0.1 * l},
                    root + Point2d{side * 0.85 * l, -rise * 0.6 * l},
                    root + Point2d{side * r.uniform(0.4, 0.9) * l, -rise * l}};
    if (r.chance(0.5)) {
        b.stick(Label::tail, spline(line, false), -1);
        return;
    }
    const double w = r.uniform(1.3, 3.5);
    const int tail = b.limb(Label::tail, line, {w, w, 0.8 * w}, r.chance(0.8) ? -1 : 0.5,
                            {Cap::flat, Cap::round, true, false});
    if (r.chance(0.5)) b.merge(tail, trunk);
}

// Towards us: a face over an egg, legs as lines or loops inside it.
void build_sitting_front(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const double w = r.uniform(9, 16), l = r.uniform(15, 26), h = r.uniform(9, 15);
    const Path egg = spline({{-0.45 * w, -l},
                             {-0.85 * w, -0.1 * l},
                             {-w, 0.7 * l},
                             {-0.5 * w, l},
                             {0.5 * w, l},
                             {w, 0.7 * l},
                             {0.85 * w, -0.1 * l},
                             {0.45 * w, -l}},
                            true, 6);
    const int trunk = b.region(Label::body, egg, 0);
    const Frame f{{r.uniform(-2.0, 2.0), -l - h * r.uniform(0.15, 0.6)},
                  h * r.uniform(0.95, 1.3),
                  h * r.uniform(0.8, 1.05),
                  0};
    const int head = b.region(Label::head, ellipse(f.centre, f.rx, f.ry), 1);
    if (r.chance(0.35)) b.merge(head, trunk);
    add_frontal_face(b, head, f);
    add_two_ears(b, head, f, species);
    if (species.find("cat") != std::string::npos && r.chance(0.7)) add_whiskers(b, f);
    const int manner = r.integer(0, 2); // front legs: loops, two lines with paws, sticks
    const double t = r.uniform(1.8, 3.4), x = r.uniform(0.2, 0.4) * w;
    for (int s = -1; s <= 1; s += 2) {
        const Point2d top{s * x, -0.1 * l}, foot{s * x, 1.02 * l};
        if (manner == 2)
            b.stick(Label::limb, {{s * x, 0.9 * l}, {s * x, l + r.uniform(4.0, 9.0)}}, -0.5);
        else
            b.limb(Label::limb, {top, foot}, {t, t}, 0.5, {Cap::flat, Cap::round, true, false});
        if (manner != 2 && r.chance(0.6)) { // haunches
            const int thigh = b.region(Label::limb, ellipse({s * 0.85 * w, 0.75 * l}, 0.35 * w, 0.3 * l),
                                       r.chance(0.5) ? 0.4 : -0.4);
            if (r.chance(0.4)) b.merge(thigh, trunk);
        }
    }
    const double side = r.chance(0.5) ? 1 : -1;
    add_any_tail(b, {side * 0.8 * w, 0.8 * l}, side, r.uniform(12, 26), trunk);
    b.figure.heading = 0.5 * pi;
}

// From the side on its haunches: the back a slope.
void build_sitting_side(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const double x = r.uniform(11, 17), y = r.uniform(15, 23), h = r.uniform(7, 11),
                 muzzle = species == "dog sitting sideways" ? r.uniform(4, 10) : r.uniform(0, 4);
    const Point2d c{r.uniform(0.2, 0.8) * x, -y - 0.5 * h};
    const double ear = r.uniform(5, 11), bow = r.uniform(-0.1, 0.15);
    const bool round = r.chance(0.4);
    Contour k;
    k.to({-x, 0.9 * y})
        .through({{(-0.95 - bow) * x, 0.4 * y},
                  {(-0.5 - bow) * x, -0.3 * y},
                  {c.x - 0.9 * h, c.y + 0.4 * h},
                  c + h * direction(pi + 0.5)});
    if (!round) {
        k.to(c + h * direction(-2.3) + Point2d{-2, -ear}).to(c + h * direction(-1.7));
        if (r.chance(0.5)) k.to(c + h * direction(-1.3) + Point2d{1, -ear}).to(c + h * direction(-0.9));
        k.through({c + h * direction(-0.6), c + Point2d{h + muzzle, 0.05 * h},
                   c + Point2d{h + muzzle, 0.5 * h}, c + h * direction(1.0)});
    }
    k.through({{0.75 * x, -0.3 * y}, {0.85 * x, 0.3 * y}, {0.8 * x, 0.95 * y}});
    k.through({{0, y}, {-x, 0.9 * y}});
    const int trunk = b.region(Label::body, k.points, 0);
    int head = trunk;
    if (round) {
        const Frame f{c, 1.1 * h, h, 0};
        head = b.region(Label::head, ellipse(c, f.rx, f.ry), 1);
        if (r.chance(0.3)) b.merge(head, trunk);
        add_frontal_face(b, head, f);
        add_two_ears(b, head, f, species);
    } else {
        const Point2d towards = unit(c + Point2d{3, 0.1 * y});
        b.piece(trunk, Label::head, beyond(c - (0.75 * h) * towards, towards, 2 * h + muzzle, 60));
        add_eye(b, -1, c + Point2d{0.35 * h, -0.2 * h}, 0.2 * h);
    }
    const double t = r.uniform(1.6, 3), foot = y + r.uniform(-1.0, 3.0);
    const bool lines = r.chance(0.3);
    for (int i = 0, n = r.integer(1, 2); i < n; ++i) {
        const Point2d top{(0.6 - 0.3 * i) * x, 0.0}, toe{(0.85 - 0.35 * i) * x, foot};
        if (lines)
            b.stick(Label::limb, {{toe.x, 0.85 * y}, toe + Point2d{0, 4}}, -0.5);
        else
            b.attach(b.limb(Label::limb, {top, toe}, {1.2 * t, t}, i == 0 ? 0.5 : -0.5,
                            {Cap::flat, Cap::round, true, false}),
                     trunk);
    }
    const int thigh = b.region(Label::limb, ellipse({-0.4 * x, 0.55 * y}, 0.5 * x, 0.42 * y), 0.4);
    Part& part = b.part(thigh);
    const std::size_t n = part.outline.points.size();
    for (std::size_t i = 0; i < n / 3; ++i) part.outline.undrawn[i] = 1; // its line is a bow
    if (r.chance(0.7))
        b.continued(b.limb(Label::limb, {{-0.4 * x, 0.95 * y}, {r.uniform(-0.1, 0.3) * x, 0.98 * y}},
                           {0.13 * y}, 0.45));
    add_any_tail(b, {-0.85 * x, 0.8 * y}, -1, r.uniform(10, 28), trunk);
}

// Asleep or at rest: a loaf with a head in front, paws beneath it.
void build_lying(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const double x = r.uniform(22, 32), y = r.uniform(8, 14), h = r.uniform(7, 12);
    const int trunk = b.region(Label::body,
                               r.chance(0.5) ? ellipse({0, 0}, x, y)
                                             : spline({{-x, 0.8 * y},
                                                       {-0.95 * x, -0.2 * y},
                                                       {-0.4 * x, -y},
                                                       {0.4 * x, -0.85 * y},
                                                       {0.95 * x, -0.1 * y},
                                                       {x, 0.8 * y},
                                                       {0, y}},
                                                      true, 6),
                               0);
    const Frame f{{0.85 * x, -y * r.uniform(-0.3, 1.0)}, 1.1 * h, 0.9 * h, r.uniform(-0.1, 0.2)};
    const int head = b.region(Label::head, ellipse(f.centre, f.rx, f.ry, f.angle), 1);
    if (r.chance(0.3)) b.merge(head, trunk);
    add_frontal_face(b, head, f);
    add_two_ears(b, head, f, species);
    const double t = r.uniform(1.8, 3.2);
    for (int i = 0, n = r.integer(1, 2); i < n; ++i) {
        const Point2d elbow{(0.5 + 0.2 * i) * x, 0.85 * y};
        b.attach(b.limb(Label::limb, {elbow, elbow + Point2d{r.uniform(8, 16), r.uniform(0.0, 3.0)}}, {t, t},
                        i == 0 ? 0.6 : -0.6),
                 trunk);
    }
    if (r.chance(0.7)) {
        b.region(Label::limb, ellipse({-0.6 * x, 0.45 * y}, 0.28 * x, 0.5 * y), 0.5);
        b.continued(
            b.limb(Label::limb, {{-0.6 * x, 0.95 * y}, {r.uniform(-0.4, -0.1) * x, 0.97 * y}}, {t}, 0.55));
    }
    add_any_tail(b, {-0.92 * x, 0.3 * y}, -1, r.uniform(12, 30), trunk);
}

void build_frog(Builder& b) {
    Random& r = b.random;
    if (r.chance(0.5)) { // from the side
        const double x = r.uniform(16, 22), y = r.uniform(8, 13);
        Contour k;
        k.to({-x, 0.7 * y})
            .through({{-0.6 * x, -0.4 * y},
                      {0.2 * x, -1.2 * y},
                      {0.6 * x, -1.7 * y},
                      {0.8 * x, -1.9 * y},
                      {x, -1.4 * y},
                      {1.4 * x, -0.9 * y},
                      {1.2 * x, -0.4 * y},
                      {0.8 * x, 0.2 * y},
                      {0.4 * x, 0.8 * y},
                      {-0.4 * x, y}});
        const int trunk = b.region(Label::body, k.points, 0);
        b.piece(trunk, Label::head, beyond({0.55 * x, -0.7 * y}, {1, -0.35}, 2.5 * y, 50));
        add_eye(b, -1, {0.85 * x, -1.5 * y}, 0.25 * y);
        b.region(Label::limb, ellipse({-0.5 * x, 0.4 * y}, 0.5 * x, 0.45 * y, -0.4), 0.5);
        b.continued(b.limb(Label::limb, {{-0.6 * x, 0.9 * y}, {0.2 * x, 1.05 * y}}, {1.5, 1.5}, 0.6));
        b.limb(Label::limb, {{0.5 * x, 0.3 * y}, {0.7 * x, 1.0 * y}, {1.0 * x, 1.05 * y}}, {1.8, 1.5, 1.3},
               0.6);
        return;
    }
    const double w = r.uniform(15, 21), l = r.uniform(11, 16);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, l), 0);
    const Frame f{{0, -0.8 * l}, 0.85 * w, 0.7 * l, 0};
    const int head = b.region(Label::head, ellipse(f.centre, f.rx, f.ry), 1);
    b.attach(head, trunk);
    for (int s = -1; s <= 1; s += 2) {
        const Point2d c = f.at(0.5 * s, -0.95);
        const int bulge = b.region(Label::head, ellipse(c, 0.25 * f.rx, 0.35 * f.ry), 1.1);
        if (r.chance(0.5)) b.merge(bulge, head);
        b.spot(-1, ellipse(c, 0.09 * f.rx, 0.12 * f.ry));
        b.limb(Label::limb,
               {{0.8 * s * w, 0.3 * l}, {1.4 * s * w, 0.2 * l}, {1.2 * s * w, l}, {1.5 * s * w, 1.05 * l}},
               {4, 3, 1.8, 1.5}, -0.5);
        b.limb(Label::limb, {{0.35 * s * w, 0.5 * l}, {0.4 * s * w, 1.2 * l}}, {1.8, 1.8}, 0.5);
    }
    b.mark(head, spline({f.at(-0.6, 0.1), f.at(0, 0.5), f.at(0.6, 0.1)}, false));
    b.figure.heading = 0.5 * pi;
}

// A turtle from above, or from the side with flippers.
void build_sea_turtle(Builder& b) {
    Random& r = b.random;
    const double x = r.uniform(17, 24), y = x * r.uniform(0.65, 0.95);
    const int trunk = b.region(Label::body, ellipse({0, 0}, x, y), 0);
    const double h = r.uniform(5, 9);
    const int head =
        b.region(Label::head, ellipse({x + 0.6 * h, r.uniform(-2.0, 2.0)}, 1.15 * h, h * 0.85), -0.3);
    if (r.chance(0.3)) b.merge(head, trunk);
    if (r.chance(0.7)) add_eye(b, head, {x + h, -0.2 * h}, 0.2 * h);
    const double t = r.uniform(2, 4.5), l = r.uniform(7, 18);
    const bool loops = r.chance(0.5);
    for (int end = -1; end <= 1; end += 2)
        for (int s = -1; s <= 1; s += 2) {
            const Point2d root{0.65 * end * x, 0.65 * s * y},
                d = direction(math::atan2(s * 1.0, end * (end > 0 ? 0.9 : 1.2)));
            const double len = end > 0 ? l : 0.7 * l;
            const int leg =
                loops ? b.region(Label::limb,
                                 ellipse(root + (0.5 * len) * d, 0.6 * len, t, math::atan2(d.y, d.x)), -0.5)
                      : b.limb(Label::limb, {root, root + (0.6 * len) * d, root + len * d + Point2d{-3.0, 0}},
                               {t, t, 0.6 * t}, -0.5);
            if (r.chance(0.15)) b.merge(leg, trunk);
        }
    if (r.chance(0.6))
        b.region(Label::tail, {{-0.97 * x, -2}, {-x - r.uniform(3.0, 8.0), 0}, {-0.97 * x, 2}}, -0.2);
    const int pattern = r.integer(0, 3);
    for (int i = -2; i <= 2 && pattern <= 1; ++i) {
        b.mark(trunk, {{0.35 * i * x, -y}, {0.35 * i * x, y}});
        if (pattern == 0) b.mark(trunk, {{-x, 0.35 * i * y}, {x, 0.35 * i * y}});
    }
    if (pattern == 2) b.mark(trunk, ellipse({0, 0}, 0.6 * x, 0.55 * y), true);
    b.figure.max_tilt = r.chance(0.5) ? pi : 0.2;
}

// On all fours with the tail over its back.
void build_squirrel(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(8, 13), l = r.uniform(13, 20), lean = r.uniform(0.2, 0.9), h = r.uniform(6, 9);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, l, lean), 0);
    const Point2d c = rotated({0, -l - 0.3 * h}, lean);
    const int head = b.region(Label::head, ellipse(c, 1.15 * h, 0.9 * h, r.uniform(0.0, 0.4)), 1);
    if (r.chance(0.45)) b.merge(head, trunk);
    add_eye(b, head, c + Point2d{0.35 * h, -0.2 * h}, 0.2 * h);
    add_two_ears(b, head, {c - Point2d{0.3 * h, 0}, 0.7 * h, h, 0}, r.chance(0.6) ? "cat" : "");
    const bool lines = r.chance(0.4);
    for (int i = 0; i < 4; ++i) {
        const bool front = i >= 2;
        const Point2d hip = rotated({(front ? 0.6 : 0.1) * w, (front ? -0.3 : 0.75) * l}, lean),
                      foot = hip + (front ? Point2d{r.uniform(4, 9), r.uniform(0.0, 9.0)}
                                          : Point2d{r.uniform(0.0, 6.0), r.uniform(4, 9)});
        if (lines)
            b.stick(Label::limb, {hip, foot}, -0.5);
        else
            b.attach(b.limb(Label::limb, {hip, foot}, {2.4, 1.6}, i % 2 ? 0.5 : -0.5), trunk);
    }
    const Point2d root = rotated({-0.5 * w, 0.8 * l}, lean);
    const double tl = l * r.uniform(1.6, 2.6), q = tl * r.uniform(0.09, 0.2);
    const Path up{root, root + Point2d{-0.35 * tl, 0.05 * tl}, root + Point2d{-0.45 * tl, -0.4 * tl},
                  root + Point2d{-0.3 * tl, -0.8 * tl}, root + Point2d{-0.55 * tl, -0.9 * tl}};
    const int tail = b.limb(Label::tail, Path(up.begin(), up.end() - r.integer(0, 1)),
                            {0.4 * q, q, 1.2 * q, q, 0.4 * q}, -1);
    if (r.chance(0.4)) b.merge(tail, trunk);
    for (int i = 1; i < 6 && r.chance(0.3); ++i)
        b.mark(tail, {mix(up[1], up[3], i / 6.0) - Point2d{q, 0},
                      mix(up[1], up[3], i / 6.0) + Point2d{0.6 * q, -0.5 * q}});
}

const std::vector<Sketch>& sketches() {
    static const std::vector<Sketch> table = {
        {"sitting cat", build_sitting_front},
        {"sitting dog", build_sitting_front},
        {"cat sitting sideways", build_sitting_side},
        {"dog sitting sideways", build_sitting_side},
        {"lying cat", build_lying},
        {"lying dog", build_lying},
        {"frog", build_frog},
        {"sea turtle", build_sea_turtle},
        {"squirrel", build_squirrel},
    };
    return table;
}

} // namespace

std::vector<std::string> sitter_species() { return names_of(sketches()); }

Figure build_sitter(Random& random, const std::string& species) {
    Builder b(random, "quadruped", species);
    row_of(sketches(), species).draw(b);
    return std::move(b.figure);
}

} // namespace pantin::doodle
