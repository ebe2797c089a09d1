// SPDX-License-Identifier: MIT
// Four-legged animals from the side as they are sketched: head, neck and trunk in one outline, legs as lines,
// open Us and touching pairs. Units: the trunk is about 60 long, its middle the origin, y down, facing right.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/contour.hpp"
#include "doodle/species.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

enum class Ears { none, pointed, round, floppy, tall };
enum class Tail { line, flowing, bushy, upright, tuft, stub, thick };

struct Walker {
    double rx, ry, leg;
    double neck, neck_angle; // from the withers to the middle of the head
    double head, muzzle;     // radius of the skull, length of the muzzle beyond it
    Ears ears;
    Tail tail;
    double tail_length;
};

struct Kind {
    const char* name;
    Walker animal;
};

const std::vector<Kind>& kinds() {
    using E = Ears;
    using T = Tail;
    static const std::vector<Kind> table = {
        {"quick dog", {30, 9, 22, 7, 0.6, 7, 9, E::pointed, T::line, 18}},
        {"long dog", {34, 8, 14, 6, 0.5, 6, 9, E::floppy, T::flowing, 16}},
        {"quick cat", {27, 9, 17, 6, 0.6, 8, 2, E::pointed, T::line, 32}},
        {"quick horse", {29, 10, 30, 20, 0.9, 7, 12, E::pointed, T::bushy, 24}},
        {"quick cow", {32, 13, 19, 7, 0.3, 8, 8, E::pointed, T::tuft, 22}},
        {"quick pig", {28, 14, 10, 3, 0.1, 9, 5, E::pointed, T::line, 8}},
        {"long giraffe", {20, 9, 36, 46, 1.25, 5, 8, E::pointed, T::tuft, 14}},
        {"llama", {24, 12, 24, 28, 1.4, 6, 6, E::pointed, T::stub, 7}},
        {"humped camel", {28, 10, 26, 20, 0.8, 6, 8, E::round, T::tuft, 14}},
        {"trunked elephant", {28, 18, 16, 3, 0.2, 12, 4, E::floppy, T::line, 12}},
        {"rhinoceros", {32, 15, 14, 5, 0.0, 9, 9, E::pointed, T::line, 10}},
        {"raccoon", {27, 11, 11, 5, 0.4, 8, 5, E::pointed, T::bushy, 28}},
        {"crocodile", {32, 8, 8, 5, 0.0, 6, 20, E::none, T::thick, 32}},
        {"quick mouse", {20, 10, 5, 2, 0.1, 8, 6, E::round, T::line, 34}},
        {"quick rabbit", {18, 11, 6, 3, 0.7, 8, 2, E::tall, T::stub, 6}},
        {"hedgehog", {24, 14, 5, 1, -0.1, 7, 7, E::none, T::stub, 2}},
        {"tortoise", {22, 13, 6, 9, 0.2, 6, 2, E::none, T::stub, 6}},
        {"bear on four", {30, 15, 15, 5, 0.3, 10, 4, E::round, T::stub, 4}},
        {"quick sheep", {26, 14, 11, 4, 0.3, 8, 4, E::floppy, T::stub, 5}},
        {"big cat", {30, 10, 17, 5, 0.5, 10, 3, E::round, T::tuft, 28}},
        {"walking monkey", {19, 10, 14, 6, 0.7, 8, 2, E::round, T::line, 36}},
        {"dragon trunk", {28, 11, 15, 22, 0.9, 7, 8, E::pointed, T::thick, 44}},
        {"walking squirrel", {19, 9, 8, 4, 0.6, 7, 3, E::pointed, T::upright, 34}},
    };
    return table;
}

Walker vary(Builder& b, Walker a) {
    Random& r = b.random;
    for (double* value : {&a.rx, &a.ry, &a.leg, &a.neck, &a.head, &a.muzzle, &a.tail_length})
        *value = b.jitter(*value, 0.32);
    a.neck_angle += r.uniform(-0.35, 0.35);
    if (a.neck < 12 && r.chance(0.15)) a.neck_angle -= r.uniform(0.4, 1.0); // the nose down
    if (r.chance(0.12)) a.ry *= r.uniform(0.5, 0.8);                        // a narrow trunk
    if (r.chance(0.15)) a.leg *= 0.45;                                      // hardly any legs
    if (r.chance(0.1)) a.leg *= 1.5;
    if (r.chance(0.12)) a.head *= 1.35;
    if (r.chance(0.2) && a.tail != Tail::thick && a.tail != Tail::upright)
        a.tail = r.pick(std::vector<Tail>{Tail::line, Tail::flowing, Tail::bushy, Tail::tuft, Tail::stub});
    return a;
}

