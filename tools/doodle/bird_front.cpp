// SPDX-License-Identifier: MIT
// What flies, from the front or with wings raised: sketched birds, owls, penguins, bats, fairies, dragons.
// Units: the trunk is about 40 long, its middle the origin, y down.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/contour.hpp"
#include "doodle/species.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

// A wing at a side: root of `width` at `at`, to the tip; smooth, with fingers, or scalloped.
int add_side_wing(Builder& b, Point2d at, double width, Point2d tip, int edge, double depth) {
    Random& r = b.random;
    const Point2d lower = at + Point2d{0, width}, along = tip - at;
    const Point2d lift{0.15 * along.y, -0.15 * std::abs(along.x)};
    Contour c;
    c.to(at).through({mix(at, tip, 0.5) + r.uniform(0.2, 1.2) * lift, tip});
    if (edge == 0) {
        c.through({mix(tip, lower, 0.5) + Point2d{0, r.uniform(-0.1, 0.3) * width}, lower});
    } else {
        const int n = r.integer(3, 5);
        const double bow = edge == 1 ? r.uniform(0.25, 0.6) : -r.uniform(0.3, 0.7);
        for (int i = 0; i < n; ++i) {
            const Point2d p = mix(tip, lower, static_cast<double>(i) / n), q = mix(tip, lower, (i + 1.0) / n);
            c.through({mix(p, q, 0.5) + Point2d{0, bow * distance(p, q)}, q});
        }
    }
    const int wing = b.region(Label::wing, c.points, depth);
    if (r.chance(0.2))
        for (int i = 1; i < 4; ++i) b.mark(wing, {mix(at, tip, 0.25 * i), mix(lower, tip, 0.2 * i)});
    return wing;
}

struct Sides { // both wings alike
    double x, y, width, reach, rise;
    int edge;
    double depth;
};

void add_wings(Builder& b, int trunk, const Sides& s) {
    for (int side = -1; side <= 1; side += 2) {
        const Point2d tip{side * (s.x + b.jitter(s.reach, 0.08)), s.y - b.jitter(s.rise, 0.1)};
        const int wing = add_side_wing(b, {side * s.x, s.y}, s.width, tip, s.edge, s.depth);
        if (trunk >= 0) b.attach(wing, trunk);
    }
}

void add_front_feet(Builder& b, double x, double y, double l) {
    Random& r = b.random;
    const int manner = r.integer(0, 2);
    for (int side = -1; side <= 1; side += 2) {
        const Point2d hip{side * x, y}, foot{side * x * r.uniform(0.8, 1.3), y + l};
        if (manner == 0) {
            b.region(Label::limb, ellipse(hip + Point2d{0, 0.4 * l}, 0.6 * x + 1, 0.5 * l),
                     r.chance(0.5) ? 0.5 : -0.5);
            continue;
        }
        b.stick(Label::limb, {hip, foot}, -1);
        for (int k = -1; k <= 1; ++k)
            b.continued(b.stick(
                Label::limb, {foot, foot + Point2d{k * r.uniform(1.5, 3.0), r.uniform(1.0, 3.0)}}, -1, 2.0));
    }
}

void add_front_beak(Builder& b, int head, Frame f) {
    Random& r = b.random;
    const double w = r.uniform(0.12, 0.3), l = r.uniform(0.2, 0.45), y = r.uniform(-0.05, 0.15);
    if (r.chance(0.3))
        b.mark(head, {f.at(0, y - 0.6 * l), f.at(w, y), f.at(0, y + 0.6 * l), f.at(-w, y)}, true);
    else
        b.mark(head, {f.at(-w, y), f.at(0, y + l), f.at(w, y)}, r.chance(0.7));
}

