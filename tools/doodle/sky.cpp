// SPDX-License-Identifier: MIT
// Sun, moon, star, cloud, rain, rainbow, balloon, heart.
#include "core/math.hpp"
#include "doodle/things.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

void sun(Builder& b) {
    Random& r = b.random;
    const double radius = r.uniform(12, 20), gap = r.chance(0.5) ? 0.0 : r.uniform(1.0, 5.0);
    const int disc = add_area(b, ellipse({0, 0}, radius, radius * r.uniform(0.9, 1.1)), Crayon::yellow, 1);
    if (r.chance(0.45)) add_frontal_face(b, disc, {{0, 0}, radius, radius, 0});
    const int rays = r.integer(7, 20), kind = r.integer(0, 4);
    const double reach = r.uniform(7, 22);
    for (int i = 0; i < rays && kind < 3; ++i) {
        const double angle = 2 * pi * (i + r.uniform(-0.2, 0.2)) / rays;
        const double length = reach * ((kind == 1 && i % 2) ? 0.5 : r.uniform(0.8, 1.2));
        const Point2d d = direction(angle), side{-d.y, d.x}, start = (radius + gap) * d;
        const Point2d tip = start + length * d;
        if (kind == 2) { // curls
            const double bend = 0.2 * length;
            const Point2d third = start + 0.3 * length * d, half = start + 0.7 * length * d;
            add_line(b, spline({start, third + bend * side, half - bend * side, tip}, false), Crayon::yellow);
        } else {
            add_line(b, {start, tip}, Crayon::yellow);
        }
    }
    if (kind >= 3) { // flames
        const double half = (kind == 3 ? 0.5 : 0.3) * 2 * pi / rays, from = radius + gap;
        for (int i = 0; i < rays; ++i) {
            const double a = 2 * pi * i / rays, tip = from + reach * r.uniform(0.7, 1.0);
            add_area(b, {from * direction(a - half), tip * direction(a), from * direction(a + half)},
                     r.chance(0.3) ? Crayon::orange : Crayon::yellow);
        }
    }
}

void moon(Builder& b) {
    Random& r = b.random;
    const double radius = 20, bite = r.uniform(0.25, 0.7) * radius;
    Path outline = arc_of({0, 0}, radius, radius, 0.5 * pi, 1.5 * pi);
    const Path inner = arc_of({0, 0}, bite, radius, 1.5 * pi, 0.5 * pi);
    outline.insert(outline.end(), inner.begin() + 1, inner.end() - 1);
    const int disc = add_area(b, outline, Crayon::yellow);
    b.figure.max_tilt = 0.5;
    if (r.chance(0.4)) add_eye(b, disc, {-0.75 * radius, -0.3 * radius}, 2.0);
}

void star(Builder& b) {
    Random& r = b.random;
    b.figure.max_tilt = 0.5;
    const double radius = 20;
    if (r.chance(0.3)) { // in one stroke
        Path line;
        for (int i = 0; i <= 5; ++i) line.push_back(radius * direction(0.8 * pi * i - 0.5 * pi));
        add_line(b, line, Crayon::yellow);
        return;
    }
    if (r.chance(0.25)) { // crossing dashes
        for (int i = 0; i < 4; ++i)
            add_line(b, {radius * direction(0.25 * pi * i), -radius * direction(0.25 * pi * i)},
                     Crayon::yellow);
        return;
    }
    const int points = r.integer(5, 7);
    const double inner = radius * r.uniform(0.35, 0.55);
    Path outline;
    for (int i = 0; i < 2 * points; ++i)
        outline.push_back((i % 2 ? inner : radius * r.uniform(0.85, 1.1)) *
                          direction(pi * i / points - 0.5 * pi));
    add_area(b, outline, Crayon::yellow);
}

void add_cloud(Builder& b, Point2d centre, double width) {
    Random& r = b.random;
    const double height = width * r.uniform(0.35, 0.6);
    const int bumps = r.integer(6, 11);
    add_area(b, fluffy(r, {centre, 0.5 * width, 0.5 * height, 0}, bumps),
             r.chance(0.5) ? Crayon::blue : Crayon::grey, 1);
}

void cloud(Builder& b) { add_cloud(b, {0, 0}, 50); }

void rain(Builder& b) {
    Random& r = b.random;
    if (r.chance(0.7)) add_cloud(b, {0, 0}, 50);
    const int drops = r.integer(8, 24);
    const double slant = r.uniform(-0.4, 0.4), size = r.uniform(2.5, 7);
    const bool round = r.chance(0.35);
    for (int i = 0; i < drops; ++i) {
        const Point2d p{-24 + 48 * (i + r.uniform(0.0, 1.0)) / drops, 0};
        const Point2d q{p.x, r.uniform(20, 55)};
        if (round)
            add_area(b,
                     {q + Point2d{0, -size}, q + Point2d{0.35 * size, 0}, q + Point2d{0, 0.35 * size},
                      q + Point2d{-0.35 * size, 0}},
                     Crayon::blue);
        else
            add_line(b, {q, q + size * Point2d{slant, 1}}, Crayon::blue);
    }
}

void rainbow(Builder& b) {
    Random& r = b.random;
    static const std::vector<Crayon> order = {Crayon::red,   Crayon::orange, Crayon::yellow,
                                              Crayon::green, Crayon::blue,   Crayon::pink};
    const int bands = r.integer(3, 6);
    const double height = r.uniform(24, 40), pitch = r.uniform(2.0, 4.5);
    for (int i = 0; i < bands; ++i) {
        const double rx = 40 - pitch * i, ry = height - pitch * i;
        add_line(b, arc_of({0, 0}, rx, ry, pi, 2 * pi), order[static_cast<std::size_t>(i)]);
    }
    if (r.chance(0.3)) add_cloud(b, {-38, 0}, 22), add_cloud(b, {38, 0}, 22);
}

void balloon(Builder& b) {
    Random& r = b.random;
    const int count = r.chance(0.7) ? 1 : 3;
    for (int i = 0; i < count; ++i) {
        const double x = 14.0 * (i - 0.5 * (count - 1)), y = r.uniform(-5, 5), ry = r.uniform(11, 14);
        const Crayon crayon =
            r.pick(std::vector<Crayon>{Crayon::red, Crayon::blue, Crayon::yellow, Crayon::pink});
        add_area(b, ellipse({x, y}, 10, ry), crayon, i);
        const Point2d knot{x, y + ry}, end{0.2 * x, y + ry + r.uniform(25, 45)};
        const Point2d half = mix(knot, end, 0.5) + Point2d{r.uniform(-4, 4), 0};
        add_line(b, spline({knot, half, end}, false), Crayon::grey, i - 0.5);
    }
}

void heart(Builder& b) {
    Random& r = b.random;
    const double width = r.uniform(0.85, 1.2);
    Path outline =
        spline({{0, 18}, {-10 * width, 8}, {-18 * width, -4}, {-14 * width, -14}, {-6 * width, -14}, {0, -6}},
               false);
    const Path right = outline;
    for (std::size_t i = right.size() - 1; i-- > 1;) outline.push_back({-right[i].x, right[i].y});
    add_area(b, outline, r.chance(0.7) ? Crayon::red : Crayon::pink);
}

} // namespace

const ThingTable& sky_things() {
    static const ThingTable table = {{"sun", sun},         {"moon", moon},  {"star", star},
                                     {"cloud", cloud},     {"rain", rain},  {"rainbow", rainbow},
                                     {"balloon", balloon}, {"heart", heart}};
    return table;
}

} // namespace pantin::doodle
