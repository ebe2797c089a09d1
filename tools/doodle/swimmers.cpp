// SPDX-License-Identifier: MIT
// Type other: fish and whales, crabs, spiders and ants, snails and caterpillars. Side fins, legs and claws
// are limbs, dorsal fins and shells body. Units: about 60 long, the trunk's middle the origin, y down, facing
// right.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "doodle/contour.hpp"
#include "doodle/species.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

struct Fish {
    double x, y, arch, gill;
    Point2d bend(double u, double v) const { return {u * x, v * y + arch * u * u}; }
};

void add_fins(Builder& b, const Fish& f, int trunk, const std::string& species) {
    Random& r = b.random;
    if (species == "shark" || species == "dolphin" || r.chance(0.35)) { // the dorsal fin
        const double size = r.uniform(6, 13);
        const int fin = b.region(
            Label::body, {f.bend(0.25, -0.85), f.bend(-0.15, -0.95) - Point2d{0, size}, f.bend(-0.25, -0.75)},
            -0.2);
        if (r.chance(0.7)) b.merge(fin, trunk);
    }
    if (r.chance(0.6)) { // a side fin
        const double size = r.uniform(5, 12);
        const bool inside = r.chance(0.4);
        const Point2d at = f.bend(0.2, inside ? 0.1 : 0.7);
        const int fin =
            b.region(Label::limb, {at, at + Point2d{-0.8 * size, 0.8 * size}, at - Point2d{0.6 * size, 0}},
                     inside ? 0.5 : -0.3);
        if (!inside && r.chance(0.6)) b.merge(fin, trunk);
    }
}

void add_fish_marks(Builder& b, const Fish& f, int trunk, const std::string& species) {
    Random& r = b.random;
    const bool whale = species == "whale";
    if (species == "fish" && r.chance(0.6))
        b.mark(trunk, spline({f.bend(f.gill, -0.9), f.bend(f.gill + 0.1, 0), f.bend(f.gill, 0.9)}, false));
    if (species == "shark" && r.chance(0.6))
        for (int i = 0; i < 3; ++i)
            b.mark(trunk, {f.bend(f.gill - 0.1 * i, -0.35), f.bend(f.gill - 0.04 - 0.1 * i, 0.35)});
    add_eye(b, -1, f.bend(f.gill + 0.25, -0.25), r.uniform(0.8, 2.2));
    if (r.chance(0.7))
        b.mark(trunk,
               spline({f.bend(0.98, 0.25), f.bend(0.82, 0.35), f.bend(0.7, whale ? 0.0 : 0.3)}, false));
    if (whale && r.chance(0.7))
        for (int s = -1; s <= 1; ++s)
            b.mark(-1, spline({f.bend(0.35, -1), f.bend(0.35, -1.4) + Point2d{2.0 * s, -2},
                               f.bend(0.35, -1.5) + Point2d{5.0 * s, -5}},
                              false));
    if (species == "fish" && r.chance(0.3))
        for (int i = 0; i < 6; ++i) {
            const double u = r.uniform(-0.6, 0.2), v = r.uniform(-0.5, 0.5);
            const Point2d p = f.bend(u, v);
            b.mark(trunk, spline({p + Point2d{0, -2}, p + Point2d{-2, 0}, p + Point2d{0, 2}}, false), false,
                   0.8);
        }
}