struct Layout {
    const Walker& a;
    Point2d head, along; // middle of the skull; the way of the muzzle
    double box;          // 0 an ellipse, 1 a rectangle
    Point2d on(double angle) const {
        const double c = math::cos(angle), s = math::sin(angle), m = std::max(std::abs(c), std::abs(s));
        const double k = 1.0 + box * (1.0 / m - 1.0) * 0.8;
        return {a.rx * c * k, a.ry * s * k};
    }
    Point2d at_head(double angle) const { return head + a.head * direction(angle); }
};

Layout lay_out(Random& r, const Walker& a) {
    const Point2d withers{0.8 * a.rx, -0.5 * a.ry};
    Layout l{a, {}, {}, r.chance(0.35) ? r.uniform(0.4, 1.0) : r.uniform(0.0, 0.4)};
    l.head = withers + (a.neck + 0.6 * a.head) * direction(-a.neck_angle);
    l.along = direction(r.uniform(-0.1, 0.6));
    return l;
}

// Crown, ears where the outline goes up to them, muzzle and jaw.
void trace_head(Random& r, Contour& c, const Layout& l) {
    const Walker& a = l.a;
    const double h = a.head, ear = h * r.uniform(0.7, 1.3), way = math::atan2(l.along.y, l.along.x);
    c.to(l.at_head(way - 2.5));
    if (a.ears == Ears::pointed && r.chance(0.75))
        c.to(l.at_head(way - 2.1) + Point2d{r.uniform(-0.3, 0.2) * ear, -ear}).to(l.at_head(way - 1.6));
    const Point2d side{l.along.y, -l.along.x}; // upwards
    const double w = r.uniform(0.3, 0.6) * h;
    const Point2d tip = l.head + (h + a.muzzle) * l.along - (r.uniform(0.0, 0.35) * h) * side;
    if (a.muzzle < 0.45 * h) { // round
        c.through({l.at_head(way - 1.0), l.at_head(way - 0.3), l.at_head(way + 0.5), l.at_head(way + 1.2)});
    } else if (r.chance(0.3)) { // pointed
        c.through({l.at_head(way - 1.1), l.at_head(way - 0.6)}).to(tip).to(l.at_head(way + 1.0));
    } else if (r.chance(0.25) && a.muzzle > 4) { // an open mouth
        c.through({l.at_head(way - 1.1), l.at_head(way - 0.6)}).to(tip + (0.7 * w) * side);
        c.to(l.head + (0.5 * h) * l.along).to(tip - (0.7 * w) * side - (0.15 * a.muzzle) * l.along);
        c.to(l.at_head(way + 1.1));
    } else {
        c.through({l.at_head(way - 1.1), l.at_head(way - 0.55), tip + w * side, tip + (0.5 * w) * l.along,
                   tip - w * side, l.at_head(way + 1.0)});
    }
}

// The line of the back, with the camel's humps.
Path back_line(Random& r, const Layout& l, const std::string& species) {
    if (species == "humped camel") {
        const double up = l.a.ry * r.uniform(0.6, 1.3), y = -0.85 * l.a.ry, x = l.a.rx;
        if (r.chance(0.5)) return {{-0.8 * x, y}, {-0.4 * x, y}, {0, y - up}, {0.4 * x, y}};
        return {
            {-0.8 * x, y}, {-0.4 * x, y - up}, {-0.02 * x, y + 0.1 * up}, {0.38 * x, y - up}, {0.65 * x, y}};
    }
    if (species == "hedgehog") {
        Path spikes;
        const int n = r.integer(6, 16);
        for (int i = 0; i <= n; ++i) {
            const double a = pi + 0.3 + (pi - 0.6) * i / n;
            spikes.push_back(l.on(a));
            if (i < n) spikes.push_back(r.uniform(1.15, 1.4) * l.on(a + 0.5 * (pi - 0.6) / n));
        }
        return spikes;
    }
    const double sag = r.uniform(-0.12, 0.2) * l.a.ry;
    Path line;
    for (double a : {pi + 0.55, pi + 1.1, pi + 1.6, -1.0}) line.push_back(l.on(a) + Point2d{0, sag});
    return line;
}

