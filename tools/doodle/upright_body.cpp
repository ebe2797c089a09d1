// SPDX-License-Identifier: MIT
// Heads, trunks and limbs of upright sketches in their many kinds.
#include "doodle/upright_body.hpp"

#include <algorithm>

#include "core/math.hpp"

namespace pantin::doodle::upright {

using math::pi;

Body random_body(Builder& b) {
    Random& r = b.random;
    Body s{};
    const bool big = r.chance(0.4);
    s.hx = big ? r.uniform(12, 21) : r.uniform(7, 13), s.hy = s.hx * r.uniform(0.75, 1.25);
    s.length = r.uniform(18, 42), s.w = s.length * r.uniform(0.2, 0.6);
    s.top = s.hy + (r.chance(0.7) ? r.uniform(-3.0, 0.5) : r.uniform(0.5, 6));
    s.arm = r.uniform(14, 40), s.leg = r.uniform(9, 36), s.thick = r.uniform(1.6, 4.5);
    s.trunk = r.pick(std::vector<Trunk>{Trunk::line, Trunk::oval, Trunk::oval, Trunk::box, Trunk::pear,
                                        Trunk::dress, Trunk::flowing});
    const std::vector<Limbs> kinds = {Limbs::lines, Limbs::lines, Limbs::ribbons, Limbs::open, Limbs::loops};
    s.arms = r.pick(kinds), s.legs = r.chance(0.7) ? s.arms : r.pick(kinds);
    return s;
}

int add_head(Builder& b, const Body& s, bool face) {
    Random& r = b.random;
    const double exponent = r.chance(0.12) ? r.uniform(2.5, 6.0) : 2.0;
    const Point2d c{r.uniform(-1.5, 1.5), 0};
    const double lean = r.uniform(-0.1, 0.1);
    const int head = b.region(Label::head, ellipse(c, s.hx, s.hy, lean, exponent), r.chance(0.8) ? 1 : -0.3);
    if (face && r.chance(0.85)) add_frontal_face(b, head, {c, s.hx, s.hy, 0});
    return head;
}

int add_trunk(Builder& b, Body& s, int head) {
    Random& r = b.random;
    const double t = s.top, l = s.length, w = s.w, y = s.middle();
    int trunk = 0;
    switch (s.trunk) {
    case Trunk::line:
        s.w = 0;
        trunk = b.stick(Label::body, {{0, s.hy - 0.5}, {r.uniform(-1.5, 1.5), y}, {0, s.bottom()}});
        b.merge(trunk, head);
        return trunk;
    case Trunk::oval:
        trunk = b.region(Label::body, ellipse({0, y}, w, 0.5 * l + 1, r.uniform(-0.1, 0.1)), 0);
        break;
    case Trunk::box: {
        const double hip = w * r.uniform(0.7, 1.2);
        trunk = b.region(Label::body, {{-w, t}, {w, t}, {hip, t + l}, {-hip, t + l}}, 0);
        break;
    }
    case Trunk::dress: {
        const double hem = w * r.uniform(1.3, 2.6), waist = t + l * r.uniform(0.25, 0.5),
                     thin = w * r.uniform(0.3, 0.7);
        const Path triangle{{-0.3 * w, t}, {0.3 * w, t}, {hem, t + l}, {-hem, t + l}};
        const Path gown{{-0.6 * w, t},     {0.6 * w, t},  {thin, waist}, {hem, t + l},
                        {0, t + 1.04 * l}, {-hem, t + l}, {-thin, waist}};
        trunk = b.region(Label::body, r.chance(0.5) ? triangle : gown, 0);
        if (r.chance(0.3)) b.mark(trunk, {{-w, waist}, {w, waist}});
        break;
    }
    default: // a pear
        trunk = b.region(Label::body,
                         spline({{-0.5 * w, t},
                                 {-0.9 * w, t + 0.45 * l},
                                 {-1.1 * w, t + 0.85 * l},
                                 {0, t + l},
                                 {1.1 * w, t + 0.85 * l},
                                 {0.9 * w, t + 0.45 * l},
                                 {0.5 * w, t}},
                                true, 6),
                         0);
    }
    if (s.top > s.hy + 0.5) {
        const double n = std::min(r.uniform(0.15, 0.35) * s.hx, 0.8 * w);
        const int neck = r.chance(0.3) ? b.stick(Label::body, {{0, s.hy - 1}, {0, t + 2}}, -0.4)
                                       : b.limb(Label::body, {{0, s.hy - 1.5}, {0, t + 2}}, {n}, -0.4,
                                                {Cap::flat, Cap::flat, true, true});
        b.merge(neck, trunk);
    } else {
        b.attach(head, trunk);
    }
    return trunk;
}

int add_limb(Builder& b, int trunk, const Path& line, double thick, Limbs kind, double depth, bool joined) {
    Random& r = b.random;
    if (kind == Limbs::lines) {
        const int limb = b.stick(Label::limb, r.chance(0.4) ? spline(line, false) : line, depth);
        const Point2d end = line.back(), along = unit(end - line[line.size() - 2]);
        const int hand = r.integer(0, 5);
        for (int k = -1; k <= 1 && hand == 0; ++k)
            b.continued(b.stick(Label::limb, {end, end + 3.0 * rotated(along, 0.7 * k)}, depth, 2.0));
        if (hand == 1) b.continued(b.region(Label::limb, ellipse(end + 1.5 * along, 2.2, 2.0), depth + 0.1));
        return limb;
    }
    if (kind == Limbs::loops) { // a long oval
        const Point2d a = line.front(), e = line.back();
        const double half = 0.55 * distance(a, e), along = math::atan2(e.y - a.y, e.x - a.x);
        const int limb = b.region(
            Label::limb, ellipse(mix(a, e, 0.5), half, std::max(thick, half * r.uniform(0.25, 0.4)), along),
            depth);
        if (joined) b.merge(limb, trunk);
        return limb;
    }
    const bool open = kind == Limbs::open;
    const double root = thick * r.uniform(1.0, 1.5), tip = thick * r.uniform(0.6, 1.2);
    const RibbonEnds ends{Cap::flat, r.chance(0.7) ? Cap::round : Cap::flat, true, open && r.chance(0.5)};
    const int limb = b.limb(Label::limb, line, {root, thick, tip}, depth, ends);
    if (joined || open) b.merge(limb, trunk);
    if (kind == Limbs::ribbons && r.chance(0.35)) {
        const int hand =
            b.continued(b.region(Label::limb, ellipse(line.back(), 1.5 * thick, 1.2 * thick), depth + 0.1));
        if (r.chance(0.6)) b.merge(hand, limb);
    }
    return limb;
}

Point2d outwards(double angle, int side) { return {side * math::sin(angle), math::cos(angle)}; }

namespace {

// Elbow and hand of an arm in one of the usual ways to hold it.
Path arm_line(Random& r, Point2d shoulder, double l, int way, int side, double turn) {
    double up = 0, low = 0;
    switch (way) {
    case 0: // hanging
        up = 0.25, low = 0.15;
        break;
    case 1: // out
        up = low = 1.5;
        break;
    case 2: // raised
        up = low = 2.4;
        break;
    case 3: // akimbo
        up = 1.0, low = -0.8;
        break;
    case 4: // waving
        up = 1.4, low = 2.8;
        break;
    case 5: // before the body
        up = 0.4, low = -1.3;
        break;
    case 6: // straight up
        up = 2.8, low = 3.0;
        break;
    default:
        up = low = 0.8;
    }
    const Point2d elbow = shoulder + (0.5 * l) * outwards(up + turn, side);
    return {shoulder, elbow, elbow + (0.5 * l) * outwards(low + turn + r.uniform(-0.15, 0.15), side)};
}

} // namespace

Point2d add_arms(Builder& b, const Body& s, int trunk) {
    Random& r = b.random;
    const int ways[2] = {r.integer(0, 7), r.integer(0, 7)};
    const bool same = r.chance(0.6);
    const double turn = r.uniform(-0.3, 0.3), y = s.top + r.uniform(0.05, 0.35) * s.length;
    const bool joined = r.chance(0.5);
    Point2d hand{};
    for (int i = 0; i < 2; ++i) {
        const int side = i == 0 ? -1 : 1, way = same ? ways[0] : ways[i];
        const double x = s.trunk == Trunk::dress ? 0.3 * s.w : 0.75 * s.w;
        const Path line = arm_line(r, {side * x, y}, b.jitter(s.arm, 0.1), way, side, turn);
        add_limb(b, trunk, line, s.thick, s.arms, way == 5 || way == 3 ? 2.0 : -1.0, joined);
        hand = line.back();
    }
    return hand;
}

void add_legs(Builder& b, const Body& s, int trunk) {
    Random& r = b.random;
    const int way = r.integer(0, 8);
    const bool joined = r.chance(0.5), feet = r.chance(0.5);
    const double spread = way <= 2   ? r.uniform(0.0, 0.2)
                          : way == 3 ? r.uniform(0.4, 0.9)
                                     : r.uniform(0.1, 0.4);
    for (int side = -1; side <= 1; side += 2) {
        const double x = s.trunk == Trunk::line ? 0 : r.uniform(0.3, 0.6) * s.w;
        const Point2d hip{side * x, s.bottom() - (s.trunk == Trunk::line ? 0 : 0.08 * s.length)};
        double knee_turn = spread, shin = spread + r.uniform(-0.15, 0.1);
        if (way == 5) knee_turn = r.uniform(0.8, 1.3), shin = r.uniform(-0.4, 0.1); // squatting
        if (way == 7) knee_turn = 1.3, shin = -1.4;                                 // cross-legged
        if (way == 8 && side > 0) knee_turn = r.uniform(0.7, 1.3), shin = -1.2;     // on one leg
        if (way == 6) knee_turn = side * 0.5, shin = side * (side > 0 ? 0.1 : 1.2); // running
        const Point2d knee = hip + (0.5 * s.leg) * outwards(knee_turn, side),
                      foot = knee + (0.5 * s.leg) * outwards(shin, side);
        add_limb(b, trunk, {hip, knee, foot}, 1.15 * s.thick, s.legs, s.trunk == Trunk::dress ? -1 : -0.6,
                 joined);
        if (!feet) continue;
        if (s.legs == Limbs::lines)
            b.continued(b.stick(
                Label::limb, {foot, foot + Point2d{side * r.uniform(2.0, 6.0), r.uniform(-0.5, 1.0)}}, -0.6));
        else
            b.continued(b.region(
                Label::limb, ellipse(foot + Point2d{side * 0.8 * s.thick, 0}, 1.8 * s.thick, s.thick), -0.4));
    }
}

// --- things in the hand: small ones are labelled with the limb, a balloon on its string is paper

void add_held(Builder& b, Point2d hand) {
    Random& r = b.random;
    const double side = hand.x < 0 ? -1 : 1;
    switch (r.integer(0, 5)) {
    case 0: { // a balloon
        const Point2d c = hand + Point2d{side * r.uniform(0.0, 8.0), -r.uniform(18, 34)};
        const double size = r.uniform(5, 10);
        b.mark(-1, spline({hand, mix(hand, c, 0.5) + Point2d{2, 0}, c + Point2d{0, size}}, false), false,
               0.8);
        b.mark(-1, ellipse(c, size, 1.15 * size), true);
        break;
    }
    case 1: // a sword or a stick
        b.continued(b.stick(
            Label::limb,
            {hand - Point2d{side * 2, -3}, hand + Point2d{side * r.uniform(4.0, 16.0), -r.uniform(8, 22)}}, 2,
            2.0));
        if (r.chance(0.5))
            b.continued(b.stick(Label::limb, {hand + Point2d{-2, -3}, hand + Point2d{3, 0}}, 2, 2.0));
        break;
    case 2: { // a ball
        const double size = r.uniform(3, 6);
        b.continued(
            b.region(Label::limb, ellipse(hand + Point2d{side * 2, 2}, size, size * r.uniform(0.8, 1.2)), 2));
        break;
    }
    case 3: { // a flag
        const Point2d top = hand - Point2d{0, r.uniform(16, 26)};
        b.mark(-1, {hand + Point2d{0, 4}, top});
        b.mark(-1, {top, top + Point2d{side * 12, 3}, top + Point2d{0, 8}});
        break;
    }
    case 4: { // an umbrella
        const Point2d top = hand - Point2d{0, r.uniform(14, 24)};
        const double w = r.uniform(9, 16);
        b.mark(-1, {hand, top});
        b.mark(-1, spline({top + Point2d{-w, 4}, top + Point2d{-0.6 * w, -4}, top + Point2d{0, -6},
                           top + Point2d{0.6 * w, -4}, top + Point2d{w, 4}},
                          false));
        b.mark(-1, {top + Point2d{-w, 4}, top + Point2d{w, 4}});
        break;
    }
    default: { // a bag
        const double w = r.uniform(3, 6);
        b.continued(b.region(
            Label::limb,
            {hand + Point2d{-w, 4}, hand + Point2d{w, 4}, hand + Point2d{w, 11}, hand + Point2d{-w, 11}}, 2));
        b.continued(b.stick(Label::limb, {hand + Point2d{-w, 4}, hand, hand + Point2d{w, 4}}, 2, 1.5));
    }
    }
}

// --- ears and tails

void add_side_ears(Builder& b, const Body& s, int head, double from, double to, bool pointed) {
    Random& r = b.random;
    const double angle = r.uniform(from, to), size = s.hx * r.uniform(0.25, 0.6);
    for (int side = -1; side <= 1; side += 2) {
        const Point2d d{side * math::cos(angle), -math::sin(angle)}, c{1.1 * s.hx * d.x, 1.1 * s.hy * d.y};
        int ear = 0;
        if (pointed) {
            const Point2d across{-d.y, d.x};
            ear = b.region(Label::head,
                           {c - (0.6 * size) * across - (0.6 * size) * d, c + (1.3 * size) * d,
                            c + (0.6 * size) * across - (0.6 * size) * d},
                           0.5);
        } else {
            const double high = size * r.uniform(0.8, 1.2);
            ear = b.region(Label::head, ellipse(c, size, high), r.chance(0.8) ? -0.5 : 1.2);
        }
        if (r.chance(0.5)) b.merge(ear, head);
        if (!pointed && r.chance(0.3)) b.mark(ear, ellipse(c, 0.5 * size, 0.5 * size), true);
    }
}

void add_long_tail(Builder& b, Point2d root, double side, double l, double thick) {
    Random& r = b.random;
    const double rise = r.uniform(-0.4, 0.9);
    Path line;
    switch (r.integer(0, 3)) {
    case 0: {
        const double turns = -side * r.uniform(0.4, 1.1);
        line = curl(root, side > 0 ? -rise : pi + rise, l, turns, r.uniform(0.0, 1.5));
        break;
    }
    case 1: // up in a bow
        line = {root, root + Point2d{side * 0.5 * l, 0.12 * l}, root + Point2d{side * 0.75 * l, -0.25 * l},
                root + Point2d{side * 0.7 * l, -0.7 * l}};
        break;
    case 2: // wavy
        line = {root, root + Point2d{side * 0.3 * l, 0.15 * l}, root + Point2d{side * 0.55 * l, -0.1 * l},
                root + Point2d{side * 0.9 * l, r.uniform(-0.3, 0.2) * l}};
        break;
    default:
        line = {root, root + Point2d{side * 0.5 * l, r.uniform(-0.2, 0.2) * l},
                root + Point2d{side * l, -0.3 * l}};
    }
    if (thick <= 0) {
        b.stick(Label::tail, line.size() > 10 ? line : spline(line, false), -2);
        return;
    }
    const Path middle = line.size() > 10 ? resample(line, 6.0) : line;
    const double tip = thick * r.uniform(0.5, 1.5);
    const bool open = r.chance(0.15);
    b.limb(Label::tail, middle, {0.7 * thick, thick, tip}, -2, {Cap::flat, Cap::round, true, open});
}

} // namespace pantin::doodle::upright