// Fish, sharks, whales and dolphins in one outline; `arch` bends the back.
void build_fish(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const bool whale = species == "whale", shark = species == "shark", dolphin = species == "dolphin";
    const double x = r.uniform(22, 30),
                 y = whale              ? r.uniform(10, 18)
                     : shark || dolphin ? r.uniform(6, 10)
                                        : r.uniform(7, 16),
                 tail = r.uniform(8, 16), thin = r.uniform(1.0, 4.0), arch = dolphin ? r.uniform(2, 14) : 0.0,
                 up = whale ? r.uniform(4, 16) : r.uniform(-2, 2);
    const auto bend = [&](double u, double v) { return Point2d{u * x, v * y + arch * u * u}; };
    const Point2d root = bend(-1, 0) - Point2d{0, up};
    const double fan = r.uniform(5, 13), notch = r.uniform(0.2, 0.7);
    Contour k;
    k.to(root - Point2d{0, thin}).through({bend(-0.5, -0.65), bend(0.1, -1), bend(0.6, -0.8)});
    const bool snout = (shark && r.chance(0.5)) || (dolphin && r.chance(0.8));
    if (snout)
        k.through({bend(0.85, -0.45)})
            .to(bend(1.15, 0.05) + Point2d{r.uniform(0.0, 7.0), 0})
            .to(bend(0.85, 0.35));
    else
        k.through({bend(0.92, -0.4), bend(1, 0.05), bend(0.9, 0.45)});
    k.through({bend(0.6, 0.85), bend(0.1, whale ? 0.9 : 1.0), bend(-0.5, 0.6), root + Point2d{0, thin}});
    const double twist = whale ? r.uniform(0.3, 1.1) : r.uniform(-0.2, 0.2);
    const auto at_tail = [&](double u, double v) { return root + rotated({-u, v}, twist); };
    const bool crossing = species == "fish" && r.chance(0.3);
    k.to(at_tail(tail, fan)).to(at_tail(tail * (crossing ? 1.0 : notch), 0)).to(at_tail(tail, -fan));
    const int trunk = b.region(Label::body, k.points, 0);
    b.piece(trunk, Label::tail, beyond(at_tail(-1, 0), at_tail(1, 0) - at_tail(0, 0), 40, 60));
    const double gill = r.uniform(0.35, 0.6);
    b.piece(trunk, Label::head, beyond(bend(gill, 0), {1, 0.2 * arch / 10}, 40, 60));
    const Fish shape{x, y, arch, gill};
    add_fish_marks(b, shape, trunk, species);
    add_fins(b, shape, trunk, species);
    b.figure.max_tilt = 0.3;
}

void add_bent_leg(Builder& b, Point2d root, Point2d out, double l, double bend) {
    const Point2d knee = root + (0.5 * l) * out + Point2d{0, -bend * l};
    b.stick(Label::limb,
            b.random.chance(0.5) ? spline({root, knee, root + l * out + Point2d{0, bend * l}}, false)
                                 : Path{root, knee, root + l * out + Point2d{0, bend * l}},
            -1);
}

void build_spider(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(8, 15), h = r.chance(0.3) ? 0 : r.uniform(4, 8), l = r.uniform(14, 26),
                 bend = r.uniform(-0.1, 0.4);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, w * r.uniform(0.8, 1.1)), 0);
    if (h > 0) {
        const int head =
            b.region(Label::head, ellipse({0, -w - 0.5 * h}, h, h * 0.9), r.chance(0.5) ? 1 : -0.5);
        if (r.chance(0.5)) add_frontal_face(b, head, {{0, -w - 0.5 * h}, h, h, 0});
    } else {
        b.piece(trunk, Label::head, beyond({0, -0.2 * w}, {0, -1}, 2 * w, 2 * w));
        add_frontal_face(b, -1, {{0, -0.45 * w}, 0.7 * w, 0.5 * w, 0});
    }
    const int pairs = r.chance(0.8) ? 4 : r.integer(2, 5);
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < pairs; ++i) {
            const double a = -0.7 + 1.4 * i / std::max(1, pairs - 1) + r.uniform(-0.1, 0.1);
            const Point2d d{s * math::cos(a), math::sin(a)};
            add_bent_leg(b, 0.93 * w * d, d, b.jitter(l, 0.2), bend);
        }
    b.figure.heading = r.chance(0.5) ? 0.5 * pi : -0.5 * pi;
    b.figure.max_tilt = 0.5;
}

void build_ant(Builder& b) {
    Random& r = b.random;
    const int count = r.chance(0.7) ? 3 : 2;
    double x = 0, radius = r.uniform(6, 9);
    std::vector<Frame> balls;
    for (int i = 0; i < count; ++i) {
        balls.push_back({{-x, r.uniform(-1.5, 1.5)}, radius, radius * r.uniform(0.7, 1.05), 0});
        const double next = i + 2 == count ? r.uniform(8, 14) : r.uniform(5, 9);
        x += (radius + next) * r.uniform(0.9, 1.1), radius = next;
    }
    const int head = b.region(Label::head, ellipse(balls[0].centre, balls[0].rx, balls[0].ry), 1);
    add_eye(b, head, balls[0].at(0.3, -0.2), 1.4);
    for (int i = 1; i < count; ++i)
        b.region(Label::body, ellipse(balls[i].centre, balls[i].rx, balls[i].ry), -0.1 * i);
    if (r.chance(0.85))
        for (int s = 0; s < 2; ++s)
            b.stick(Label::head,
                    {balls[0].at(0.2 + 0.3 * s, -0.9), balls[0].at(0.5 + 0.7 * s, -r.uniform(1.6, 2.4))},
                    -0.2, 1.5);
    const int legs = r.chance(0.6) ? 3 : r.integer(2, 6);
    const double l = r.uniform(6, 14);
    const bool spread = r.chance(0.5), both = r.chance(0.25);
    for (int i = 0; i < legs; ++i) {
        const Frame& f =
            spread ? balls[static_cast<std::size_t>(std::min(count - 1, 1 + i % (count - 1)))] : balls[1];
        const double u = -0.7 + 1.4 * (i + 0.5) / legs;
        const double kick = r.uniform(-4.0, 4.0);
        b.stick(Label::limb,
                {f.at(u, 0.8), f.at(u, 1.0) + Point2d{0.5 * kick, 0.5 * l}, f.at(u, 1.0) + Point2d{kick, l}},
                -1);
        if (both) b.stick(Label::limb, {f.at(u, -0.8), f.at(u, -1.0) + Point2d{kick, -l}}, -1);
    }
}