// Returns the trunk; the head is a piece of it.
int add_flowing_trunk(Builder& b, const Layout& l, const std::string& species) {
    Random& r = b.random;
    const Walker& a = l.a;
    Contour c;
    c.to(l.on(pi - 0.1));
    const Path back = outside(back_line(r, l, species), l.head, 1.3 * a.head);
    const bool spiky = species == "hedgehog";
    const Point2d nape = direction(-a.neck_angle), side{nape.y, -nape.x}; // upwards and back
    const double w = std::max(0.45 * a.head, 0.25 * a.ry);
    if (spiky) {
        for (Point2d p : back) c.to(p);
    } else {
        Path line = back;
        if (a.neck > 1.2 * a.head)
            line.push_back(l.head - (0.5 * a.neck) * nape +
                           w * Point2d{-std::abs(side.x), -std::abs(side.y)});
        line.push_back(l.at_head(math::atan2(l.along.y, l.along.x) - 2.5));
        c.through(line);
    }
    trace_head(r, c, l);
    Path under;
    if (a.neck > 1.2 * a.head)
        under.push_back(l.head - (0.5 * a.neck) * nape + w * Point2d{std::abs(side.x), std::abs(side.y)});
    const double belly = r.uniform(0.75, 1.15);
    for (double t : {0.1, 0.6, 1.1, 1.6, 2.1, 2.6, 3.0}) {
        const Point2d p = l.on(t);
        if (distance(p, l.head) >= 1.1 * a.head) under.push_back({p.x, belly * p.y});
    }
    c.through(under);
    const int trunk = b.region(Label::body, c.points, 0);
    const Point2d towards = unit(nape + 0.5 * l.along);
    b.piece(trunk, Label::head,
            beyond(l.head - (r.uniform(0.45, 0.9) * a.head) * towards, towards, 1.6 * a.head + a.muzzle, 70));
    return trunk;
}

// A circle over the front of the body, with or without a muzzle.
int add_round_head(Builder& b, const Layout& l, int trunk) {
    Random& r = b.random;
    const double h = l.a.head * r.uniform(1.0, 1.3);
    if (l.a.neck > 1.4 * h) {
        const Point2d from{0.75 * l.a.rx, -0.3 * l.a.ry};
        const double w = r.uniform(0.35, 0.6) * h;
        const int neck =
            b.limb(Label::body, {from, l.head}, {1.4 * w, w}, 0, {Cap::flat, Cap::flat, true, true});
        b.merge(neck, trunk);
    }
    const double height = h * r.uniform(0.75, 1.05), droop = r.uniform(0.0, 0.5);
    const int head = b.region(Label::head, ellipse(l.head, h, height, droop), 1);
    if (r.chance(0.25)) b.merge(head, trunk);
    if (l.a.muzzle > 0.5 * l.a.head && r.chance(0.6)) {
        const double w = h * r.uniform(0.35, 0.6);
        const int muzzle =
            b.limb(Label::head, {l.head + (0.5 * h) * l.along, l.head + (h + 0.6 * l.a.muzzle) * l.along},
                   {1.1 * w, w}, 1, {Cap::flat, Cap::round, true, false});
        b.merge(muzzle, head);
        if (r.chance(0.5)) b.merge(muzzle, trunk);
    } else if (r.chance(0.5)) {
        add_frontal_face(b, head, {l.head, h, h, 0});
    }
    return head;
}

void add_ears(Builder& b, const Layout& l, int head) {
    Random& r = b.random;
    const double h = l.a.head, way = math::atan2(l.along.y, l.along.x);
    const int count = r.integer(1, 2);
    for (int i = 0; i < count; ++i) {
        const double angle = way - 1.6 - 0.75 * i;
        const Point2d root = l.at_head(angle), up = direction(angle + r.uniform(-0.4, 0.2));
        const double depth = i == 0 ? 1.3 : -0.3, size = h * r.uniform(0.6, 1.1);
        int ear = -1;
        switch (l.a.ears) {
        case Ears::pointed: {
            const Point2d across{-up.y, up.x};
            ear = b.region(Label::head,
                           {root - (0.4 * size) * across - (0.25 * size) * up, root + size * up,
                            root + (0.4 * size) * across - (0.25 * size) * up},
                           depth);
            break;
        }
        case Ears::round:
            ear = b.region(Label::head, ellipse(root + (0.15 * size) * up, 0.5 * size, 0.5 * size), depth);
            break;
        case Ears::floppy:
            ear = b.limb(
                Label::head,
                {root, root + Point2d{-0.35 * size, 0.3 * size}, root + Point2d{-0.4 * size, 1.3 * size}},
                {0.2 * size, 0.4 * size, 0.3 * size}, 1.3);
            break;
        case Ears::tall:
            ear = b.limb(Label::head, {root - (0.3 * size) * up, root + size * up, root + (2.2 * size) * up},
                         {0.2 * size, 0.32 * size, 0.12 * size}, depth);
            break;
        default:
            return;
        }
        if (r.chance(0.5)) b.merge(ear, head);
    }
}

