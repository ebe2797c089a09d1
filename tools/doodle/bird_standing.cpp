// SPDX-License-Identifier: MIT
// Birds from the side with folded wings, head, body and tail in one outline or of two circles. Units: the
// trunk is about 40 long, its middle the origin, y down, facing right.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/contour.hpp"
#include "doodle/species.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

enum class Beak { wedge, open, lines, bill, hooked, long_wedge };
enum class TailShape { taper, wedge, fork, fan, point, feathers, up };

struct Perched {
    double rx, ry, tilt;     // half axes; how far the front is raised
    double neck, neck_angle; // from the shoulder, above the horizontal
    double head, beak, tail, leg;
    Beak mouth;
    TailShape end;
};

struct Kind {
    const char* name;
    Perched bird;
};

const std::vector<Kind>& kinds() {
    using B = Beak;
    using T = TailShape;
    static const std::vector<Kind> table = {
        {"songbird", {20, 11, 0.3, 0, 0.8, 8, 6, 18, 11, B::wedge, T::taper}},
        {"round bird", {17, 15, 0.2, 0, 0.8, 8, 5, 9, 9, B::wedge, T::wedge}},
        {"slender bird", {22, 8, 0.55, 2, 0.9, 6, 6, 23, 12, B::wedge, T::taper}},
        {"upright bird", {20, 10, 0.95, 2, 1.2, 8, 6, 16, 8, B::hooked, T::taper}},
        {"crested bird", {20, 11, 0.4, 1, 0.9, 8, 6, 15, 10, B::wedge, T::wedge}},
        {"pigeon", {21, 12, 0.3, 5, 1.1, 6, 4, 12, 9, B::wedge, T::wedge}},
        {"chick", {13, 12, 0.1, 1, 1.0, 10, 4, 3, 7, B::wedge, T::point}},
        {"swimming duck", {22, 11, 0.05, 7, 1.2, 7, 7, 7, 0, B::bill, T::up}},
        {"line swan", {24, 10, 0.0, 26, 1.35, 5, 6, 8, 0, B::bill, T::up}},
        {"heron", {17, 8, 0.35, 22, 1.2, 4.5, 12, 8, 30, B::long_wedge, T::taper}},
        {"parrot", {22, 9, 1.1, 0, 1.3, 9, 6, 26, 5, B::hooked, T::taper}},
        {"toucan", {20, 11, 0.7, 1, 1.1, 8, 17, 14, 6, B::bill, T::wedge}},
        {"rooster", {18, 13, 0.2, 8, 1.1, 6.5, 5, 16, 13, B::wedge, T::fan}},
        {"turkey", {17, 14, 0.2, 6, 1.1, 6, 5, 20, 12, B::wedge, T::fan}},
        {"ostrich", {17, 12, 0.1, 28, 1.3, 5, 6, 9, 32, B::wedge, T::feathers}},
        {"wingless bird", {20, 12, 0.3, 1, 0.9, 8, 6, 12, 10, B::wedge, T::taper}},
    };
    return table;
}

Perched vary(Builder& b, Perched p) {
    Random& r = b.random;
    for (double* value : {&p.rx, &p.ry, &p.neck, &p.head, &p.beak, &p.tail, &p.leg})
        *value = b.jitter(*value, 0.3);
    p.tilt += r.uniform(-0.2, 0.25), p.neck_angle += r.uniform(-0.25, 0.25);
    if (r.chance(0.3)) p.head *= r.uniform(0.7, 1.0); // small heads
    if (r.chance(0.2))
        p.mouth = r.pick(std::vector<Beak>{Beak::wedge, Beak::open, Beak::lines, Beak::hooked});
    if (p.mouth == Beak::wedge && r.chance(0.3)) p.mouth = r.chance(0.5) ? Beak::open : Beak::lines;
    if (p.end != TailShape::fan && r.chance(0.35))
        p.end = r.pick(std::vector<TailShape>{TailShape::taper, TailShape::wedge, TailShape::fork,
                                              TailShape::point, TailShape::feathers});
    if (r.chance(0.12)) p.leg *= r.uniform(1.3, 2.0);
    return p;
}

// The places of one bird that its outline is made of.
struct Layout {
    const Perched& p;
    Point2d head, up; // middle of the head; the neck's direction at it
    double gaze;      // angle of the beak
    double egg = 0.0; // how much thinner the rear is than the breast
    Point2d on(double angle) const {
        const double c = math::cos(angle), thick = (1.0 + egg * c) / (1.0 + 0.4 * egg);
        return rotated({p.rx * c, thick * p.ry * math::sin(angle)}, -p.tilt);
    }
    Point2d at_head(double angle) const { return head + p.head * direction(angle); }
    Point2d root() const { return on(pi); }
};

