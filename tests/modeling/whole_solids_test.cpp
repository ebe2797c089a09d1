// SPDX-License-Identifier: MIT
// Whatever is drawn: one closed solid with the handles of the drawing, all parts and all joints in it. The
// checks know nothing of how the solid is made.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "core/random.hpp"
#include "modeling/solids.hpp"
#include "pantin/model.hpp"

using namespace pantin;

namespace {

using Line = std::vector<Point2d>;

Point2d way(double angle) { return {math::cos(angle), math::sin(angle)}; }

struct Drawing {
    std::string name;
    std::vector<PartStroke> parts;
    int handles = 0, pieces = 1;

    Drawing& add(const std::string& part, const Line& stroke, double depth = 0, double height = 1) {
        parts.push_back(test::part(part + std::to_string(parts.size()), stroke));
        parts.back().depth = depth;
        parts.back().height = height;
        return *this;
    }
};

// What is wrong with a model's solid; empty: nothing.
std::string fault_of(Model& model, const SolidMesh& mesh, int handles, int pieces, int hidden = 0) {
    if (const std::string fault = test::surface_fault(mesh); !fault.empty()) return fault;
    if (mesh.triangle_parts.size() != mesh.triangles.size()) return "triangles without a part";
    if (test::volume_of(mesh) <= 0) return "inside out";
    if (const int found = test::components_of(mesh); found != pieces)
        return std::to_string(found) + " pieces for " + std::to_string(pieces);
    if (const int found = test::genus_of(mesh); found != handles)
        return std::to_string(found) + " handles for " + std::to_string(handles);
    std::vector<char> seen(model.parts().size(), 0);
    for (const int part : mesh.triangle_parts) seen[static_cast<std::size_t>(part)] = 1;
    if (std::count(seen.begin(), seen.end(), 0) > hidden) return "a part is missing";
    const auto& joints = model.skeleton().joints;
    const std::size_t step = 1 + joints.size() / 250; // of a very long chain some
    double widest = 0;
    for (const Vec3& vertex : mesh.vertices) widest = std::max(widest, length(vertex));
    for (std::size_t j = 0; j < joints.size(); j += step)
        // (What is narrower than the ten-thousandth that unite() takes off a part has no inside.)
        if (joints[j].radius > 1e-4 * widest && test::winding_of(mesh, joints[j].place) < 0.5)
            return "a joint is outside";
    return "";
}

std::string fault_of(const Drawing& drawing) {
    Model model;
    for (const PartStroke& part : drawing.parts) model.add_part(part);
    return fault_of(model, model.united(), drawing.handles, drawing.pieces);
}

Line bent(Point2d from, Point2d to, double radius, double bow, int corners = 30) {
    const Point2d u = to - from, v{-u.y, u.x};
    Line line, back;
    for (int i = 0; i <= corners; ++i) {
        const double t = static_cast<double>(i) / corners;
        const Point2d axis = from + t * u + (bow * math::sin(math::pi * t)) * v;
        const Point2d n = (1 / length(v)) * v;
        const double r = radius * std::sqrt(std::max(0.05, 1 - (2 * t - 1) * (2 * t - 1)));
        line.push_back(axis + r * n), back.push_back(axis - r * n);
    }
    line.insert(line.end(), back.rbegin(), back.rend());
    return line;
}

// --- gaps, slits and thin parts -----------------------------------------------------------------

Drawing heart(double cleft) {
    Drawing d{"heart", {}};
    Line line;
    for (int i = 0; i < 200; ++i) {
        const double t = 2 * math::pi * (i + 0.5) / 200, s = math::sin(t);
        line.push_back({100 * s * s * s + (s > 0 ? cleft : -cleft) * 0.5,
                        -80 * math::cos(t) + 35 * math::cos(2 * t) + 15 * math::cos(3 * t)});
    }
    return d.add("heart", line);
}
Drawing slit(double width) {
    const double x = 50 - 0.5 * width, y = 50 + 0.5 * width;
    Drawing d{"slit", {}};
    return d.add("plate", {{0, 0}, {x, 0}, {x, 80}, {y, 80}, {y, 0}, {100, 0}, {100, 100}, {0, 100}});
}
Drawing touching() {
    Drawing d{"touching", {}};
    d.pieces = 2;
    return d.add("body", {{0, 0}, {10, 0}, {10, 10}, {0, 10}})
        .add("arm", {{10, 0}, {20, 0}, {20, 10}, {10, 10}});
}
Drawing hand(double gap) { // between the fingers where they leave the palm
    Drawing d{"hand", {}};
    d.add("palm", test::disc({0, 0}, 60, 80));
    const double step = 2 * std::asin((8 + 0.5 * gap) / 52);
    for (int f = 0; f < 4; ++f) {
        const double a = -0.5 * math::pi + (f - 1.5) * step;
        d.add("finger", bent(45 * way(a), 150 * way(a), 8, 0));
    }
    return d.add("thumb", bent({40, 20}, {110, -10}, 9, 0.1));
}
Drawing whiskers(double width) {
    Drawing d{"whiskers", {}};
    d.add("head", test::disc({0, 0}, 100));
    for (const double side : {-1.0, 1.0})
        for (const double a : {-0.2, 0.05, 0.3})
            d.add("whisker", bent({60 * side, 40 * a}, {240 * side, 300 * a}, 0.5 * width, 0.05));
    return d;
}
Drawing stick_figure(double width) {
    Drawing d{"stick figure", {}};
    d.add("head", test::disc({100, 40}, 22)).add("body", test::capsule({100, 58}, {100, 150}, width));
    d.add("arm", test::capsule({100, 85}, {40, 110}, width))
        .add("arm", test::capsule({100, 85}, {160, 110}, width));
    return d.add("leg", test::capsule({100, 149}, {60, 240}, width))
        .add("leg", test::capsule({100, 149}, {140, 240}, width));
}
Drawing star(int arms, double inner) {
    Drawing d{"star", {}};
    Line line;
    for (int i = 0; i < 2 * arms; ++i) line.push_back((i % 2 == 0 ? 100 : inner) * way(math::pi * i / arms));
    return d.add("star", line);
}

// --- others ------------------------------------------------------------------------------------------------

Drawing hedgehog(int spikes, Random& random) {
    Drawing d{"hedgehog", {}};
    d.add("body", test::blob(random, 2, 0.15));
    for (int s = 0; s < spikes; ++s) {
        const double a = math::pi * (1 + (s + 0.5) / spikes);
        d.add("spike", {60 * way(a - 0.03), (140 + random.uniform(0, 40)) * way(a), 60 * way(a + 0.03)},
              random.uniform(-20, 20), 0.6);
    }
    return d;
}
Drawing spider(int pairs, double width) {
    Drawing d{"spider", {}};
    d.add("body", test::disc({0, 0}, 50));
    for (int leg = 0; leg < 2 * pairs; ++leg) {
        const double a = 2 * math::pi * (leg + 0.5) / (2 * pairs);
        d.add("thigh", test::capsule(35 * way(a), 120 * way(a), width));
        d.add("shin", test::capsule(118 * way(a), 118 * way(a) + 80 * way(a + 0.5), 0.7 * width));
    }
    return d;
}
Drawing comb(int teeth, double gap) {
    Drawing d{"comb", {}};
    Line line{{0, 0}, {0, 130}};
    const double step = 300.0 / teeth;
    for (int t = 0; t < teeth; ++t) {
        const double x = t * step;
        if (t > 0) line.insert(line.end(), {{x, 30}, {x, 130}});
        line.insert(line.end(), {{x + step - gap, 130}, {x + step - gap, 30}});
    }
    line.insert(line.end(), {{300 - gap + 8, 30}, {300 - gap + 8, 0}});
    return d.add("comb", line);
}
// Letters of strips: with the loops that one sees.
Drawing letter(const std::string& name, const std::vector<std::pair<Point2d, Point2d>>& strips, int loops,
               double width) {
    Drawing d{"letter " + name, {}, loops};
    for (const auto& [from, to] : strips) d.add("strip", test::capsule(from, to, width));
    return d;
}
std::vector<std::pair<Point2d, Point2d>> polyline(const Line& line) {
    std::vector<std::pair<Point2d, Point2d>> strips;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) strips.emplace_back(line[i], line[i + 1]);
    return strips;
}
Drawing ring(int strips, double width) {
    Line line;
    for (int i = 0; i <= strips; ++i) line.push_back(100 * way(2 * math::pi * (i % strips) / strips));
    return letter("O", polyline(line), 1, width);
}
Drawing snake(double width, double waves) {
    Drawing d{"snake", {}};
    Line line, back;
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0, x = 400 * t, y = 40 * math::sin(2 * math::pi * waves * t);
        const double slope = 40 * 2 * math::pi * waves / 400 * math::cos(2 * math::pi * waves * t);
        const Point2d n = (width / std::sqrt(1 + slope * slope)) * Point2d{-slope, 1};
        line.push_back(Point2d{x, y} + n), back.push_back(Point2d{x, y} - n);
    }
    line.insert(line.end(), back.rbegin(), back.rend());
    return d.add("snake", line);
}
void add_branches(Drawing& d, Point2d from, double angle, double size, int depth) {
    const Point2d to = from + size * way(angle);
    d.add("branch", bent(from - 0.1 * size * way(angle), to, 0.09 * size, 0.05));
    if (depth == 0) return;
    for (const double turn : {-0.5, 0.6})
        add_branches(d, from + 0.93 * size * way(angle), angle + turn, 0.6 * size, depth - 1);
}
Drawing bush(int depth) {
    Drawing d{"bush", {}};
    add_branches(d, {0, 0}, -0.5 * math::pi, 100, depth);
    return d;
}

} // namespace