void add_claw(Builder& b, Point2d c, double angle, double size) {
    Random& r = b.random;
    const auto at = [&](double along, double side) {
        return c + rotated({along * size, side * size}, angle);
    };
    if (r.chance(0.3)) {
        b.continued(b.region(Label::limb,
                             ellipse(c + (0.6 * size) * direction(angle), size, 0.7 * size, angle), 0.2));
        b.mark(-1, {at(1.6, 0), at(0.5, 0)});
        return;
    }
    Contour k;
    k.to(at(0, 0))
        .through({at(0.5, -0.75), at(1.2, -0.6), at(1.7, -0.1)})
        .to(at(0.8, 0.0))
        .to(at(1.5, 0.45))
        .through({at(0.8, 0.75), at(0, 0)});
    b.continued(b.region(Label::limb, k.points, 0.2));
}

void build_crab(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(14, 23), h = w * r.uniform(0.45, 0.9), size = r.uniform(5, 10),
                 l = r.uniform(7, 16);
    const int trunk = b.region(Label::body, ellipse({0, 0}, w, h), 0);
    b.piece(trunk, Label::head, beyond({0, -r.uniform(0.1, 0.4) * h}, {0, -1}, 0.6 * w, 2 * h));
    const bool stalks = r.chance(0.5);
    const double raise = r.uniform(0.1, 1.3);
    for (int s = -1; s <= 1; s += 2) {
        if (stalks) {
            const Point2d eye{0.3 * s * w, -h - r.uniform(3.0, 6.0)};
            b.stick(Label::head, {{0.28 * s * w, -0.9 * h}, eye}, -0.2, 1.5);
            b.region(Label::head, ellipse(eye, 2.0, 2.0), 0.5);
        } else {
            add_eye(b, -1, {0.25 * s * w, -0.4 * h}, 2.0);
        }
        const Point2d root{0.85 * s * w, -0.4 * h},
            wrist = root + Point2d{s * r.uniform(3, 11), -raise * r.uniform(7, 13)};
        b.stick(Label::limb, spline({root, root + Point2d{s * 6.0, 0}, wrist}, false), -0.5);
        add_claw(b, wrist, s > 0 ? -raise : pi + raise, size);
        const int legs = r.integer(2, 4);
        for (int i = 0; i < legs; ++i) {
            const double a = 0.15 + 1.0 * i / legs;
            const Point2d d{s * math::cos(a), math::sin(a)}, from{0.95 * w * d.x, 0.95 * h * d.y};
            b.stick(Label::limb,
                    {from, from + (0.6 * l) * d - Point2d{0, 0.1 * l}, from + l * d + Point2d{0, 0.25 * l}},
                    -1);
        }
    }
    if (r.chance(0.5))
        b.mark(trunk, spline({{-0.25 * w, 0.2 * h}, {0, 0.45 * h}, {0.25 * w, 0.2 * h}}, false));
    b.figure.heading = 0.5 * pi;
}

