// SPDX-License-Identifier: MIT
// Car, boat, ball, table, arrow, frame.
#include "core/math.hpp"
#include "doodle/things.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

void car(Builder& b) {
    Random& r = b.random;
    const double half = r.uniform(26, 34), sill = -8, bonnet = -r.uniform(16, 22),
                 roof = bonnet - r.uniform(11, 16);
    const double front = r.uniform(0.15, 0.5) * half, back = -r.uniform(0.5, 0.95) * half;
    const Crayon crayon =
        r.pick(std::vector<Crayon>{Crayon::red, Crayon::blue, Crayon::yellow, Crayon::green});
    Path body = {{-half, sill},     {-half, bonnet}, {back, bonnet},     {back + 5, roof},
                 {front - 5, roof}, {front, bonnet}, {half, bonnet + 2}, {half, sill}};
    if (r.chance(0.3)) body = spline(body, true, 4);
    add_area(b, body, crayon);
    const double middle = 0.5 * (front + back), width = 0.5 * (front - back) - 4;
    for (int side = -1; side <= 1; side += 2) {
        const double x = middle + 0.5 * side * width, half_pane = 0.42 * width;
        add_area(b,
                 {{x - half_pane, bonnet},
                  {x - half_pane, roof + 3},
                  {x + half_pane, roof + 3},
                  {x + half_pane, bonnet}},
                 Crayon::blue, 1);
    }
    const double radius = r.uniform(5.5, 8.5);
    for (int side = -1; side <= 1; side += 2) {
        const int wheel = add_area(b, ellipse({0.58 * side * half, sill}, radius, radius), Crayon::grey, 2);
        if (r.chance(0.7))
            b.mark(wheel, ellipse({0.58 * side * half, sill}, 0.4 * radius, 0.4 * radius), true);
    }
}

void boat(Builder& b) {
    Random& r = b.random;
    const double half = r.uniform(20, 28), depth = r.uniform(8, 13), mast = r.uniform(28, 45);
    add_area(b, {{-half, 0}, {half, 0}, {0.65 * half, depth}, {-0.65 * half, depth}}, Crayon::brown, 1);
    add_line(b, {{0, 0}, {0, -mast}}, Crayon::brown);
    const double boom = r.uniform(-6, -2);
    add_area(b, {{1, -mast}, {0.75 * half, boom}, {1, boom}}, r.chance(0.5) ? Crayon::red : Crayon::yellow,
             1);
    if (r.chance(0.5)) add_area(b, {{-1, -0.9 * mast}, {-0.6 * half, boom}, {-1, boom}}, Crayon::orange, 1);
    if (!r.chance(0.6)) return;
    Path waves;
    for (int i = 0; i <= 12; ++i) waves.push_back({-34 + 68 * i / 12.0, depth + 3 + (i % 2 ? 2.5 : -1.0)});
    add_line(b, spline(waves, false), Crayon::blue);
}

void ball(Builder& b) {
    Random& r = b.random;
    const int disc = add_area(b, ellipse({0, 0}, 18, 18), r.chance(0.5) ? Crayon::red : Crayon::blue);
    b.figure.max_tilt = 0.6;
    const int kind = r.integer(0, 3);
    if (kind == 0) add_pattern(b, disc, {{0, 0}, 18, 18, 0});
    if (kind == 1)
        for (double y : {-6.0, 6.0}) b.mark(disc, spline({{-18, y}, {0, y + 3}, {18, y}}, false));
    if (kind == 2)
        for (int i = 0; i < 3; ++i) b.mark(disc, arc_of({0, 0}, 9, 18, (0.5 + i) * pi, (1.5 + i) * pi));
}

void table(Builder& b) {
    Random& r = b.random;
    const double half = r.uniform(20, 32), height = r.uniform(18, 30), thick = r.uniform(2, 5);
    add_area(b, {{-half, -height}, {half, -height}, {half, thick - height}, {-half, thick - height}},
             Crayon::brown, 1);
    const bool lines = r.chance(0.4);
    const int legs = r.chance(0.7) ? 2 : 4;
    for (int i = 0; i < legs; ++i) {
        const double x = half * (0.85 * (2.0 * i / (legs - 1) - 1.0)), foot = legs == 4 && i % 3 ? -6 : 0;
        if (lines)
            add_line(b, {{x, thick - height}, {x, foot}}, Crayon::brown);
        else
            add_area(b,
                     {{x - 1.5, thick - height}, {x - 1.5, foot}, {x + 1.5, foot}, {x + 1.5, thick - height}},
                     Crayon::brown);
    }
    if (r.chance(0.4))
        add_area(b, {{-4, -height}, {-5, -height - 9}, {5, -height - 9}, {4, -height}}, Crayon::red);
}

void arrow(Builder& b) {
    Random& r = b.random;
    b.figure.max_tilt = 0.8;
    const double bend = r.uniform(-10, 10), barb = r.uniform(5, 10);
    if (r.chance(0.25)) { // a broad one
        add_area(b, {{-30, -4}, {6, -4}, {6, -11}, {26, 0}, {6, 11}, {6, 4}, {-30, 4}}, Crayon::red);
        return;
    }
    add_line(b, spline({{-30, 0}, {0, bend}, {28, 0}}, false), Crayon::red);
    const Point2d tip{28, 0}, back = unit(Point2d{-28, bend});
    for (int side = -1; side <= 1; side += 2)
        add_line(b, {tip, tip + barb * rotated(back, 0.6 * side)}, Crayon::red);
}

// Round the whole page: 100 × 100, stretched to the page by who places it.
void frame(Builder& b) {
    Random& r = b.random;
    b.figure.max_tilt = 0.01;
    const int kind = r.integer(0, 3);
    for (double half : {50.0, 46.5}) {
        if (half < 50 && kind != 1) break;
        Path line = {{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
        if (kind == 2) { // wavy
            line = resample(line, 4.0);
            for (std::size_t i = 1; i + 1 < line.size(); ++i)
                line[i] = (1.0 + (i % 2 ? 0.015 : -0.015)) * line[i];
            line = spline(line, false, 3);
        }
        add_line(b, line, r.chance(0.5) ? Crayon::blue : Crayon::red);
    }
    if (kind != 3) return;
    for (int i = 0; i < 4; ++i) { // ornaments in the corners
        const Point2d corner{i % 2 ? 46.0 : -46.0, i / 2 ? 46.0 : -46.0};
        add_line(b, ellipse(corner, 3.0, 3.0), Crayon::red);
    }
}

} // namespace

const ThingTable& object_things() {
    static const ThingTable things = {{"car", car},     {"boat", boat},   {"ball", ball},
                                      {"table", table}, {"arrow", arrow}, {"frame", frame}};
    return things;
}

} // namespace pantin::doodle