// --- legs

struct Leg {
    Point2d hip, foot;
};

// Where the feet stand: apart, in touching pairs, two in all, crossed.
std::vector<Leg> place_legs(Random& r, const Walker& a) {
    const double ground = 0.85 * a.ry + a.leg, outer = r.uniform(0.55, 0.88) * a.rx;
    const int layout = r.integer(0, 9);
    const double gap = layout <= 3   ? r.uniform(0.25, 0.6) * a.rx // four apart
                       : layout <= 7 ? r.uniform(0.08, 0.2) * a.rx // pairs
                                     : 0.0;                        // two only
    const bool running = r.chance(0.12), crossed = layout >= 4 && r.chance(0.2);
    const double lean = r.chance(0.5) ? 0.0 : r.uniform(-0.25, 0.25);
    std::vector<Leg> legs;
    for (int end = -1; end <= 1; end += 2)
        for (int k = 0; k < (gap > 0 ? 2 : 1); ++k) {
            const double x = end * (outer - k * gap),
                         step = running ? end * a.leg * r.uniform(0.3, 0.8) : 0.0;
            const double swap = crossed ? (k == 0 ? -1 : 1) * end * gap * 1.5 : 0.0;
            const double lift = std::sqrt(std::max(0.1, 1.0 - (x / a.rx) * (x / a.rx)));
            legs.push_back({{x, 0.7 * a.ry * lift},
                            {x + step + swap + (lean + r.uniform(-0.1, 0.1)) * a.leg,
                             ground - (running ? r.uniform(0.1, 0.35) : r.uniform(-0.06, 0.06)) * a.leg}});
        }
    return legs;
}

Walker flat(Walker a) {
    a.ry = 0.5;
    return a;
}

void add_legs(Builder& b, const Walker& a, int trunk, bool lines) {
    Random& r = b.random;
    std::vector<Leg> legs = place_legs(r, a);
    if (r.chance(0.06)) legs.resize(legs.size() - 1); // forgotten
    const int manner =
        lines ? 0 : r.integer(0, 9); // 0…3 lines, 4…7 open Us, 8 ribbons, 9 boxes with a line between
    const double w = std::max(1.6, a.rx * r.uniform(0.05, 0.12)), taper = r.uniform(0.6, 1.1);
    const bool bent = r.chance(0.3), open = r.chance(0.25), foot = r.chance(0.35), pairs = r.chance(0.85);
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const Point2d hip = legs[i].hip, toe = legs[i].foot,
                      knee = mix(hip, toe, 0.5) + Point2d{bent ? (toe.x < 0 ? -0.15 : 0.12) * a.leg : 0.0, 0};
        if (manner <= 3) {
            b.stick(Label::limb, bent ? Path{hip, knee, toe} : Path{hip, toe}, -1);
            if (foot)
                b.continued(b.stick(Label::limb,
                                    {toe, toe + Point2d{r.uniform(2.0, 5.0), r.uniform(-0.5, 0.5)}}, -1));
            continue;
        }
        const double depth = i % 2 ? -1.0 : -0.5, wide = w * (manner == 8 ? 1.3 : 1.0);
        const double thigh = wide * r.uniform(1.0, 1.7);
        const Cap end = r.chance(0.5) ? Cap::round : Cap::flat;
        const int leg = b.limb(Label::limb, {hip, knee, toe}, {thigh, wide, wide * taper}, depth,
                               {Cap::flat, end, true, open});
        if (pairs) b.merge(leg, trunk); // its lines run into the belly's
        if (foot && !open && r.chance(0.8)) {
            const int paw = b.continued(b.region(
                Label::limb, ellipse(toe + Point2d{0.8 * wide, 0}, 1.6 * wide, 0.9 * wide), depth + 0.1));
            b.merge(paw, leg);
        }
        if (manner == 9 && i % 2 == 1) b.merge(leg, leg - 1);
    }
}

// --- tails