// One egg, or head and body; returns the trunk, `head` gets the head's part and frame.
int add_egg(Builder& b, double w, double l, bool whole, int& head, Frame& face) {
    Random& r = b.random;
    const double top = r.uniform(0.6, 0.95);
    const Path egg = spline({{0, -l},
                             {-top * 0.8 * w, -0.65 * l},
                             {-0.95 * w, 0.1 * l},
                             {-0.65 * w, 0.8 * l},
                             {0, l},
                             {0.65 * w, 0.8 * l},
                             {0.95 * w, 0.1 * l},
                             {top * 0.8 * w, -0.65 * l}},
                            true, 6);
    const int trunk = b.region(Label::body, egg, 0);
    if (whole) {
        const double neck = r.uniform(-0.35, -0.1) * l;
        head = b.piece(trunk, Label::head, beyond({0, neck}, {0, -1}, 2 * w, 2 * l));
        face = {{0, 0.5 * (neck - l)}, 0.75 * top * w, 0.5 * (l + neck), 0};
        if (r.chance(0.25))
            b.mark(trunk, {{-1.2 * w, neck}, {0, neck + r.uniform(-0.1, 0.2) * l}, {1.2 * w, neck}});
        return trunk;
    }
    const double h = w * r.uniform(0.6, 1.0);
    face = {{r.uniform(-1.0, 1.0), -l - h * r.uniform(0.1, 0.6)}, h, h * r.uniform(0.75, 1.0), 0};
    head = b.region(Label::head, ellipse(face.centre, face.rx, face.ry), 1);
    b.attach(head, trunk);
    return trunk;
}

void build_front_owl(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(12, 19), l = r.uniform(18, 27);
    int head = 0;
    Frame f;
    const int trunk = add_egg(b, w, l, r.chance(0.65), head, f);
    const double eye = r.uniform(0.25, 0.45), pupil = r.uniform(0.3, 0.6), gap = r.uniform(0.4, 0.55);
    const bool solid = r.chance(0.6);
    for (int s = -1; s <= 1; s += 2) {
        const Point2d c = f.at(gap * s, r.uniform(-0.25, -0.1));
        b.mark(-1, ellipse(c, eye * f.rx, eye * f.rx), true);
        if (solid)
            b.spot(-1, ellipse(c, pupil * eye * f.rx, pupil * eye * f.rx));
        else
            b.mark(-1, ellipse(c, pupil * eye * f.rx, pupil * eye * f.rx), true);
        if (r.chance(0.8)) {
            const int ear =
                b.region(Label::head, {f.at(0.95 * s, -0.3), f.at(0.9 * s, -1.5), f.at(0.2 * s, -0.8)}, -0.1);
            b.merge(ear, trunk);
            if (head != trunk) b.attach(ear, head);
        }
    }
    add_front_beak(b, -1, f);
    const int wings = r.integer(0, 5); // inside the outline, outside, raised
    const double y = f.centre.y + f.ry * 1.1;
    for (int s = -1; s <= 1 && wings <= 3; s += 2) {
        const double in = wings <= 1 ? r.uniform(0.4, 0.6) : 0.85,
                     out = wings <= 1 ? 1.1 : r.uniform(1.15, 1.5);
        Contour c;
        c.to({s * 0.85 * w, y}).through({{s * in * w, 0.2 * l}, {s * 0.75 * w, 0.75 * l}});
        c.through({{s * out * w, 0.35 * l}, {s * out * w, 0.0}, {s * 0.85 * w, y}});
        const int wing = b.region(Label::wing, c.points, 0.5);
        if (wings <= 1) b.part(wing).within = trunk; // its line is drawn, its outer edge is the trunk's
    }
    if (wings > 3)
        add_wings(b, trunk,
                  {0.8 * w, y, 0.6 * l, r.uniform(12, 26), r.uniform(-8, 16), r.integer(0, 2), -0.5});
    if (r.chance(0.8)) add_front_feet(b, 0.35 * w, 0.95 * l, r.uniform(3, 7));
    if (r.chance(0.25)) add_pattern(b, trunk, {{0, 0.3 * l}, 0.5 * w, 0.5 * l, 0}, "spots");
}

void build_front_penguin(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(10, 18), l = r.uniform(20, 30);
    int head = 0;
    Frame f;
    const int trunk = add_egg(b, w, l, r.chance(0.6), head, f);
    for (int s = -1; s <= 1; s += 2) {
        const double out = r.uniform(0.3, 0.5), size = r.uniform(0.1, 0.25);
        add_eye(b, -1, f.at(out * s, -0.15), size * f.rx);
    }
    add_front_beak(b, -1, f);
    if (r.chance(0.6)) {
        const double k = r.uniform(0.55, 0.8), up = r.chance(0.4) ? -l * 0.9 : f.centre.y + f.ry;
        b.mark(trunk, ellipse({0, 0.5 * (up + 0.9 * l)}, k * w, 0.5 * (0.9 * l - up)), true);
    }
    const double y = f.centre.y + f.ry * 1.05, out = r.uniform(0.3, 1.0) * w, drop = r.uniform(0.3, 0.9) * l,
                 in = r.chance(0.25) ? -0.35 * w : 0.0;
    const double thick = r.uniform(0.1, 0.25) * w;
    const bool lines = r.chance(0.12);
    for (int s = -1; s <= 1; s += 2) {
        const Path line{{s * (0.8 * w + in), y},
                        {s * (0.9 * w + 0.6 * out + in), y + 0.5 * drop},
                        {s * (0.9 * w + out + in), y + b.jitter(drop, 0.15)}};
        if (lines)
            b.stick(Label::wing, line, 0.5);
        else
            b.attach(b.limb(Label::wing, line, {0.8 * thick, 1.3 * thick, 0.4 * thick},
                            in < 0 || r.chance(0.4) ? 0.6 : -0.5),
                     trunk);
    }
    if (r.chance(0.9)) add_front_feet(b, 0.4 * w, 0.93 * l, r.uniform(3, 6));
}