// Scorpions and lobsters from above or the side: claws in front, a jointed tail.
void build_scorpion(Builder& b) {
    const std::string species = b.figure.species;
    Random& r = b.random;
    const double x = r.uniform(14, 22), y = x * r.uniform(0.25, 0.5);
    const int trunk = b.region(Label::body, ellipse({0, 0}, x, y), 0);
    b.piece(trunk, Label::head, beyond({r.uniform(0.4, 0.65) * x, 0}, {1, 0}, 2 * y, x));
    for (int s = -1; s <= 1; s += 2) {
        add_eye(b, -1, {0.8 * x, 0.25 * s * y}, 1.2);
        const Point2d root{0.85 * x, 0.4 * s * y},
            wrist = root + Point2d{r.uniform(5, 13), s * r.uniform(3, 9)};
        b.stick(Label::limb, {root, root + Point2d{2, 5.0 * s}, wrist}, -0.5);
        const double angle = r.uniform(-0.4, 0.4);
        add_claw(b, wrist, angle, r.uniform(4, 8));
    }
    const int legs = r.integer(3, 4);
    const bool above = species == "lobster" || r.chance(0.5);
    for (int i = 0; i < legs; ++i)
        for (int s = above ? -1 : 1; s <= 1; s += 2) {
            const double u = -0.6 + 1.1 * i / (legs - 1);
            b.stick(Label::limb,
                    {{u * x, 0.8 * s * y}, {u * x + r.uniform(-2.0, 2.0), s * (y + r.uniform(5, 10))}}, -1);
        }
    const double l = r.uniform(24, 42), w = r.uniform(1.5, 4.5);
    if (species == "lobster") {
        b.attach(b.limb(Label::tail, {{-0.9 * x, 0}, {-x - 0.5 * l, 0}}, {0.8 * y, 0.5 * y}, -0.1,
                        {Cap::flat, Cap::flat, true, false}),
                 trunk);
        const Point2d e{-x - 0.5 * l, 0};
        b.region(Label::tail, {e, e + Point2d{-8, -7}, e + Point2d{-6, 0}, e + Point2d{-8, 7}}, -0.2);
        return;
    }
    const Path line{
        {-0.9 * x, 0}, {-x - 0.3 * l, -0.2 * l}, {-x - 0.2 * l, -0.65 * l}, {-0.5 * x, -0.75 * l}};
    if (r.chance(0.4)) {
        b.stick(Label::tail, spline(line, false), -0.5);
    } else {
        const int tail = b.limb(Label::tail, line, {w, w, 0.7 * w}, -0.5);
        for (int i = 1; i < 5 && r.chance(0.8); ++i)
            b.mark(tail, {mix(line[0], line[2], 0.2 * i) - Point2d{9, 2},
                          mix(line[0], line[2], 0.2 * i) + Point2d{5, 2}});
    }
    b.region(Label::tail, {line[3] + Point2d{-1, -2}, line[3] + Point2d{6, 4}, line[3] + Point2d{-2, 2}},
             -0.4);
}

void build_snail(Builder& b) {
    Random& r = b.random;
    const double s = r.uniform(11, 18), l = r.uniform(24, 34), h = r.uniform(2.5, 5), rise = r.uniform(2, 12);
    const int trunk =
        b.limb(Label::body, {{-l, 0}, {0, 0}, {0.65 * l, 0}, {0.85 * l, -rise}}, {0.6, h, h, 0.9 * h}, 0);
    b.piece(trunk, Label::head, beyond({0.68 * l, 0}, {0.6, -0.5}, 12, 40));
    b.piece(trunk, Label::tail, beyond({-0.6 * l, 0}, {-1, 0}, 12, 40));
    const int shell = b.region(Label::body, ellipse({-0.1 * l, -0.8 * s}, s, s * r.uniform(0.85, 1.05)), 0.5);
    Path spiral;
    const double turns = r.uniform(1.5, 3.0);
    for (int i = 0; i <= 40; ++i)
        spiral.push_back(Point2d{-0.1 * l, -0.8 * s} +
                         (0.95 * s * (1 - i / 42.0)) * direction(1.5 + 2 * pi * turns * i / 40));
    b.mark(shell, spiral);
    for (int i = -1; i <= 1; i += 2) {
        const Point2d root{0.85 * l, -rise - 0.8 * h},
            tip = root + Point2d{3.0 * i + 1, -r.uniform(4.0, 10.0)};
        b.stick(Label::head, {root, tip}, -0.2, 1.5);
        if (r.chance(0.4)) b.region(Label::head, ellipse(tip, 1.3, 1.3), 0.1);
    }
    add_eye(b, -1, {0.87 * l, -rise}, 1.2);
}