Layout lay_out(Random& r, const Perched& p) {
    Layout l{p, {}, direction(-p.neck_angle), r.uniform(-0.25, 0.3)};
    if (!r.chance(0.25)) l.egg = r.uniform(0.15, 0.6);
    const Point2d shoulder = l.on(-0.55);
    l.head = shoulder + (p.neck + r.uniform(-0.1, 0.35) * p.head) * l.up;
    return l;
}

// From the upper root of the beak to the lower one, both on the head's circle.
void trace_beak(Random& r, Contour& c, const Layout& l, double half) {
    const double a = l.gaze, len = l.p.head + l.p.beak;
    const Point2d upper = l.at_head(a - half), lower = l.at_head(a + half),
                  tip = l.head + len * direction(a + r.uniform(-0.1, 0.1));
    switch (l.p.mouth) {
    case Beak::open: {
        const double gape = r.uniform(0.12, 0.3);
        c.to(l.head + len * direction(a - gape))
            .to(l.at_head(a))
            .to(l.head + (0.95 * len) * direction(a + gape));
        break;
    }
    case Beak::bill: {
        const Point2d along = direction(a), side{-along.y, along.x};
        const double w = r.uniform(0.15, 0.3) * l.p.head;
        c.through({mix(upper, tip, 0.5) + (0.2 * w) * side, tip - w * side, tip + (0.5 * w) * along,
                   tip + w * side, mix(lower, tip, 0.4)});
        break;
    }
    case Beak::hooked: {
        const Point2d down = l.head + (0.75 * len) * direction(a + r.uniform(0.3, 0.6));
        c.through({mix(upper, tip, 0.6), tip + Point2d{0, 0.1 * len}, down});
        break;
    }
    default:
        c.to(tip);
    }
    c.to(lower);
}

// From the lower root of the tail to the upper one.
void trace_tail(Random& r, Contour& c, const Layout& l, Point2d along, Point2d upper, Point2d lower) {
    const Point2d side{along.y, -along.x}; // upwards, for a tail to the left
    const Point2d s = dot(side, upper - lower) > 0 ? side : -1.0 * side;
    const double len = l.p.tail, w = 0.5 * distance(upper, lower) * r.uniform(0.4, 1.3);
    const Point2d end = mix(upper, lower, 0.5) + len * along;
    switch (l.p.end) {
    case TailShape::fork:
        c.to(end - w * s)
            .to(end - (r.uniform(0.2, 0.5) * len) * along)
            .to(end + (r.uniform(0.8, 1.6) * w) * s);
        break;
    case TailShape::point:
        c.to(end + r.uniform(-0.5, 0.5) * w * s);
        break;
    case TailShape::feathers:
        for (int i = 0, n = r.integer(2, 4); i < n; ++i) {
            const double v = -1.2 + 2.4 * i / (n - 1);
            c.to(end + (v * w) * s + (r.uniform(-0.1, 0.15) * len) * along);
            if (i + 1 < n) c.to(end + ((v + 1.2 / (n - 1)) * w) * s - (r.uniform(0.3, 0.5) * len) * along);
        }
        break;
    case TailShape::up:
        c.through({mix(lower, end, 0.6) - (0.3 * w) * s, end + (1.2 * w) * s})
            .through({mix(upper, end, 0.4), upper});
        break;
    case TailShape::wedge:
        c.to(end - (r.uniform(0.6, 1.5) * w) * s).to(end + (r.uniform(0.6, 1.5) * w) * s);
        break;
    default:
        c.to(end - (0.35 * w) * s).to(end + (0.35 * w) * s);
    }
}

