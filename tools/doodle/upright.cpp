// SPDX-License-Identifier: MIT
// Upright figures as they are sketched: people in all poses and from the side, monkeys with tails, mermaids,
// snowmen, bears, princesses, kangaroos. Units: about 100 from head to foot, x = 0 the middle, y down from
// the head's.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/contour.hpp"
#include "doodle/species.hpp"
#include "doodle/upright_body.hpp"

namespace pantin::doodle {
namespace {

using math::pi;
using namespace upright;

void build_posed(Builder& b) {
    const bool lines = b.figure.species == "posed stick person", baby = b.figure.species == "baby";
    Random& r = b.random;
    Body s = random_body(b);
    if (lines) s.trunk = Trunk::line, s.arms = s.legs = Limbs::lines;
    if (baby)
        s.hx = r.uniform(15, 24), s.hy = 0.95 * s.hx, s.top = s.hy - 1, s.length = r.uniform(16, 24),
        s.leg = r.uniform(7, 14), s.arm = r.uniform(8, 15);
    const int head = add_head(b, s, true);
    const Frame f{{0, 0}, s.hx, s.hy, 0};
    const double dressed = 0.5 * b.manner.details + 0.1;
    if (r.chance(dressed)) add_hair(b, head, f);
    if (r.chance(0.5 * dressed)) add_hat(b, head, f);
    const int trunk = add_trunk(b, s, head);
    add_legs(b, s, trunk);
    const Point2d hand = add_arms(b, s, trunk);
    if (r.chance(0.18)) add_held(b, hand);
    if (s.w > 0 && r.chance(0.25)) add_pattern(b, trunk, {{0, s.middle()}, s.w, 0.5 * s.length, 0});
}

void build_boxy_robot(Builder& b) {
    Random& r = b.random;
    Body s = random_body(b);
    s.trunk = Trunk::box, s.w = 0.5 * s.length * r.uniform(0.5, 1.0), s.hx = s.w * r.uniform(0.5, 1.0),
    s.hy = s.hx * r.uniform(0.6, 1.0);
    s.top = s.hy + (r.chance(0.6) ? -0.5 : r.uniform(1.0, 4.0));
    const int head = b.region(Label::head, {{-s.hx, -s.hy}, {s.hx, -s.hy}, {s.hx, s.hy}, {-s.hx, s.hy}}, 1);
    add_frontal_face(b, head, {{0, 0}, s.hx, s.hy, 0});
    for (int side = -1, pair = r.integer(0, 2); side <= 1 && pair > 0; side += 2) {
        const double x = pair == 1 ? 0.0 : 0.5 * side * s.hx;
        const Point2d tip{x, -s.hy - r.uniform(4.0, 9.0)};
        b.stick(Label::head, {{x, -s.hy}, tip}, 0, 1.5);
        b.region(Label::head, ellipse(tip, 1.5, 1.5), 1);
        if (pair == 1) break;
    }
    const int trunk = add_trunk(b, s, head);
    if (r.chance(0.5)) b.mark(trunk, ellipse({0, s.middle()}, 0.6 * s.w, 0.25 * s.length, 0, 8.0), true);
    for (int i = 0, n = r.integer(0, 3); i < n; ++i)
        b.mark(trunk, ellipse({(-0.4 + 0.4 * i) * s.w, s.middle()}, 1.3, 1.3), true);
    add_legs(b, s, trunk);
    add_arms(b, s, trunk);
}

void build_sketch_monkey(Builder& b) {
    Random& r = b.random;
    Body s = random_body(b);
    if (s.trunk == Trunk::dress) s.trunk = Trunk::oval;
    if (r.chance(0.6))
        s.hx = std::max(s.hx, r.uniform(12, 20)), s.hy = s.hx * r.uniform(0.7, 1.05),
        s.top = s.hy - r.uniform(0.0, 3.0);
    s.leg *= 0.75;
    const int head = add_head(b, s, true);
    if (r.chance(0.85)) {
        const bool low = r.chance(0.6), pointed = r.chance(0.15);
        add_side_ears(b, s, head, low ? -0.1 : 0.4, 0.9, pointed);
    }
    if (r.chance(0.3)) b.mark(head, ellipse({0, 0.3 * s.hy}, 0.6 * s.hx, 0.4 * s.hy), true);
    const int trunk = add_trunk(b, s, head);
    if (!r.chance(0.12)) add_legs(b, s, trunk);
    if (!r.chance(0.12)) add_arms(b, s, trunk);
    if (s.w > 0 && r.chance(0.3))
        b.mark(trunk, ellipse({0, s.middle() + 2}, 0.5 * s.w, 0.3 * s.length), true);
    if (r.chance(0.12)) return;
    const double side = r.chance(0.5) ? -1 : 1;
    const double l = r.uniform(18, 48), y = s.bottom() - r.uniform(0.05, 0.35) * s.length;
    add_long_tail(b, {side * 0.7 * s.w, y}, side, l, r.chance(0.45) ? 0 : r.uniform(1.5, 4.5));
}

void build_princess(Builder& b) {
    Random& r = b.random;
    Body s = random_body(b);
    s.trunk = Trunk::dress, s.length = r.uniform(34, 62), s.w = r.uniform(6, 12);
    s.leg = r.uniform(5, 14);
    const int head = add_head(b, s, true);
    const Frame f{{0, 0}, s.hx, s.hy, 0};
    if (r.chance(0.7)) { // falling at both sides
        const double l = r.uniform(1.0, 3.0), w = r.uniform(1.05, 1.5);
        if (r.chance(0.5)) {
            b.region(
                Label::head,
                spline({f.at(0, -1.15), f.at(-0.9 * w, -0.7), f.at(-w, 0.3), f.at(-1.1 * w, l), f.at(-0.4, l),
                        f.at(0.4, l), f.at(1.1 * w, l), f.at(w, 0.3), f.at(0.9 * w, -0.7)},
                       true, 6),
                -3);
        } else {
            const bool wavy = r.chance(0.5);
            for (int side = -1; side <= 1; side += 2)
                for (int i = 0, n = r.integer(1, 3); i < n; ++i)
                    b.stick(Label::head,
                            spline({f.at(0.5 * side, -0.85), f.at(side * (1.05 + 0.15 * i), -0.1),
                                    f.at(side * (1.1 + 0.15 * i + (wavy ? 0.25 : 0)), 0.5 * l),
                                    f.at(side * (1.1 + 0.2 * i), l)},
                                   false),
                            -0.2, 2.0);
        }
    } else {
        add_hair(b, head, f);
    }
    if (r.chance(0.5)) add_hat(b, head, f);
    const int trunk = add_trunk(b, s, head);
    if (r.chance(0.5)) add_legs(b, s, trunk);
    const Point2d hand = add_arms(b, s, trunk);
    if (r.chance(0.1)) add_held(b, hand);
}

void build_mermaid(Builder& b) {
    Random& r = b.random;
    Body s = random_body(b);
    s.hx = r.uniform(7, 13), s.hy = s.hx * r.uniform(0.9, 1.2), s.top = s.hy + r.uniform(-1.0, 4.0);
    s.length = r.uniform(16, 28), s.w = r.uniform(0.25, 0.42) * s.length;
    const double side = r.chance(0.5) ? -1 : 1, l = r.uniform(30, 55), bend = r.uniform(0.0, 1.0) * l * side,
                 y = s.bottom();
    const int head = add_head(b, s, true);
    const Frame f{{0, 0}, s.hx, s.hy, 0};
    if (r.chance(0.7)) {
        const double hair = r.uniform(1.0, 3.0);
        for (int k = -1; k <= 1; k += 2)
            b.stick(Label::head,
                    spline({f.at(0.1 * k, -1), f.at(1.1 * k, -0.5), f.at(1.25 * k, 0.6), f.at(1.4 * k, hair)},
                           false),
                    -0.2, 2.0);
    } else {
        add_hair(b, head, f);
    }
    const double hip = s.w * r.uniform(0.85, 1.15), thin = std::max(1.2, 0.25 * hip);
    const Point2d knee{0.35 * bend, y + 0.5 * l}, ankle{bend, y + l - 0.35 * std::abs(bend)};
    const Path spine{{0, y - 2}, {0.08 * bend, y + 0.25 * l}, knee, ankle};
    s.trunk = r.chance(0.5) ? Trunk::box : Trunk::pear;
    const int trunk = add_trunk(b, s, head);
    const int tail = b.limb(Label::tail, spine, {hip, 0.9 * hip, 0.55 * hip, thin}, 0.1,
                            {Cap::flat, Cap::flat, r.chance(0.6), true});
    if (r.chance(0.5)) b.merge(tail, trunk);
    const Point2d along = unit(ankle - knee), across{-along.y, along.x};
    const double fin = r.uniform(7, 15), fan = r.uniform(0.5, 1.1);
    const Path flukes{ankle - (0.5 * thin) * across, ankle + fin * along - (fan * fin) * across,
                      ankle + (r.uniform(0.35, 0.8) * fin) * along,
                      ankle + fin * along + (fan * fin) * across, ankle + (0.5 * thin) * across};
    const int end = b.region(Label::tail, r.chance(0.5) ? flukes : spline(flukes, true, 5), 0.2);
    if (r.chance(0.7)) b.merge(end, tail);
    add_arms(b, s, trunk);
    if (r.chance(0.3)) // scales
        for (int i = 0, n = r.integer(3, 9); i < n; ++i) {
            const double down = r.uniform(0.1, 1.0), across_it = r.uniform(-0.5, 0.5);
            const Point2d p = mix(spine[0], spine[2], down) + Point2d{across_it * hip, 0};
            b.mark(tail, spline({p, p + Point2d{1.5, 2}, p + Point2d{3, 0}}, false), false, 0.8);
        }
    if (r.chance(0.4))
        for (int k = -1; k <= 1; k += 2)
            b.mark(trunk, ellipse({0.45 * k * s.w, s.top + 0.35 * s.length}, 0.35 * s.w, 0.3 * s.w), true);
}

void build_snowman(Builder& b) {
    Random& r = b.random;
    const int balls = r.chance(0.6) ? 2 : 1; // below the head
    double radius = r.uniform(9, 14), y = 0;
    const double grow = r.uniform(1.15, 1.6);
    const double high = radius * r.uniform(0.85, 1.1);
    const int head = b.region(Label::head, ellipse({0, 0}, radius, high), r.chance(0.7) ? 1 : -0.1);
    const Frame f{{0, 0}, radius, radius, 0};
    add_frontal_face(b, head, f);
    if (r.chance(0.4)) b.mark(head, {f.at(0, -0.1), f.at(r.uniform(0.5, 1.2), 0.05), f.at(0, 0.15)});
    if (r.chance(0.5)) add_hat(b, head, f);
    Point2d arms{};
    int trunk = -1;
    for (int i = 0; i < balls; ++i) {
        const double next = radius * (i == 0 && balls == 2 ? std::min(grow, 1.35) : grow);
        y += (radius + next) * r.uniform(0.75, 0.97);
        const double aside = r.uniform(-1.5, 1.5), flat = next * r.uniform(0.85, 1.0);
        trunk = b.region(Label::body, ellipse({aside, y}, next, flat), r.chance(0.6) ? -0.2 * i : 0.1 * i);
        if (i == 0) {
            arms = {0.85 * next, y - 0.2 * next};
            for (int k = 0, n = r.integer(0, 4); k < n; ++k)
                b.spot(trunk, ellipse({0, y - 0.5 * next + next * k / 3.0}, 1.0, 1.0));
        }
        radius = next;
    }
    if (r.chance(0.1)) return;
    const bool fingers = r.chance(0.7);
    for (int side = -1; side <= 1; side += 2) {
        const Point2d root{side * arms.x, arms.y},
            tip = root + Point2d{side * r.uniform(10, 24), r.uniform(-16, 6)};
        b.stick(Label::limb, {root, tip}, 0.5);
        for (int k = -1; k <= 1 && fingers; k += 2)
            b.continued(
                b.stick(Label::limb, {mix(root, tip, 0.75), tip + Point2d{side * 1.0, 4.0 * k}}, 0.5, 2.0));
    }
}

// Bears, pandas, rabbits, upright: round trunk, short limbs.
void build_bear(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    Body s = random_body(b);
    s.hx = r.uniform(12, 20), s.hy = s.hx * r.uniform(0.8, 1.05), s.top = s.hy - r.uniform(1.0, 4.0);
    s.trunk = r.chance(0.7) ? Trunk::oval : Trunk::pear, s.w = 0.5 * s.length * r.uniform(0.7, 1.1);
    s.thick = r.uniform(3, 6), s.arm = r.uniform(10, 20), s.leg = r.uniform(7, 16);
    s.arms = s.legs = r.pick(std::vector<Limbs>{Limbs::loops, Limbs::ribbons, Limbs::open, Limbs::loops});
    const int head = add_head(b, s, true);
    if (species == "upright rabbit") {
        for (int side = -1; side <= 1; side += 2) {
            const double l = s.hy * r.uniform(1.0, 2.2), lean = r.uniform(0.0, 0.4);
            const Point2d root{0.4 * side * s.hx, -0.75 * s.hy}, up{side * math::sin(lean), -math::cos(lean)};
            const int ear = b.limb(Label::head, {root, root + (0.5 * l) * up, root + l * up},
                                   {0.14 * s.hx, 0.26 * s.hx, 0.08 * s.hx}, -0.2);
            if (r.chance(0.5)) b.merge(ear, head);
        }
    } else {
        add_side_ears(b, s, head, 0.6, 1.1, false);
    }
    const int trunk = add_trunk(b, s, head);
    add_legs(b, s, trunk);
    add_arms(b, s, trunk);
    if (r.chance(0.35)) b.mark(trunk, ellipse({0, s.middle()}, 0.6 * s.w, 0.33 * s.length), true);
    if (species == "panda" && r.chance(0.8))
        for (int side = -1; side <= 1; side += 2)
            b.spot(head, ellipse({0.38 * side * s.hx, -0.15 * s.hy}, 0.17 * s.hx, 0.24 * s.hy, 0.4 * side));
}

// All of one outline, as a cut biscuit.
void build_gingerbread(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const double h = r.uniform(9, 16), w = r.uniform(7, 13), l = r.uniform(20, 34), arm = r.uniform(10, 24),
                 leg = r.uniform(12, 28), t = r.uniform(3, 6);
    const double raise = r.uniform(-0.9, 0.9), spread = r.uniform(0.15, 0.6), y = h * 0.9;
    const int trunk =
        b.region(Label::body, ellipse({0, y + 0.5 * l}, w, 0.55 * l, 0, r.uniform(2.0, 3.5)), 0);
    const int head = b.region(Label::head, ellipse({0, 0}, h, h * r.uniform(0.85, 1.15)), 0.2);
    const double depth = r.chance(0.7) ? -0.05 : 0.05;
    b.merge(head, trunk);
    add_frontal_face(b, head, {{0, 0}, h, h, 0});
    for (int side = -1; side <= 1; side += 2) {
        const Point2d shoulder{0.6 * side * w, y + 0.25 * l}, hip{0.5 * side * w, y + 0.85 * l};
        const Point2d hand = shoulder + (arm + 0.4 * w) * Point2d{side * math::cos(raise), -math::sin(raise)};
        const int limbs[2] = {b.limb(Label::limb, {shoulder, hand}, {t, t * 0.9}, depth),
                              b.limb(Label::limb,
                                     {hip, hip + leg * Point2d{side * math::sin(spread), math::cos(spread)}},
                                     {1.3 * t, t}, depth)};
        for (int limb : limbs) b.merge(limb, trunk);
        if (species == "outlined monkey") {
            const double ear = h * r.uniform(0.3, 0.5);
            const int part = b.region(Label::head, ellipse({side * h, -0.2 * h}, ear, ear), 0.1);
            if (r.chance(0.6)) b.merge(part, head);
        }
    }
    if (species == "outlined monkey") {
        const double side = r.chance(0.5) ? 1 : -1;
        const double tail = r.uniform(20, 40);
        add_long_tail(b, {0.7 * side * w, y + 0.8 * l}, side, tail, r.chance(0.3) ? 0 : r.uniform(2, 4));
    } else if (r.chance(0.3)) {
        for (int i = 0; i < 3; ++i) b.spot(trunk, ellipse({0, y + (0.25 + 0.22 * i) * l}, 1.2, 1.2));
    }
}

// Somebody from the side: walking, running, sitting; one or two arms.
void build_side_person(Builder& b) {
    Random& r = b.random;
    Body s = random_body(b);
    if (s.trunk == Trunk::dress) s.trunk = Trunk::pear;
    s.w *= 0.8;
    const int head = add_head(b, s, false);
    if (r.chance(0.7)) add_eye(b, head, {0.55 * s.hx, -0.15 * s.hy}, 0.15 * s.hx);
    if (r.chance(0.7)) { // a nose
        const int nose = b.region(
            Label::head,
            {{0.9 * s.hx, -0.15 * s.hy}, {s.hx * r.uniform(1.2, 1.5), 0.12 * s.hy}, {0.9 * s.hx, 0.2 * s.hy}},
            1.1);
        b.merge(nose, head);
    }
    if (r.chance(0.5)) b.mark(head, {{0.45 * s.hx, 0.5 * s.hy}, {0.85 * s.hx, 0.45 * s.hy}});
    if (r.chance(0.4)) add_hair(b, head, {{0, 0}, s.hx, s.hy, -0.3});
    const int trunk = add_trunk(b, s, head);
    const int way = r.integer(0, 2); // walking, running, sitting
    const bool joined = r.chance(0.5);
    for (int i = 0; i < 2; ++i) {
        const double swing = i == 0 ? 1 : -1, reach = way == 1 ? r.uniform(0.5, 1.0) : r.uniform(0.15, 0.5);
        const double thigh = way == 2 ? 1.4 + 0.1 * swing : swing * reach,
                     shin = way == 2 ? r.uniform(-0.1, 0.2)
                                     : thigh - (way == 1 ? r.uniform(0.3, 1.3) : r.uniform(0.0, 0.3));
        const Point2d hip{0, s.bottom() - 0.08 * s.length}, knee = hip + (0.5 * s.leg) * outwards(thigh, 1),
                                                            foot = knee + (0.5 * s.leg) * outwards(shin, 1);
        add_limb(b, trunk, {hip, knee, foot}, s.thick, s.legs, i == 0 ? -0.5 : -1, joined);
        if (r.chance(0.7))
            b.continued(b.stick(Label::limb, {foot, foot + Point2d{r.uniform(3.0, 6.0), 0}}, -0.5));
        const Point2d shoulder{0, s.top + 0.15 * s.length};
        const double upper = way == 2 ? r.uniform(0.3, 1.4) : -swing * r.uniform(0.2, 1.0),
                     low = upper + r.uniform(0.1, 1.3);
        const Point2d elbow = shoulder + (0.5 * s.arm) * outwards(upper, 1);
        if (i == 0 || r.chance(0.7))
            add_limb(b, trunk, {shoulder, elbow, elbow + (0.5 * s.arm) * outwards(low, 1)}, 0.9 * s.thick,
                     s.arms, i == 0 ? 1.5 : -1, false);
    }
    b.figure.heading = 0;
}

// The tail of what sits upright, with the kangaroo's pouch.
void add_hind_tail(Builder& b, int trunk, Frame f, const std::string& species) {
    Random& r = b.random;
    const Point2d root = f.at(-0.9, 0.7);
    if (species == "upright squirrel") {
        const double tl = f.ry * r.uniform(1.8, 3.0), q = tl * r.uniform(0.1, 0.22);
        const Path up{root, root + Point2d{-0.45 * tl, -0.1 * tl}, root + Point2d{-0.5 * tl, -0.65 * tl},
                      root + Point2d{-0.2 * tl, -0.85 * tl}, root + Point2d{-0.25 * tl, -0.6 * tl}};
        const int tail = b.limb(Label::tail, Path(up.begin(), up.end() - r.integer(0, 1)),
                                {0.4 * q, q, 1.2 * q, 0.7 * q, 0.3 * q}, -0.5);
        if (r.chance(0.5)) b.merge(tail, trunk);
    } else if (species == "upright mouse") {
        add_long_tail(b, root, -1, r.uniform(25, 45), 0);
    } else {
        const double tl = r.uniform(26, 50);
        const int tail = b.limb(Label::tail,
                                {f.at(-0.4, 0.6), root + Point2d{-0.35 * tl, 0.25 * tl},
                                 root + Point2d{-tl, r.uniform(0.1, 0.4) * tl}},
                                {0.5 * f.rx, 0.4 * f.rx, 0.5}, -0.2, {Cap::flat, Cap::pointed, true, false});
        b.merge(tail, trunk);
        if (r.chance(0.5))
            b.mark(trunk, spline({f.at(0.1, 0.2), f.at(0.5, 0.6), f.at(1.0, 0.3)}, false)); // a pouch
    }
}

// From the side, leaning back on its tail: kangaroo; with a bushy tail: squirrel.
void build_side_upright(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const double w = r.uniform(6, 11), l = r.uniform(26, 42), lean = r.uniform(-0.1, 0.4),
                 h = r.uniform(6, 9), muzzle = r.uniform(3, 9);
    const auto at = [&](double u, double v) { return rotated({u * w, (v - 0.5) * l}, lean); };
    const Point2d c = at(0.3, -0.05), way = direction(r.uniform(-0.2, 0.4));
    Contour k;
    k.to(at(-1.1, 0.95))
        .through({at(-1.1, 0.7), at(-0.75, 0.4), at(-0.4, 0.15), c + h * direction(pi - 0.1),
                  c + h * direction(-2.3)});
    k.to(c + h * direction(-2.2) + Point2d{r.uniform(-3.0, 1.0), -r.uniform(4.0, 10.0)})
        .to(c + h * direction(-1.6));
    k.through({c + h * direction(-0.8), c + (h + muzzle) * way - Point2d{0, 1.5},
               c + (h + muzzle) * way + Point2d{0, 1.5}, c + h * direction(1.0)});
    k.through({at(0.45, 0.2), at(0.7, 0.45), at(1.1, 0.75), at(0.9, 0.98), at(0, 1.03)});
    const int trunk = b.region(Label::body, k.points, 0);
    const Point2d towards = unit(c - at(0, 0.3) + Point2d{3, 0});
    b.piece(trunk, Label::head, beyond(c - (0.75 * h) * towards, towards, 2.5 * h + muzzle, 60));
    add_eye(b, -1, c + Point2d{0.3 * h, -0.2 * h}, 0.22 * h);
    const Limbs kind = r.pick(std::vector<Limbs>{Limbs::lines, Limbs::ribbons, Limbs::open});
    const double t = r.uniform(1.5, 3);
    for (int i = 0, n = r.integer(1, 2); i < n; ++i) {
        const Point2d shoulder = at(0.5, 0.28 + 0.08 * i),
                      hand = shoulder + Point2d{r.uniform(6, 13), r.uniform(-3.0, 7.0)};
        const Point2d elbow = mix(shoulder, hand, 0.5) + Point2d{0, r.uniform(0.0, 3.0)};
        const double depth = i == 0 && r.chance(0.5) ? 1.0 : -0.5;
        add_limb(b, trunk, {shoulder - Point2d{0.3 * w, 0}, elbow, hand}, t, kind, depth, r.chance(0.5));
    }
    const double foot = r.uniform(8, 17);
    const Point2d hip = at(0.1, 0.85), knee = at(1.0, 1.0),
                  heel = at(0.0, 1.0) + Point2d{0, r.uniform(4.0, 12.0)};
    if (kind == Limbs::lines) {
        b.stick(Label::limb, {hip, knee, heel, heel + Point2d{foot, 0}}, 0.5);
    } else {
        b.attach(b.limb(Label::limb, {hip, heel}, {0.6 * w, 0.3 * w}, r.chance(0.5) ? 0.5 : -0.5,
                        {Cap::round, Cap::round, true, false}),
                 trunk);
        b.continued(b.limb(Label::limb, {heel - Point2d{1, 0}, heel + Point2d{foot, 0}}, {0.25 * w}, 0.4));
    }
    add_hind_tail(b, trunk, {{}, w, 0.5 * l, lean}, species);
    b.figure.heading = 0;
}

const std::vector<Sketch>& sketches() {
    static const std::vector<Sketch> table = {
        {"posed person", build_posed},
        {"posed stick person", build_posed},
        {"sketched monkey", build_sketch_monkey},
        {"outlined monkey", build_gingerbread},
        {"gingerbread", build_gingerbread},
        {"princess", build_princess},
        {"mermaid", build_mermaid},
        {"snowman", build_snowman},
        {"panda", build_bear},
        {"round bear", build_bear},
        {"upright rabbit", build_bear},
        {"person from the side", build_side_person},
        {"baby", build_posed},
        {"kangaroo", build_side_upright},
        {"upright squirrel", build_side_upright},
        {"upright mouse", build_side_upright},
        {"boxy robot", build_boxy_robot},
    };
    return table;
}

} // namespace

std::vector<std::string> upright_species() { return names_of(sketches()); }

Figure build_upright(Random& random, const std::string& species) {
    Builder b(random, "humanoid", species);
    b.figure.heading = 0.5 * pi;
    row_of(sketches(), species).draw(b);
    return std::move(b.figure);
}

} // namespace pantin::doodle
