// SPDX-License-Identifier: MIT
// House, tree, fir, flower, grass line, tuft of grass, hill, mountain, fence.
#include <algorithm>

#include "core/math.hpp"
#include "doodle/things.hpp"

namespace pantin::doodle {
namespace {

using math::pi;

void add_window(Builder& b, double x, double y, double size) {
    Random& r = b.random;
    const int pane = r.chance(0.2) ? add_area(b, ellipse({x, y}, 0.5 * size, 0.5 * size), Crayon::blue, 2)
                                   : add_area(b,
                                              {{x - 0.5 * size, y - 0.5 * size},
                                               {x + 0.5 * size, y - 0.5 * size},
                                               {x + 0.5 * size, y + 0.5 * size},
                                               {x - 0.5 * size, y + 0.5 * size}},
                                              Crayon::blue, 2);
    if (r.chance(0.7)) {
        b.mark(pane, {{x, y - 0.5 * size}, {x, y + 0.5 * size}});
        b.mark(pane, {{x - 0.5 * size, y}, {x + 0.5 * size, y}});
    }
}

void add_chimney(Builder& b, double half, double eaves, double ridge) {
    Random& r = b.random;
    const double x = r.uniform(0.3, 0.65) * half, top = ridge + r.uniform(-6, 3), width = r.uniform(4, 7);
    add_area(b, {{x, eaves}, {x, top}, {x + width, top}, {x + width, eaves}}, Crayon::red, -1);
    if (!r.chance(0.6)) return;
    const double turns = r.uniform(1.5, 3.5), size = r.uniform(18, 40), lean = r.uniform(-0.9, -0.4) * pi;
    add_line(b, curl({x + 0.5 * width, top - 2}, lean, size, turns, -1.2), Crayon::grey, -2);
}

void house(Builder& b) {
    Random& r = b.random;
    const double half = r.uniform(16, 26), height = r.uniform(22, 40), pitch = r.uniform(12, 26);
    const double over = r.uniform(0.0, 6.0), eaves = -height, ridge = -height - pitch;
    const Crayon wall =
        r.pick(std::vector<Crayon>{Crayon::yellow, Crayon::brown, Crayon::pink, Crayon::blue});
    add_area(b, {{-half, 0}, {-half, eaves}, {half, eaves}, {half, 0}}, wall, 0);
    const double flat = r.chance(0.3) ? r.uniform(0.3, 0.7) * half : 0.0;
    Path roof = {{-half - over, eaves}, {-flat, ridge}, {flat, ridge}, {half + over, eaves}};
    if (flat == 0.0) roof.erase(roof.begin() + 2);
    const int top = add_area(b, roof, r.chance(0.7) ? Crayon::red : Crayon::brown, 1);
    if (r.chance(0.25))
        add_pattern(b, top, {{0, 0.5 * (eaves + ridge)}, 0.6 * half, 0.4 * pitch, 0}, "hatching");
    if (r.chance(0.6)) add_chimney(b, half, eaves, ridge);
    const double door = r.uniform(-0.35, 0.35) * half, width = r.uniform(4, 6),
                 tall = r.uniform(0.4, 0.6) * height;
    const int leaf =
        add_area(b, {{door - width, 0}, {door - width, -tall}, {door + width, -tall}, {door + width, 0}},
                 Crayon::brown, 3);
    if (r.chance(0.6)) b.spot(leaf, ellipse({door + 0.6 * width, -0.5 * tall}, 0.8, 0.8));
    const double size = r.uniform(0.28, 0.42) * half, y = -r.uniform(0.62, 0.75) * height;
    for (int side = -1; side <= 1; side += 2)
        if (r.chance(0.85)) add_window(b, 0.6 * side * half, y, size);
    if (r.chance(0.3)) add_window(b, 0, eaves - 0.35 * pitch, 0.7 * size);
}

void tree(Builder& b) {
    Random& r = b.random;
    const double height = r.uniform(22, 42), width = r.uniform(3, 6), size = r.uniform(14, 24);
    const double lean = r.uniform(-3, 3);
    if (r.chance(0.15)) { // bare branches
        add_line(b, {{0, 0}, {lean, -height}}, Crayon::brown);
        for (int i = 0, n = r.integer(4, 8); i < n; ++i) {
            const double y = -height * r.uniform(0.35, 1.0), angle = -0.5 * pi + r.uniform(-0.9, 0.9);
            const Point2d start{-lean * y / height, y};
            add_line(b, {start, start + r.uniform(8, 18) * direction(angle)}, Crayon::brown);
        }
        return;
    }
    add_area(b,
             spline({{-1.5 * width, 0},
                     {-width, -0.3 * height},
                     {lean - width, -height},
                     {lean + width, -height},
                     {width, -0.3 * height},
                     {1.5 * width, 0}},
                    false, 5),
             Crayon::brown, 0);
    const Frame crown{{lean, -height - 0.6 * size}, size * r.uniform(0.85, 1.25), size, 0};
    const int bumps = r.integer(7, 12);
    const int leaves = r.chance(0.65)
                           ? add_area(b, fluffy(r, crown, bumps), Crayon::green, 1)
                           : add_area(b, ellipse(crown.centre, crown.rx, crown.ry), Crayon::green, 1);
    if (!r.chance(0.35)) return;
    for (int i = 0, n = r.integer(3, 8); i < n; ++i) {
        const double u = r.uniform(-0.7, 0.7), v = r.uniform(-0.7, 0.7);
        b.mark(leaves, ellipse(crown.at(u, v), 1.8, 1.8), true);
    }
}

void fir(Builder& b) {
    Random& r = b.random;
    const int tiers = r.integer(1, 4);
    const double tall = r.uniform(14, 20), width = r.uniform(11, 18);
    add_area(b, {{-3, 0}, {-3, -9}, {3, -9}, {3, 0}}, Crayon::brown, 0);
    double foot = -8;
    for (int i = 0; i < tiers; ++i) {
        const double half = width * (1.0 - 0.18 * i), height = tiers == 1 ? 2.5 * tall : tall;
        add_area(b, {{-half, foot}, {0, foot - height}, {half, foot}}, Crayon::green, 1 + i);
        foot -= 0.6 * height;
    }
}

void flower(Builder& b) {
    Random& r = b.random;
    const double height = r.uniform(22, 45), bend = r.uniform(-5, 5), size = r.uniform(4, 7);
    const Point2d head{0, -height};
    const Crayon crayon =
        r.pick(std::vector<Crayon>{Crayon::red, Crayon::pink, Crayon::orange, Crayon::blue});
    add_line(b, spline({{0, 0}, {bend, -0.5 * height}, head}, false), Crayon::green, -2);
    for (int side = -1; side <= 1; side += 2) {
        if (!r.chance(0.6)) continue;
        const double y = -height * r.uniform(0.2, 0.5);
        const Point2d stem{0.8 * bend, y};
        add_area(b, ellipse(stem + Point2d{side * 6.0, -3}, 6.5, 2.4, -0.5 * side), Crayon::green, -1);
    }
    if (r.chance(0.25)) { // a tulip
        add_area(b,
                 {head + Point2d{-7, -12}, head + Point2d{-3, -6}, head + Point2d{0, -13},
                  head + Point2d{3, -6}, head + Point2d{7, -12}, head + Point2d{6, 1}, head + Point2d{0, 4},
                  head + Point2d{-6, 1}},
                 crayon);
        return;
    }
    const int petals = r.integer(4, 9);
    const double reach = size * r.uniform(1.2, 1.7);
    for (int i = 0; i < petals; ++i) {
        const double a = 2 * pi * i / petals;
        add_area(b, ellipse(head + reach * direction(a), 0.8 * size, 3.2 * reach / petals, a), crayon);
    }
    const int middle = add_area(b, ellipse(head, 0.8 * size, 0.8 * size), Crayon::yellow, 1);
    if (r.chance(0.15)) add_frontal_face(b, middle, {head, 0.8 * size, 0.8 * size, 0});
}

// From the left to the right end of a strip of width 200 around y = 0.
void grass_line(Builder& b) {
    Random& r = b.random;
    const int kind = r.integer(0, 3), blades = r.integer(14, 60);
    const double tall = r.uniform(3, 9), wave = r.uniform(0, 3);
    Path line;
    for (int i = 0; i <= blades; ++i) {
        const double t = static_cast<double>(i) / blades, x = -100 + 200 * t;
        const double y = wave * math::sin(7.0 * t);
        line.push_back({x, y});
        if (kind >= 2 || i == blades) continue;
        const double lean = r.uniform(0.2, 0.8), height = tall * r.uniform(0.6, 1.2);
        line.push_back({x + 200.0 * lean / blades, y - height});
        if (kind == 1 && r.chance(0.4)) line.push_back({x + 160.0 / blades, y}); // now and then a flat piece
    }
    add_line(b, kind == 2 ? spline(line, false) : line, Crayon::green);
    if (kind != 3) return;
    for (int i = 0; i < blades; ++i) { // a straight line with blades that stand on it
        const double x = r.uniform(-98, 98), height = tall * r.uniform(0.5, 1.2), lean = r.uniform(-2, 2);
        const double y = wave * math::sin(7.0 * (x + 100) / 200);
        add_line(b, {{x, y}, {x + lean, y - height}}, Crayon::green);
    }
}

void grass_tuft(Builder& b) {
    Random& r = b.random;
    for (int i = 0, n = r.integer(3, 9); i < n; ++i) {
        const double spread = n > 1 ? 2.0 * i / (n - 1) - 1.0 : 0.0, height = r.uniform(8, 20);
        const Point2d foot{5 * spread, 0}, tip{13 * spread, -height};
        add_line(b, spline({foot, mix(foot, tip, 0.5) + Point2d{-2 * spread, -1}, tip}, false),
                 Crayon::green);
    }
}

void hill(Builder& b) {
    Random& r = b.random;
    const int humps = r.integer(1, 3);
    Path crest;
    for (int i = 0; i <= 2 * humps; ++i) {
        const double x = -100 + 100.0 * i / humps;
        crest.push_back({x, i % 2 ? -r.uniform(18, 45) : -r.uniform(0, 6)});
    }
    Path outline = spline(crest, false, 12);
    Outline area{outline, std::vector<char>(outline.size(), 0), true};
    area.undrawn.back() = 1;
    for (double x : {100.0, -100.0}) area.points.push_back({x, 6}), area.undrawn.push_back(1);
    const int index = b.region(Label::background, area);
    b.part(index).paint = static_cast<int>(Crayon::green);
}

void mountain(Builder& b) {
    Random& r = b.random;
    for (int i = 0, n = r.integer(1, 3); i < n; ++i) {
        const double x = 30.0 * i, half = r.uniform(18, 32), height = r.uniform(28, 55);
        const Point2d left{x - half, 0}, top{x + r.uniform(-5, 5), -height}, right{x + half, 0};
        const int peak = add_area(b, {left, top, right}, r.chance(0.5) ? Crayon::grey : Crayon::brown, i);
        if (!r.chance(0.6)) continue;
        Path snow;
        for (int k = 0; k <= 6; ++k) {
            const Point2d p = mix(mix(top, left, 0.35), mix(top, right, 0.35), k / 6.0);
            snow.push_back(p + Point2d{0, (k % 2 && k < 6) ? 0.1 * height : 0.0});
        }
        b.mark(peak, snow);
    }
}

void fence(Builder& b) {
    Random& r = b.random;
    const int slats = r.integer(4, 12);
    const double tall = r.uniform(16, 28), width = r.uniform(2.5, 5.0), pitch = width + r.uniform(2, 7);
    const bool pointed = r.chance(0.7), lines = r.chance(0.25);
    for (double y : {-0.3 * tall, -0.7 * tall})
        add_line(b, {{-0.5 * pitch, y}, {pitch * slats, y}}, Crayon::brown, -1);
    for (int i = 0; i < slats; ++i) {
        const double x = pitch * i, top = -tall * r.uniform(0.95, 1.05);
        if (lines) {
            add_line(b, {{x, 0}, {x, top}}, Crayon::brown);
            continue;
        }
        Path slat = {{x, 0},
                     {x, top},
                     {x + 0.5 * width, top - (pointed ? width : 0.0)},
                     {x + width, top},
                     {x + width, 0}};
        add_area(b, slat, Crayon::brown);
    }
}

} // namespace

const ThingTable& scenery_things() {
    static const ThingTable table = {{"house", house},
                                     {"tree", tree},
                                     {"fir", fir},
                                     {"flower", flower},
                                     {"grass line", grass_line},
                                     {"grass tuft", grass_tuft},
                                     {"hill", hill},
                                     {"mountain", mountain},
                                     {"fence", fence}};
    return table;
}

} // namespace pantin::doodle