// One outline from the tail over back, head and belly; returns the trunk with head and tail as its pieces.
int add_flowing_bird(Builder& b, const Layout& l, bool with_tail) {
    Random& r = b.random;
    const Perched& p = l.p;
    const bool necked = p.neck > 1.1 * p.head;
    const double half = r.uniform(0.25, 0.55), w = necked ? r.uniform(0.45, 0.8) * p.head : 0;
    const Point2d side{-l.up.y, l.up.x}, neck_middle = mix(l.on(-0.55), l.head, 0.5); // side: forwards
    const double sway = r.uniform(-0.3, 0.2) * p.neck;
    const Point2d upper = l.on(pi + r.uniform(0.2, 0.45)), lower = l.on(pi - r.uniform(0.3, 0.6));
    const double way_of_tail = r.uniform(-0.25, p.end == TailShape::up ? 0.9 : 0.25);
    const Point2d along = unit(rotated(l.root(), way_of_tail)), across{-along.y, along.x};
    // Back and belly run on into the tail, or the tail begins with corners.
    const bool smooth = with_tail && p.end == TailShape::taper && r.chance(0.7);
    const double thin = r.uniform(0.06, 0.2) * p.ry;
    const Point2d end = mix(upper, lower, 0.5) + p.tail * along;
    Contour c;
    c.to(smooth ? end + thin * across : upper);
    Path back = outside({l.on(pi + 0.9), l.on(pi + 1.45), l.on(-1.15)}, l.head, 1.35 * p.head);
    if (smooth) back.insert(back.begin(), {mix(end, upper, 0.5), upper});
    if (necked) back.push_back(neck_middle + (sway - w) * side);
    for (double a : {pi + 0.25, pi + 0.85, pi + 1.45, -1.1})
        if (a < 2 * pi + l.gaze - half - 0.3 && (a > 0 || a < l.gaze - half - 0.3))
            back.push_back(l.at_head(a));
    back.push_back(l.at_head(l.gaze - half));
    c.through(back);
    trace_beak(r, c, l, half);
    Path belly;
    if (l.gaze + half < 1.0) belly.push_back(l.at_head(1.1));
    if (necked) belly.push_back(neck_middle + (sway + w) * side);
    for (Point2d q :
         outside({l.on(-0.15), l.on(0.5), l.on(1.1), l.on(1.7), l.on(2.25)}, l.head, 1.25 * p.head))
        belly.push_back(q);
    belly.push_back(lower);
    if (smooth) belly.insert(belly.end(), {mix(lower, end, 0.5), end - thin * across});
    c.through(belly);
    if (with_tail && !smooth) trace_tail(r, c, l, along, upper, lower);
    const int trunk = b.region(Label::body, c.points, 0);
    const Point2d towards = unit(l.up + 0.6 * direction(l.gaze));
    const double start = necked ? r.uniform(0.6, 1.0) : r.uniform(0.25, 0.85);
    b.piece(trunk, Label::head,
            beyond(l.head - (start * p.head) * towards, towards, 1.3 * p.head + p.beak, 60));
    if (with_tail)
        b.piece(
            trunk, Label::tail,
            beyond(mix(upper, lower, 0.5) + (r.uniform(-0.1, 0.15) * p.tail) * along, along, 2 * p.ry, 90));
    // Now and then a line at the neck all the same.
    if (r.chance(0.12)) {
        const Point2d n = l.head - (start * p.head) * towards, across{-towards.y, towards.x};
        b.mark(trunk, {n - (1.2 * p.head) * across, n + (1.2 * p.head) * across});
    }
    return trunk;
}

// Of two circles and triangles; returns the trunk.
int add_round_bird(Builder& b, const Layout& l, bool with_tail) {
    Random& r = b.random;
    const Perched& p = l.p;
    const int trunk = b.region(Label::body, ellipse({0, 0}, p.rx, p.ry, -p.tilt), 0);
    const double head_height = p.head * r.uniform(0.85, 1.1);
    const int head = b.region(Label::head, ellipse(l.head, p.head, head_height), r.chance(0.7) ? 1 : -0.1);
    if (distance(l.head, l.on(-0.55)) > 1.1 * p.head) {
        const double w = r.uniform(0.2, 0.5) * p.head;
        const int neck =
            b.limb(Label::body, {l.on(-0.55) - (0.3 * p.ry) * l.up, l.head - (0.9 * p.head) * l.up},
                   {1.3 * w, w}, 0, {Cap::flat, Cap::flat, true, true});
        b.merge(neck, trunk);
    } else if (r.chance(0.35)) {
        b.merge(head, trunk);
    }
    Contour c;
    c.to(l.at_head(l.gaze - r.uniform(0.25, 0.5)));
    trace_beak(r, c, l, r.uniform(0.25, 0.5));
    const int beak = b.region(Label::head, c.points, 1.1);
    if (r.chance(0.5)) b.merge(beak, head);
    if (!with_tail) return trunk;
    const Point2d along = unit(rotated(l.root(), r.uniform(-0.3, 0.4)));
    Contour t;
    const Point2d upper = l.on(pi + 0.3), lower = l.on(pi - 0.3);
    t.to(lower);
    trace_tail(r, t, l, along, upper, lower);
    t.to(upper);
    b.attach(b.region(Label::tail, t.points, r.chance(0.7) ? -0.5 : 0.5), trunk);
    return trunk;
}