void build_front_bird(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(11, 18), l = r.uniform(13, 22);
    int head = 0;
    Frame f;
    const int trunk = add_egg(b, w, l, r.chance(0.6), head, f);
    for (int s = -1; s <= 1; s += 2) {
        const double out = r.uniform(0.3, 0.5), size = r.uniform(0.12, 0.25);
        add_eye(b, -1, f.at(out * s, -0.2), size * f.rx);
    }
    add_front_beak(b, -1, f);
    const double y = f.centre.y + f.ry * r.uniform(1.0, 1.4), rise = r.uniform(-12, 14);
    add_wings(b, trunk,
              {0.85 * w, y, r.uniform(0.3, 0.8) * l, r.uniform(7, 30), rise, r.integer(0, 2),
               r.chance(0.5) ? 0.5 : -0.5});
    if (r.chance(0.85)) add_front_feet(b, 0.35 * w, 0.93 * l, r.uniform(4, 12));
    if (r.chance(0.25)) {
        for (int i = -1; i <= 1; ++i)
            b.stick(Label::head, {f.at(0.1 * i, -0.9), f.at(0.35 * i, -1.4)}, -0.2, 1.5);
    }
}

// From the front, its tail a fan behind it.
void build_peacock(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(6, 10), l = r.uniform(12, 18), fan = r.uniform(24, 40),
                 half = r.uniform(1.0, 1.6);
    int head = 0;
    Frame f;
    const int trunk = add_egg(b, w, l, r.chance(0.5), head, f);
    for (int s = -1; s <= 1; s += 2) add_eye(b, -1, f.at(0.4 * s, -0.2), 0.2 * f.rx);
    add_front_beak(b, -1, f);
    const int n = r.integer(5, 9);
    const Point2d root{0, 0.6 * l};
    const bool loops = r.chance(0.4);
    Contour c;
    c.to(root);
    for (int i = 0; i < n; ++i) {
        const double from = -0.5 * pi - half + 2 * half * i / n, to = from + 2 * half / n;
        const Point2d tip = root + fan * direction(0.5 * (from + to));
        if (loops)
            b.region(Label::tail,
                     ellipse(mix(root, tip, 0.55), 0.48 * fan, 0.4 * fan * half / n, 0.5 * (from + to)), -2);
        else
            c.to(root + (0.92 * fan) * direction(from)).through({tip, root + (0.92 * fan) * direction(to)});
    }
    const int tail = loops ? -1 : b.region(Label::tail, c.points, -2);
    const bool ribs = r.chance(0.6), spots = r.chance(0.6);
    for (int i = 0; i < n; ++i) {
        const Point2d d = direction(-0.5 * pi - half + 2 * half * (i + 0.5) / n),
                      e = direction(-0.5 * pi - half + 2 * half * i / n);
        if (spots && tail >= 0) b.mark(tail, ellipse(root + (0.82 * fan) * d, 0.06 * fan, 0.06 * fan), true);
        if (ribs && tail >= 0 && i > 0) b.mark(tail, {root, root + (0.9 * fan) * e});
    }
    if (r.chance(0.8)) add_front_feet(b, 0.35 * w, 0.93 * l, r.uniform(4, 9));
    if (r.chance(0.4))
        add_wings(b, trunk, {0.8 * w, -0.2 * l, 0.7 * l, r.uniform(2, 6), r.uniform(-12, -6), 0, 0.5});
}