TEST_CASE("gaps do not close, thin parts do not break: each drawing is one solid") {
    std::vector<Drawing> drawings = {heart(2), heart(0.2), touching(), star(5, 40), star(8, 15)};
    for (const double width : {8.0, 2.0, 0.5, 0.05}) drawings.push_back(slit(width));
    for (const double gap : {4.0, 1.0, 0.2}) drawings.push_back(hand(gap));
    for (const double width : {8.0, 2.0, 0.96}) drawings.push_back(whiskers(width));
    for (const double width : {3.0, 1.0, 0.4}) drawings.push_back(stick_figure(width));
    for (const Drawing& drawing : drawings) {
        CAPTURE(drawing.name, &drawing - drawings.data());
        CHECK(fault_of(drawing) == "");
    }
}

TEST_CASE("hedgehogs, spiders, combs, letters, snakes and bushes are one solid each") {
    Random random(201);
    std::vector<Drawing> drawings;
    for (const int spikes : {10, 25, 40}) drawings.push_back(hedgehog(spikes, random));
    for (const double width : {8.0, 3.0, 1.0})
        for (const int pairs : {3, 4}) drawings.push_back(spider(pairs, width));
    for (const int teeth : {4, 8, 15})
        for (const double gap : {6.0, 1.0, 0.2}) drawings.push_back(comb(teeth, gap));
    for (const double width : {12.0, 5.0, 1.5}) {
        drawings.push_back(ring(9, width));
        drawings.push_back(
            letter("A", {{{0, 100}, {50, 0}}, {{50, 0}, {100, 100}}, {{25, 50}, {75, 50}}}, 1, width));
        auto eight = polyline({{0, 0}, {70, 0}, {70, 160}, {0, 160}, {0, 0}});
        eight.push_back({{0, 80}, {70, 80}});
        drawings.push_back(letter("B", eight, 2, width));
        drawings.push_back(letter("Z", polyline({{0, 0}, {90, 0}, {0, 120}, {90, 120}}), 0, width));
    }
    for (const double width : {10.0, 3.0, 0.8})
        for (const double waves : {1.0, 3.0}) drawings.push_back(snake(width, waves));
    for (const int depth : {1, 2, 3, 4}) drawings.push_back(bush(depth));
    CHECK(drawings.size() >= 40);
    for (const Drawing& drawing : drawings) {
        CAPTURE(drawing.name, &drawing - drawings.data());
        CHECK(fault_of(drawing) == "");
    }
}