// A fan of lines or of feathers, behind the bird.
void add_fan(Builder& b, const Layout& l, const std::string& species) {
    Random& r = b.random;
    const Point2d root = 0.8 * l.root();
    const double len = l.p.tail + 6, middle = pi + r.uniform(0.3, 0.9), spread = r.uniform(0.4, 1.0);
    if (species == "turkey" && r.chance(0.7)) {
        Path p = {root};
        const int n = r.integer(3, 7);
        for (int i = 0; i < n; ++i)
            for (int k = 0; k <= 4; ++k) {
                const double a = middle - spread + 2 * spread * (i + k / 4.0) / n;
                p.push_back(root + len * (1 + 0.6 * k / 4.0 * (1 - k / 4.0)) * direction(a));
            }
        const int fan = b.region(Label::tail, p, -1);
        for (int i = 1; i < n && r.chance(0.8); ++i)
            b.mark(fan, {root, root + len * direction(middle - spread + 2 * spread * i / n)});
        return;
    }
    for (int i = 0, n = r.integer(2, 5); i < n; ++i) {
        const double a = middle + spread * (n == 1 ? 0 : -1.0 + 2.0 * i / (n - 1));
        const Point2d tip = root + len * direction(a), droop{-0.25 * len, 0.25 * len};
        const Path line{root, mix(root, tip, 0.6), tip + r.uniform(0.2, 1.0) * droop};
        if (species == "rooster" && r.chance(0.7))
            b.limb(Label::tail, line, {1.5, 3.2, 0.6}, -1 + 0.01 * i);
        else
            b.stick(Label::tail, spline(line, false), -1);
    }
}

void crown(Builder& b, const Layout& l, const std::string& species, int trunk) {
    Random& r = b.random;
    const double h = l.p.head;
    if (species == "rooster" || species == "turkey") {
        const Path comb{l.at_head(-2.4), l.head + (1.6 * h) * direction(-2.2),
                        l.at_head(-1.9), l.head + (1.7 * h) * direction(-1.6),
                        l.at_head(-1.4), l.head + (1.5 * h) * direction(-1.0),
                        l.at_head(-0.8)};
        b.part(b.region(Label::head, comb, -0.2)).paint = 7;
        if (r.chance(0.6))
            b.part(b.region(Label::head,
                            ellipse(l.head + (1.15 * h) * direction(l.gaze + 0.75), 0.22 * h, 0.4 * h), 1.2))
                .paint = 7;
    } else if (species == "crested bird" || r.chance(0.08)) {
        if (r.chance(0.5))
            b.merge(b.region(Label::head,
                             {l.at_head(-2.7), l.head + (2.0 * h) * direction(-2.3), l.at_head(-1.4)}, 0.05),
                    trunk);
        else
            for (int i = 0, n = r.integer(2, 3); i < n; ++i)
                b.stick(Label::head,
                        {l.at_head(-1.7 - 0.2 * i), l.head + (1.7 * h) * direction(-1.8 - 0.3 * i)}, -0.2,
                        1.5);
    }
}

// All above a line from the shoulder to the tail: the wing's other edge is the back.
void add_back_wing(Builder& b, const Layout& l, int trunk) {
    Random& r = b.random;
    const Point2d start = l.on(r.uniform(-1.0, -0.4)), front = 0.6 * l.on(r.uniform(-0.3, 0.6));
    const double depth = r.uniform(0.35, 0.8);
    const Point2d low = depth * l.on(r.uniform(1.9, 2.5)), end = 1.02 * l.on(pi + r.uniform(-0.25, 0.25));
    Outline wing;
    wing.points = r.chance(0.6) ? spline({start, front, low, end}, false) : Path{start, front, end};
    wing.undrawn.assign(wing.points.size(), 0);
    wing.undrawn.back() = 1;
    for (double a : {pi + 0.3, pi + 0.8, pi + 1.3, 2 * pi - 1.3, 2 * pi - 0.9}) {
        wing.points.push_back(1.6 * l.on(a));
        wing.undrawn.push_back(1);
    }
    const int index = b.region(Label::wing, wing, 0.5);
    b.part(index).within = trunk;
    if (!r.chance(0.3)) return;
    for (int i = 0, n = r.integer(3, 8); i < n; ++i) { // feathers
        const Point2d p = mix(mix(start, front, 0.5), end, 0.15 + 0.7 * i / n);
        b.mark(index, {p, p + (r.uniform(0.1, 0.3)) * (end - start)});
    }
}