void add_tail(Builder& b, const Walker& a, int trunk) {
    Random& r = b.random;
    const Point2d root{-0.95 * a.rx, -0.3 * a.ry};
    const double l = a.tail_length, rise = r.chance(0.7) ? r.uniform(-0.3, 1.3) : r.uniform(-1.2, -0.3);
    const Point2d way = direction(pi + rise), side{way.y, -way.x};
    const double bend = r.uniform(-0.35, 0.35) * l;
    const Path line{root + Point2d{0.06 * a.rx, 0}, root + (0.5 * l) * way + bend * side,
                    root + l * way + (r.uniform(-0.5, 0.5) * bend) * side};
    switch (a.tail) {
    case Tail::line:
    case Tail::tuft:
        b.stick(Label::tail, r.chance(0.3) ? Path{line[0], line[2]} : spline(line, false), -1);
        if (a.tail == Tail::tuft) b.region(Label::tail, ellipse(line[2], 2.5, 1.6, pi + rise), -0.9);
        return;
    case Tail::flowing:
    case Tail::bushy: {
        const double w = a.tail == Tail::bushy ? r.uniform(0.1, 0.22) * l : r.uniform(0.05, 0.1) * l;
        const double tip = r.uniform(0.3, 1.0) * w;
        const Cap end = r.chance(0.6) ? Cap::pointed : Cap::round;
        const int tail =
            b.limb(Label::tail, line, {std::max(1.2, 0.7 * w), w, tip}, -0.5, {Cap::round, end, true, false});
        if (r.chance(0.75)) b.merge(tail, trunk);
        for (int i = 1; i < 5 && a.tail == Tail::bushy && r.chance(0.25); ++i)
            b.mark(tail, {mix(root, line[2], 0.2 * i) - (2 * w) * side,
                          mix(root, line[2], 0.2 * i) + (2 * w) * side});
        return;
    }
    case Tail::upright: {
        const double w = r.uniform(0.15, 0.26) * l;
        const Path up{root + Point2d{2, 0.3 * a.ry}, root + Point2d{-0.35 * l, -0.1 * l},
                      root + Point2d{-0.35 * l, -0.75 * l}, root + Point2d{-0.05 * l, -0.95 * l}};
        const int tail = b.limb(Label::tail, up, {0.5 * w, w, 1.2 * w, 0.5 * w}, -0.5);
        if (r.chance(0.6)) b.merge(tail, trunk);
        return;
    }
    case Tail::thick: {
        const Path low{
            {-0.7 * a.rx, 0}, {-a.rx - 0.4 * l, 0.15 * a.ry}, {-a.rx - l, r.uniform(-0.2, 0.15) * l}};
        const int tail = b.limb(Label::tail, low, {0.8 * a.ry, 0.45 * a.ry, 0.5}, -0.2,
                                {Cap::flat, Cap::pointed, true, false});
        b.merge(tail, trunk);
        return;
    }
    case Tail::stub: {
        if (l < 3.0) return;
        const double size = std::min(l, 7.0);
        const Path ball = ellipse(root - Point2d{0.3 * size, 0}, 0.6 * size, 0.5 * size);
        b.attach(b.region(Label::tail, ball, r.chance(0.6) ? -0.5 : 0.5), trunk);
        return;
    }
    }
}

void add_trunk_and_tusks(Builder& b, const Layout& l, int trunk) {
    Random& r = b.random;
    const double h = l.a.head, reach = l.a.ry + l.a.leg * r.uniform(0.2, 0.8);
    const Point2d root = l.head + Point2d{0.8 * h, 0.1 * h};
    const double out = r.uniform(0.2, 1.2) * h, end = r.chance(0.3) ? 0.3 * reach : reach;
    const int nose = b.limb(Label::head,
                            {root - Point2d{0.3 * h, 0}, root + Point2d{0.3 * h + 0.5 * out, 0.4 * reach},
                             root + Point2d{out, end}},
                            {0.35 * h, 0.28 * h, 0.2 * h}, 0.2);
    b.merge(nose, trunk);
    if (r.chance(0.4))
        b.stick(Label::head, {l.head + Point2d{0.7 * h, 0.5 * h}, l.head + Point2d{1.4 * h, 0.9 * h}}, 1,
                1.5);
}

// Of a hedgehog: short lines in its coat, long ones across its back.
void add_spines(Builder& b, const Layout& l, int trunk) {
    Random& r = b.random;
    const bool crossing = r.chance(0.4);
    for (int i = 0, n = r.integer(3, 14); i < n; ++i) {
        const double u = r.uniform(-0.75, 0.35), v = r.uniform(-0.6, 0.3);
        const Point2d p{u * l.a.rx, v * l.a.ry}, by{r.uniform(-4.0, -1.0), r.uniform(-5.0, -2.0)};
        if (crossing) {
            const Point2d root = 0.7 * l.on(pi + 0.5 + 1.9 * i / n), out = (r.uniform(0.6, 1.1)) * root;
            b.stick(Label::body, {root, root + out + by}, 0.3, 1.2);
        } else {
            b.mark(trunk, {p, p + by});
        }
    }
}