TEST_CASE("random strokes that cross themselves are one solid without handles") {
    Random random(202);
    int wrong = 0;
    for (int round = 0; round < 200; ++round) {
        Line line;
        const int corners = random.integer(5, 24);
        for (int i = 0; i < corners; ++i) line.push_back({random.uniform(0, 300), random.uniform(0, 200)});
        Model model;
        model.add_part(test::part("scribble", line));
        wrong += !fault_of(model, model.united(), 0, 1).empty();
    }
    CHECK(wrong == 0);
}

TEST_CASE("parts in random places are united to closed solids") {
    Random random(203);
    for (int round = 0; round < 20; ++round) {
        Model model;
        for (int p = 0; p < 12; ++p) {
            const Point2d at{random.uniform(0, 200), random.uniform(0, 200)};
            PartStroke part =
                test::part("part" + std::to_string(p),
                           test::capsule(at, at + random.uniform(5, 120) * way(random.uniform(0, 6)),
                                         random.uniform(1, 20)));
            part.depth = 5 * random.integer(-2, 2);
            part.symmetry = round % 2 == 0 || part.depth == 0 ? Symmetry::none : Symmetry::z;
            model.add_part(part);
        }
        const SolidMesh mesh = model.united();
        CAPTURE(round);
        CHECK(test::surface_fault(mesh) == "");
        CHECK(test::self_cuts(mesh) == 0);
        CHECK(test::volume_of(mesh) > 0);
    }
}