void build_front_bat(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(5, 12), l = r.uniform(8, 17);
    int head = 0;
    Frame f;
    const int trunk = add_egg(b, w, l, r.chance(0.5), head, f);
    add_frontal_face(b, -1, f);
    for (int s = -1; s <= 1; s += 2) {
        const double out = r.uniform(0.6, 1.1), high = r.uniform(-2.3, -1.4);
        const int ear =
            b.region(Label::head, {f.at(0.95 * s, -0.3), f.at(out * s, high), f.at(0.15 * s, -0.8)}, -0.1);
        b.merge(ear, trunk);
        if (head != trunk) b.attach(ear, head);
    }
    const double y = std::max(f.centre.y + 0.6 * f.ry, -0.7 * l);
    add_wings(b, trunk,
              {0.6 * w, y, r.uniform(0.5, 1.3) * l, r.uniform(22, 48), r.uniform(-4, 20),
               r.chance(0.8) ? 2 : 0, -0.5});
    if (r.chance(0.5)) add_front_feet(b, 0.35 * w, 0.9 * l, r.uniform(3, 6));
}

// A bird from the side whose wings are up: flowing trunk, one or both wings.
void build_raised(Builder& b) {
    b.figure.heading = 0;
    Random& r = b.random;
    const double x = r.uniform(17, 26), y = r.uniform(6, 12), h = r.uniform(4.5, 8),
                 tilt = r.uniform(-0.1, 0.4);
    const auto at = [&](double u, double v) { return rotated({u * x, v * y}, -tilt); };
    const Point2d c = at(0.95, -0.3);
    const double beak = r.uniform(4, 10), tail = r.uniform(10, 22), w = r.uniform(2, 6);
    Contour k;
    k.to(at(-0.9, -0.2))
        .through({at(-0.4, -0.8), at(0.3, -0.95), c + h * direction(-2.2), c + h * direction(-1.3),
                  c + h * direction(-0.4)});
    k.to(c + (h + beak) * direction(r.uniform(-0.1, 0.2))).to(c + h * direction(0.5));
    k.through({c + h * direction(1.3), at(0.6, 0.75), at(0.1, 1.0), at(-0.5, 0.7), at(-0.9, 0.2)});
    const Point2d end = at(-0.9, 0) - Point2d{tail, r.uniform(-5.0, 5.0)};
    k.to(end + Point2d{0, w});
    if (r.chance(0.4)) k.to(end + Point2d{0.35 * tail, 0});
    k.to(end - Point2d{0, w});
    const int trunk = b.region(Label::body, k.points, 0);
    b.piece(trunk, Label::head,
            beyond(c - (0.8 * h) * direction(-tilt - 0.4), direction(-tilt - 0.2), 2 * h + beak, 50));
    b.piece(trunk, Label::tail, beyond(at(-0.95, 0), at(-1, 0), 40, 60));
    add_eye(b, -1, c + Point2d{0.25 * h, -0.25 * h}, 0.25 * h);
    const double l = r.uniform(16, 40), lean = r.uniform(-0.7, 0.4), width = r.uniform(0.5, 1.1) * x;
    const int count = r.integer(1, 2), edge = r.integer(0, 2);
    const bool over = r.chance(0.6);
    for (int i = 0; i < count; ++i) {
        const double turn = lean + 0.6 * i, bulge = r.uniform(0.1, 0.35);
        const Point2d front = at(0.35 + 0.2 * i, -0.4), rear = front - rotated({width, 0}, -tilt),
                      tip = mix(front, rear, 0.5) + l * Point2d{math::sin(turn), -math::cos(turn)};
        Contour g;
        g.to(front).through({mix(front, tip, 0.5) + Point2d{bulge * width, 0}, tip});
        const int n = edge == 0 ? 1 : r.integer(3, 5);
        for (int q = 0; q < n; ++q) {
            const Point2d from = mix(tip, rear, static_cast<double>(q) / n),
                          to = mix(tip, rear, (q + 1.0) / n);
            g.through({mix(from, to, 0.5) - Point2d{(edge == 2 ? -0.3 : 0.35) * distance(from, to), 0}, to});
        }
        const int wing = b.region(Label::wing, g.points, i == 0 ? (over ? 1 : -0.5) : -1.5);
        if (i == 0 && r.chance(0.5)) b.merge(wing, trunk);
    }
    if (r.chance(0.3)) add_line_leg(b, trunk, at(-0.1, 0.8), at(-0.4, 1.6), 0.3, 0);
    b.figure.max_tilt = 0.4;
}