// Patches filled with scribble, as on a blackbird's or a robin's breast and head.
void add_scribble(Builder& b, const Layout& l, int trunk) {
    Random& r = b.random;
    const bool head = r.chance(0.6);
    const Point2d c = head ? l.head : 0.5 * l.on(r.uniform(0.2, 1.0));
    const double w = head ? 0.75 * l.p.head : r.uniform(0.2, 0.4) * l.p.rx,
                 h = head ? w : r.uniform(0.3, 0.6) * l.p.ry;
    Path zigzag;
    const double turn = r.uniform(0.0, pi);
    for (int i = 0, n = r.integer(6, 14); i <= n; ++i) {
        const double u = -1.0 + 2.0 * i / n, v = std::sqrt(std::max(0.0, 1.0 - u * u)) * (i % 2 ? 1 : -1);
        const Point2d q = rotated({u, v}, turn);
        zigzag.push_back(c + Point2d{w * q.x, h * q.y});
    }
    b.mark(head ? -1 : trunk, zigzag);
}

void add_legs(Builder& b, const Layout& l, int trunk, const std::string& species) {
    Random& r = b.random;
    const int manner = r.integer(0, 4) < 3 ? r.integer(0, 1) : r.integer(2, 3),
              count = r.chance(0.07) ? 1 : 2;
    const double apart = r.uniform(0.1, 0.35), lean = r.uniform(-0.4, 0.3), middle = 0.5 * pi + l.p.tilt;
    double heading = r.chance(0.85) ? r.uniform(-0.1, 0.3) : pi - r.uniform(0.0, 0.3);
    for (int i = 0; i < count; ++i) {
        const double a = middle + (i == 0 ? apart : -apart) + r.uniform(-0.08, 0.08);
        const Point2d hip = 0.93 * l.on(a);
        const double spread = (i == 0 ? -1 : 1) * r.uniform(-0.1, 0.25);
        Point2d foot = hip + b.jitter(l.p.leg, 0.12) * Point2d{lean + spread, 1.0};
        if (species == "heron" && i == 1 && r.chance(0.3))
            foot = mix(hip, foot, 0.5) + Point2d{0.3 * l.p.leg, 0};
        add_line_leg(b, trunk, hip, foot, heading, manner);
    }
}

void add_wing(Builder& b, const Layout& l, int trunk, bool flowing) {
    Random& r = b.random;
    const Perched& p = l.p;
    if (b.figure.species == "wingless bird" || r.chance(0.35)) return;
    if (flowing && p.neck < p.head && r.chance(0.2)) return add_back_wing(b, l, trunk);
    const bool over = r.chance(0.22); // over the back and beyond the trunk
    const double u = over ? r.uniform(-0.75, -0.4) : r.uniform(-0.25, 0.1),
                 v = over ? r.uniform(-0.7, -0.2) : r.uniform(-0.25, 0.25);
    const double w = over ? r.uniform(0.6, 1.1) : r.uniform(0.4, 0.95), h = r.uniform(0.45, 0.85),
                 turn = r.uniform(-0.25, 0.15);
    add_folded_wing(b, {rotated({u * p.rx, v * p.ry}, -p.tilt), w * p.rx, h * p.ry, turn - p.tilt}, 2);
}

} // namespace

std::vector<std::string> perched_species() { return names_of(kinds()); }

Figure build_perched(Random& random, const std::string& species) {
    Builder b(random, "flying", species);
    Perched p = vary(b, row_of(kinds(), species).bird);
    if (species == "swimming duck" && random.chance(0.2)) p.leg = random.uniform(4.0, 9.0); // ashore
    const Layout l = lay_out(random, p);
    const bool fan = p.end == TailShape::fan, flowing = random.chance(0.78);
    const bool tailed = !fan && !random.chance(0.14);
    const int trunk = flowing ? add_flowing_bird(b, l, tailed) : add_round_bird(b, l, tailed);
    if (fan) add_fan(b, l, species);
    if (random.chance(0.85))
        add_eye(b, -1, l.head + (0.3 * p.head) * direction(l.gaze - 0.8),
                random.uniform(0.12, 0.35) * p.head);
    if (p.mouth == Beak::lines)
        b.mark(trunk, {l.at_head(l.gaze), l.head + (p.head + 0.85 * p.beak) * direction(l.gaze)});
    crown(b, l, species, trunk);
    if (p.leg > 1.0 && !random.chance(0.08)) add_legs(b, l, trunk, species);
    add_wing(b, l, trunk, flowing);
    if (random.chance(0.12)) add_scribble(b, l, trunk);
    b.figure.max_tilt = 0.15;
    return std::move(b.figure);
}

} // namespace pantin::doodle