void build_caterpillar(Builder& b) {
    Random& r = b.random;
    const int n = r.integer(4, 8);
    const double s = r.uniform(5, 8), wave = r.uniform(0, 6), pace = s * r.uniform(1.2, 1.9),
                 phase = r.uniform(0, 3);
    const bool one = r.chance(0.25);
    Path centres;
    for (int i = 0; i < n; ++i) centres.push_back({-pace * i, wave * math::sin(phase + 1.1 * i)});
    const Point2d c = Point2d{0.9 * pace, -r.uniform(0.0, 6.0)} + centres[0];
    if (one)
        b.limb(Label::body, centres, {s}, 0);
    else
        for (int i = n; i-- > 0;)
            b.region(Label::body, ellipse(centres[static_cast<std::size_t>(i)], s, s * r.uniform(0.9, 1.1)),
                     -0.01 * i);
    const int head = b.region(Label::head, ellipse(c, 1.2 * s, 1.15 * s), 1);
    add_frontal_face(b, head, {c, 1.2 * s, 1.15 * s, 0});
    for (int k = -1; k <= 1; k += 2)
        b.stick(Label::head, {c + Point2d{0.4 * k * s, -s}, c + Point2d{0.8 * k * s, -2 * s}}, 0.5, 1.5);
    const int per = r.integer(1, 2);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < per; ++k) {
            const Point2d p = centres[static_cast<std::size_t>(i)] +
                              Point2d{(per == 1 ? 0.0 : -0.35 + 0.7 * k) * s, 0.85 * s};
            b.stick(Label::limb, {p, p + Point2d{r.uniform(-1.0, 1.0), r.uniform(3, 6)}}, -0.5);
        }
}

void build_octopus(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(11, 17), h = w * r.uniform(0.85, 1.4), l = r.uniform(16, 32);
    const int head = b.region(Label::head, ellipse({0, 0}, w, h), 0.5);
    add_frontal_face(b, head, {{0, -0.1 * h}, 0.8 * w, 0.7 * h, 0});
    b.piece(head, Label::body, beyond({0, 0.45 * h}, {0, 1}, 2 * w, 2 * h));
    const int n = r.integer(4, 8);
    const bool lines = r.chance(0.5);
    for (int i = 0; i < n; ++i) {
        const double u = -1 + 2.0 * i / (n - 1), curl_by = r.uniform(-7.0, 7.0);
        const Point2d root{0.75 * u * w, h * (0.95 - 0.35 * u * u)},
            tip{u * (w + 0.6 * l), h + l * (1 - 0.5 * std::abs(u)) * r.uniform(0.7, 1.0)};
        const Path line{root - Point2d{0, 2}, mix(root, tip, 0.5) + Point2d{curl_by, 0}, tip};
        if (lines)
            b.stick(Label::limb, spline(line, false), -0.5);
        else
            b.attach(b.limb(Label::limb, line, {2.6, 2.0, 0.8}, -0.5 - 0.01 * i,
                            {Cap::flat, Cap::round, true, false}),
                     head);
    }
    b.figure.heading = 0.5 * pi;
}

void build_snake(Builder& b) {
    Random& r = b.random;
    const double w = r.uniform(1.5, 4.5), amp = r.uniform(4, 12), pace = r.uniform(10, 18);
    Path line;
    const int n = r.integer(4, 7);
    for (int i = 0; i < n; ++i) line.push_back({-pace * i, (i % 2 ? 1 : -1) * amp * r.uniform(0.6, 1.1)});
    const int trunk = b.limb(Label::body, line, {w, w, w, 0.4}, 0, {Cap::round, Cap::pointed, false, false});
    b.piece(
        trunk, Label::tail,
        beyond(mix(line[line.size() - 2], line.back(), 0.3), line.back() - line[line.size() - 2], 15, 60));
    const Point2d c = line[0] + Point2d{w, 0};
    const int head = b.region(Label::head, ellipse(c, 1.8 * w + 1, 1.3 * w + 0.5, r.uniform(-0.3, 0.3)), 0.1);
    if (r.chance(0.6)) b.merge(head, trunk);
    add_eye(b, -1, c + Point2d{0.5 * w, -0.4 * w}, 0.4 * w);
    if (r.chance(0.6))
        b.stick(Label::head, {c + Point2d{1.7 * w, 0}, c + Point2d{3.5 * w + 2, 0.5}}, -0.1, 1.2);
    if (r.chance(0.3))
        add_pattern(b, trunk, {mix(line.front(), line.back(), 0.5), 0.5 * pace * n, amp, 0}, "stripes");
}

const std::vector<Sketch>& sketches() {
    static const std::vector<Sketch> table = {
        {"fish", build_fish},
        {"whale", build_fish},
        {"dolphin", build_fish},
        {"shark", build_fish},
        {"spider", build_spider},
        {"ant", build_ant},
        {"crab", build_crab},
        {"scorpion", build_scorpion},
        {"lobster", build_scorpion},
        {"snail", build_snail},
        {"caterpillar", build_caterpillar},
        {"octopus", build_octopus},
        {"snake", build_snake},
    };
    return table;
}

} // namespace

std::vector<std::string> swimmer_species() { return names_of(sketches()); }

Figure build_swimmer(Random& random, const std::string& species) {
    Builder b(random, "other", species);
    row_of(sketches(), species).draw(b);
    return std::move(b.figure);
}

} // namespace pantin::doodle