// A girl with wings: a dress, line limbs.
void build_fairy(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    b.figure = build_upright(r, r.chance(0.5)   ? "princess"
                                : r.chance(0.5) ? "posed stick person"
                                                : "posed person");
    b.figure.type = "flying", b.figure.species = species;
    Point2d low{0, -1e9}, high{0, 1e9};
    for (const Part& part : b.figure.parts)
        if (part.label == Label::body && part.kind != PartKind::mark && part.within < 0) {
            for (Point2d p : part.outline.points) {
                if (p.y > low.y) low = p;
                if (p.y < high.y) high = p;
            }
            break;
        }
    const double l = std::max(low.y - high.y, 10.0), x = high.x, y = high.y + r.uniform(0.05, 0.25) * l,
                 reach = r.uniform(18, 36);
    const double half = r.uniform(0, 3);
    const int kind = r.integer(0, 3), edge = r.integer(0, 2);
    const double rise = r.uniform(-6, 18), width = r.uniform(0.3, 0.8) * std::min(l, 30.0),
                 small = r.uniform(0.5, 0.9);
    for (int s = -1; s <= 1; s += 2) {
        const Point2d root{x + s * half, y};
        if (kind <= 1) {
            add_side_wing(b, root, width, root + Point2d{s * reach, -rise}, edge, -6);
        } else { // two loops
            b.region(
                Label::wing,
                ellipse(root + Point2d{0.55 * s * reach, -0.3 * reach}, 0.6 * reach, 0.35 * reach, -0.6 * s),
                -6);
            if (kind == 3)
                b.region(Label::wing,
                         ellipse(root + Point2d{0.5 * s * reach, 0.35 * reach}, 0.5 * small * reach,
                                 0.35 * small * reach, 0.5 * s),
                         -6);
        }
    }
    if (species == "line angel" && r.chance(0.8)) { // a halo
        double top = 1e9;
        for (const Part& part : b.figure.parts)
            if (part.label == Label::head && part.kind == PartKind::region)
                for (Point2d p : part.outline.points) top = std::min(top, p.y);
        const double above = r.uniform(1.0, 4.0), rx = r.uniform(5, 10), ry = r.uniform(1.5, 3);
        const int halo = b.stick(Label::head, ellipse({x, top - above}, rx, ry), 2, 1.2);
        b.part(halo).outline.closed = true;
    }
}

// A dragon or a winged horse from the side: a walker's trunk with a long tail, spikes and wings.
void build_side_dragon(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const bool horse = species == "pegasus", long_neck = r.chance(0.75);
    b.figure = build_walker(r, horse ? "quick horse" : long_neck ? "dragon trunk" : "crocodile");
    b.figure.type = "flying", b.figure.species = species;
    const double x = r.uniform(-8, 6), l = r.uniform(18, 40), lean = r.uniform(0.0, 0.9);
    const int count = r.integer(1, 2);
    for (int i = 0; i < count; ++i) {
        const Point2d front{x + 7 + 7 * i, -6}, rear{x - 9 + 7 * i, -6},
            tip = front + l * Point2d{-math::sin(lean - 0.4 * i), -math::cos(lean - 0.4 * i)};
        Contour c;
        c.to(front).through({mix(front, tip, 0.5) + Point2d{0.2 * l, 0}, tip});
        const int n = r.integer(1, 4);
        for (int q = 0; q < n; ++q) {
            const Point2d p = mix(tip, rear, static_cast<double>(q) / n), e = mix(tip, rear, (q + 1.0) / n);
            c.through({mix(p, e, 0.5) + Point2d{0.25 * distance(p, e), 0}, e});
        }
        b.region(Label::wing, c.points, i == 0 ? 1 : -1.5);
    }
}

const std::vector<Sketch>& sketches() {
    static const std::vector<Sketch> table = {
        {"front owl", build_front_owl},   {"front penguin", build_front_penguin},
        {"front bird", build_front_bird}, {"front bat", build_front_bat},
        {"raised bird", build_raised},    {"fairy", build_fairy},
        {"line angel", build_fairy},      {"line dragon", build_side_dragon},
        {"pegasus", build_side_dragon},   {"peacock", build_peacock},
    };
    return table;
}

} // namespace

std::vector<std::string> spread_species() { return names_of(sketches()); }

Figure build_spread(Random& random, const std::string& species) {
    Builder b(random, "flying", species);
    b.figure.heading = 0.5 * pi;
    row_of(sketches(), species).draw(b);
    return std::move(b.figure);
}

} // namespace pantin::doodle