TEST_CASE("each of the nine models has the handles of its drawing and its joints inside", "[needs-pugixml]") {
    for (const std::string& name : test::model_names) {
        Model model(test::model_strokes(name));
        CAPTURE(name);
        CHECK(fault_of(model, model.united(), name == "tree" ? 4 : 0, 1) == "");
    }
}

// --- large and odd -----------------------------------------------------------------------------------------

TEST_CASE("a chain of 200 parts, a needle and a stroke of 200,000 points are solids") {
    Drawing chain{"chain", {}};
    for (int link = 0; link < 200; ++link)
        chain.add("link", test::capsule({10.0 * link, 0}, {10.0 * link + 12, 3}, 4));
    CHECK(fault_of(chain) == "");
    Drawing needle{"needle", {}};
    CHECK(fault_of(needle.add("needle", {{0, 0}, {1000, 0}, {1000, 3}, {0, 3}})) == "");
    Drawing fine{"fine", {}};
    CHECK(fault_of(fine.add("disc", test::disc({0, 0}, 100, 200'000))) == "");
}

TEST_CASE("the unit of the strokes changes nothing but the size") {
    const Drawing figure = stick_figure(3);
    std::size_t triangles = 0;
    for (const double unit : {1.0, 1e-6, 1e6}) {
        Model model;
        for (PartStroke part : figure.parts) {
            for (Point2d& p : part.stroke) p = unit * p;
            model.add_part(part);
        }
        SolidMesh mesh = model.united();
        CAPTURE(unit);
        CHECK(fault_of(model, mesh, 0, 1) == "");
        if (triangles == 0) triangles = mesh.triangles.size();
        CHECK(mesh.triangles.size() == Approx(triangles).epsilon(0.05));
    }
}