void finish(Builder& b, const Layout& l, int trunk, const std::string& species) {
    Random& r = b.random;
    const Frame frame{{0, 0}, l.a.rx, l.a.ry, 0};
    if (species == "rhinoceros")
        b.region(Label::head,
                 {l.head + (1.2 * l.a.head) * l.along - Point2d{0, 2},
                  l.head + (1.3 * l.a.head + l.a.muzzle * 0.5) * l.along - Point2d{0, r.uniform(6.0, 14.0)},
                  l.head + (1.0 * l.a.head + l.a.muzzle) * l.along},
                 -0.1);
    if (species == "trunked elephant") add_trunk_and_tusks(b, l, trunk);
    if (species == "tortoise" && r.chance(0.7)) { // the shell's edge and plates
        b.mark(trunk, {{-1.1 * l.a.rx, 0.35 * l.a.ry}, {1.0 * l.a.rx, 0.35 * l.a.ry}});
        for (int i = -1; i <= 1; ++i)
            b.mark(trunk, {{0.35 * i * l.a.rx, -0.9 * l.a.ry}, {0.5 * i * l.a.rx, 0.35 * l.a.ry}});
    }
    if (species == "hedgehog") add_spines(b, l, trunk);
    if (r.chance(0.15)) add_pattern(b, trunk, frame);
    if (species == "crocodile" && r.chance(0.5)) { // scales
        Path zigzag;
        for (int i = 0, n = r.integer(6, 14); i <= n; ++i)
            zigzag.push_back({(-0.9 + 1.6 * i / n) * l.a.rx, (i % 2 ? -1.3 : -0.9) * l.a.ry});
        b.stick(Label::body, zigzag, -0.1, 1.2);
    }
}

} // namespace

std::vector<std::string> walker_species() {
    std::vector<std::string> names;
    for (const Kind& kind : kinds())
        if (kind.name != std::string("dragon trunk")) names.push_back(kind.name);
    return names;
}

Figure build_walker(Random& random, const std::string& species) {
    Builder b(random, "quadruped", species);
    const Walker a = vary(b, row_of(kinds(), species).animal);
    const Layout l = lay_out(random, a);
    const bool special = species == "hedgehog" || species == "humped camel" || species == "crocodile";
    const bool flowing = special || random.chance(0.7), line = !special && random.chance(0.06);
    int trunk = 0, head = 0;
    if (line) {
        trunk = b.stick(Label::body, {{-0.95 * a.rx, 0}, {0, random.uniform(-2.0, 2.0)}, {0.9 * a.rx, 0}});
        b.stick(Label::body, {{0.85 * a.rx, 0}, l.head}, 0.1);
        head = b.region(Label::head, ellipse(l.head, a.head, 0.9 * a.head), 1);
        add_frontal_face(b, head, {l.head, a.head, a.head, 0});
    } else if (flowing) {
        head = trunk = add_flowing_trunk(b, l, species);
        if (random.chance(0.8))
            add_eye(b, -1, l.head + (0.3 * a.head) * l.along - Point2d{0, 0.25 * a.head},
                    random.uniform(0.15, 0.3) * a.head);
    } else {
        const Path trunk_line = random.chance(0.5) ? ellipse({0, 0}, a.rx, a.ry)
                                                   : ellipse({0, 0}, a.rx, a.ry, 0, random.uniform(2.5, 7.0));
        trunk = species == "quick sheep"
                    ? b.region(Label::body,
                               fluffy(random, {{0, 0}, 0.95 * a.rx, 0.9 * a.ry, 0}, random.integer(8, 15)), 0)
                    : b.region(Label::body, trunk_line, 0);
        head = add_round_head(b, l, trunk);
    }
    if (!flowing || a.ears != Ears::pointed || random.chance(0.3)) add_ears(b, l, head);
    const Walker rear = line ? flat(a) : a;
    if (!random.chance(0.2)) add_tail(b, rear, trunk);
    add_legs(b, rear, trunk, line);
    if (!line) finish(b, l, trunk, species);
    return std::move(b.figure);
}

} // namespace pantin::doodle
