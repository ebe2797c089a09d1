// SPDX-License-Identifier: MIT
// Strokes as JSON and SVG: read, written, put right, refused.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/math.hpp"
#include "core/random.hpp"
#include "geometry/extent.hpp"
#include "modeling/svg_path.hpp"
#include "pantin/error.hpp"
#include "pantin/strokes.hpp"

using namespace pantin;

namespace {

using Line = std::vector<Point2d>;

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        const std::string message = error.what();
        CHECK(message.find('\n') == std::string::npos);
        return message;
    }
    return "no error";
}

// --- paths -------------------------------------------------------------------------------------------------

std::vector<Subpath> subpaths(const std::string& data, const Affine& transform = {}) {
    return svg_path(data, transform, "d");
}

Line path(const std::string& data, const Affine& transform = {}) {
    const std::vector<Subpath> all = subpaths(data, transform);
    REQUIRE(all.size() == 1);
    return all[0].points;
}

std::string path_error(const std::string& data) {
    return message_of([&] { subpaths(data); });
}

double distance_to_line(const Line& line, Point2d p) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point2d a = line[i - 1], v = line[i] - a;
        const double t = dot(v, v) > 0 ? std::clamp(dot(p - a, v) / dot(v, v), 0.0, 1.0) : 0;
        nearest = std::min(nearest, distance(p, a + t * v));
    }
    return nearest;
}

// Each point of the curve lies on the line up to the promised error, each corner of the line lies on the
// curve.
void check_curve(const Line& line, const std::function<Point2d(double)>& curve) {
    REQUIRE(line.size() >= 2);
    const double allowed = diagonal_of(line) / 2000 * 1.0001;
    Line fine;
    for (int k = 0; k <= 20000; ++k) fine.push_back(curve(k / 20000.0));
    CHECK(line.front() == fine.front());
    CHECK(distance(line.back(), fine.back()) < 1e-12 * (1 + length(fine.back())));
    double farthest = 0, off = 0;
    for (std::size_t k = 0; k < fine.size(); k += 37)
        farthest = std::max(farthest, distance_to_line(line, fine[k]));
    for (const Point2d p : line) off = std::max(off, distance_to_line(fine, p));
    CHECK(farthest <= allowed);
    CHECK(off < 1e-6 * diagonal_of(line));
}

Point2d cubic(Point2d a, Point2d b, Point2d c, Point2d d, double t) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}
Point2d quadratic(Point2d a, Point2d b, Point2d c, double t) {
    return (1 - t) * (1 - t) * a + 2 * (1 - t) * t * b + t * t * c;
}

// All corners lie on the ellipse, neighbours are near; gives the total turn about its centre in degrees,
// positive from x to y.
double check_arc(const Line& line, Point2d centre, double rx, double ry, double degrees = 0) {
    const double angle = degrees * math::pi / 180, c = math::cos(angle), s = math::sin(angle);
    double turn = 0, off = 0, widest = 0;
    Point2d last;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Point2d d = line[i] - centre;
        const Point2d unit = {(c * d.x + s * d.y) / rx, (c * d.y - s * d.x) / ry};
        off = std::max(off, std::abs(length(unit) - 1));
        if (i > 0) {
            const double step = math::atan2(cross(last, unit), dot(last, unit));
            widest = std::max(widest, std::abs(step));
            turn += step;
        }
        last = unit;
    }
    CHECK(off < 1e-9);
    CHECK(widest < 0.2);
    return turn * 180 / math::pi;
}

// --- drawings and files ------------------------------------------------------------------------------------

const std::string square = "[[0, 0], [10, 0], [10, 10], [0, 10]]";

std::string part_text(const std::string& name, const std::string& more = "") {
    return "{\"name\": \"" + name + "\", \"stroke\": " + square + (more.empty() ? "" : ", " + more) + "}";
}
std::string file_text(const std::string& parts, const std::string& calls = "") {
    return "{\"parts\": [" + parts + "]" + (calls.empty() ? "" : ", \"calls\": [" + calls + "]") + "}";
}
Strokes json(const std::string& text) { return strokes_from_json(text, "strokes.json"); }
std::string json_error(const std::string& text) {
    return message_of([&] { json(text); });
}
std::string part_error(const std::string& more) { return json_error(file_text(part_text("tail", more))); }
std::string call_error(const std::string& call) { return json_error(file_text(part_text("tail"), call)); }

std::string svg_text(const std::string& inside, const std::string& attributes = "") {
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"x\" " +
           attributes + ">\n" + inside + "\n</svg>\n";
}
Strokes svg(const std::string& inside, const std::string& attributes = "") {
    return strokes_from_svg(svg_text(inside, attributes), "drawing.svg");
}
std::string svg_error(const std::string& inside, const std::string& attributes = "") {
    return message_of([&] { svg(inside, attributes); });
}
const PartStroke& part_of(const Strokes& strokes, std::size_t i) {
    REQUIRE(i < strokes.calls.size());
    REQUIRE(std::holds_alternative<PartStroke>(strokes.calls[i]));
    return std::get<PartStroke>(strokes.calls[i]);
}
// The only part of a drawing that holds this shape.
PartStroke shape(const std::string& inside) {
    const Strokes strokes = svg(inside);
    REQUIRE(strokes.calls.size() == 1);
    return part_of(strokes, 0);
}
bool near(const Line& line, const Line& expected) {
    if (line.size() != expected.size()) return false;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (distance(line[i], expected[i]) > 1e-12 * (1 + length(expected[i]))) return false;
    return true;
}
const std::string triangle = "d=\"M0 0 10 0 0 10Z\"";

using Lines = std::vector<std::string>;

} // namespace

// --- path data ---------------------------------------------------------------------------------------------

TEST_CASE("Straight commands of a path give the points computed by hand") {
    const Line corner = {{1, 2}, {4, 6}, {4, 0}};
    CHECK(path("M1 2 L4 6 L4 0") == corner);
    CHECK(path("M1,2L4,6,4,0") == corner);
    CHECK(path("M 1 2 4 6 4 0") == corner);
    CHECK(path("m1 2 l3 4 l0-6") == corner);
    CHECK(path("m1 2 3 4 0-6") == corner);
    CHECK(path("\t\n M1 2\r\nl 3 4\f0 -6 \n") == corner);
    CHECK(path("M1 2 H5 V7 H-1") == Line{{1, 2}, {5, 2}, {5, 7}, {-1, 7}});
    CHECK(path("M1 2 h4 v5 h-6") == Line{{1, 2}, {5, 2}, {5, 7}, {-1, 7}});
    CHECK(path("M0 0H1 2 3V4 5") == Line{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 4}, {3, 5}});
    CHECK(path("M0 0h1 2 3v4 5") == Line{{0, 0}, {1, 0}, {3, 0}, {6, 0}, {6, 4}, {6, 9}});
    CHECK(path("M3 4") == Line{{3, 4}});
}

TEST_CASE("Numbers of a path need no more separators than SVG asks for") {
    CHECK(path("M.5.5-1-2") == Line{{0.5, 0.5}, {-1, -2}});
    CHECK(path("M1e-3-2E+2L+3.25-.5e1") == Line{{0.001, -200}, {3.25, -5}});
    CHECK(path("M0.5.25.125 1") == Line{{0.5, 0.25}, {0.125, 1}});
    CHECK(path("M1. 2.,3 4") == Line{{1, 2}, {3, 4}});
    CHECK(path("M 1 , 2 L\n3\t,\n4") == Line{{1, 2}, {3, 4}});
    CHECK(path("M0.1 0.2") == Line{{0.1, 0.2}});
}

TEST_CASE("Z closes a subpath, and what follows begins where it began") {
    std::vector<Subpath> all = subpaths("M1 1 L5 1 5 5 Z");
    REQUIRE(all.size() == 1);
    CHECK(all[0].closed);
    CHECK(all[0].points == Line{{1, 1}, {5, 1}, {5, 5}});
    all = subpaths("M1 1 L5 1 5 5 z m2 2 l1 0 0 1 z l-1-1 M0 0h1");
    REQUIRE(all.size() == 4);
    CHECK(all[1].points == Line{{3, 3}, {4, 3}, {4, 4}});
    CHECK(all[1].closed);
    CHECK(all[2].points == Line{{3, 3}, {2, 2}});
    CHECK_FALSE(all[2].closed);
    CHECK(all[3].points == Line{{0, 0}, {1, 0}});
    CHECK(subpaths("M0 0L1 0 1 1ZZ").size() == 1);
    CHECK(subpaths("m1 1 2 0 m 1 1 1 0")[1].points == Line{{4, 2}, {5, 2}});
    CHECK(subpaths("").empty());
    CHECK(subpaths(" \n").empty());
    CHECK(subpaths("none").empty());
}

TEST_CASE("Bézier curves stay within 1/2000 of the diagonal, and their corners lie on them") {
    const Point2d a{0, 0}, b{10, 40}, c{60, -30}, d{80, 20};
    const auto curve = [&](double t) { return cubic(a, b, c, d, t); };
    check_curve(path("M0 0C10 40 60-30 80 20"), curve);
    check_curve(path("m0 0c10 40 60-30 80 20"), curve);
    check_curve(path("M0 0Q30 50 80 20"), [&](double t) { return quadratic(a, {30, 50}, d, t); });
    check_curve(path("M5 5q30 50 80 20"), [](double t) { return quadratic({5, 5}, {35, 55}, {85, 25}, t); });
    const Line line = path("M0 0C10 40 60-30 80 20");
    CHECK(line.size() > 10);
    CHECK(line.size() < 100);
    // A straight curve is one chord.
    CHECK(path("M0 0C1 1 2 2 3 3") == Line{{0, 0}, {3, 3}});
    CHECK(path("M0 0Q1 1 2 2") == Line{{0, 0}, {2, 2}});
    CHECK(path("M1 1C1 1 1 1 1 1") == Line{{1, 1}, {1, 1}});
}

TEST_CASE("The number of chords depends on the shape alone, not on its unit") {
    const std::size_t count = path("M0 0C10 40 60-30 80 20").size();
    for (const double unit : {1e-6, 1e-3, 1024.0, 1e9})
        CHECK(path("M0 0C10 40 60-30 80 20", {unit, 0, 0, unit, 0, 0}).size() == count);
}

TEST_CASE("S and T mirror the control point before them, but only of a curve of their own kind") {
    const auto join = [](const std::function<Point2d(double)>& a, const std::function<Point2d(double)>& b) {
        return [a, b](double t) { return t < 0.5 ? a(2 * t) : b(2 * t - 1); };
    };
    const auto first = [](double t) { return cubic({0, 0}, {0, 10}, {10, 20}, {20, 10}, t); };
    const auto second = [](double t) { return cubic({20, 10}, {30, 0}, {40, 5}, {50, 10}, t); };
    check_curve(path("M0 0C0 10 10 20 20 10S40 5 50 10"), join(first, second));
    check_curve(path("M0 0C0 10 10 20 20 10s20-5 30 0"), join(first, second));
    const auto third = [](double t) { return cubic({50, 10}, {60, 15}, {70, 0}, {60, -20}, t); };
    const auto third_after = [&](double t) {
        return t < 2 / 3.0 ? join(first, second)(1.5 * t) : third(3 * t - 2);
    };
    check_curve(path("M0 0C0 10 10 20 20 10S40 5 50 10 70 0 60-20"), third_after);
    // After anything else the control point is the point itself.
    check_curve(path("M0 0S10 30 20 0"), [](double t) {
        return cubic({0, 0}, {0, 0}, {10, 30}, {20, 0}, t);
    });
    const auto lone = [](double t) { return cubic({20, 0}, {20, 0}, {30, 30}, {40, 0}, t); };
    const auto before = [](double t) { return quadratic({0, 0}, {10, -9}, {20, 0}, t); };
    check_curve(path("M0 0Q10-9 20 0S30 30 40 0"), join(before, lone));

    const auto q1 = [](double t) { return quadratic({0, 0}, {10, 20}, {20, 0}, t); };
    const auto q2 = [](double t) { return quadratic({20, 0}, {30, -20}, {40, 0}, t); };
    const auto q3 = [](double t) { return quadratic({40, 0}, {50, 20}, {60, 10}, t); };
    check_curve(path("M0 0Q10 20 20 0T40 0"), join(q1, q2));
    check_curve(path("M0 0q10 20 20 0t20 0 20 10"),
                [&](double t) { return t < 2 / 3.0 ? join(q1, q2)(1.5 * t) : q3(3 * t - 2); });
    for (const Point2d p : path("M0 0T10 5")) CHECK(p.x == Approx(2 * p.y));
    CHECK(path("M0 0C0 5 5 5 5 0T10 5").back() == Point2d{10, 5});
}

TEST_CASE("Arcs lie on their ellipse and turn the way the flags ask for") {
    const Point2d middle{0, 0};
    CHECK(check_arc(path("M10 0A10 10 0 0 1 0 10"), middle, 10, 10) == Approx(90));
    CHECK(check_arc(path("M10 0A10 10 0 1 0 0 10"), middle, 10, 10) == Approx(-270));
    CHECK(check_arc(path("M10 0A10 10 0 0 0 0 10"), {10, 10}, 10, 10) == Approx(-90));
    CHECK(check_arc(path("M10 0A10 10 0 1 1 0 10"), {10, 10}, 10, 10) == Approx(270));
    CHECK(check_arc(path("M10 0a10 10 0 0 1-10 10"), middle, 10, 10) == Approx(90));
    CHECK(check_arc(path("M10 0A10 10 0 0 1-10 0"), middle, 10, 10) == Approx(180));
    CHECK(check_arc(path("M10 0A10 10 0 0 0-10 0"), middle, 10, 10) == Approx(-180));
    CHECK(check_arc(path("M10 0A10 10 0 0 1-10 0 10 10 0 0 1 10 0"), middle, 10, 10) == Approx(360));
    CHECK(check_arc(path("M20 0A20 10 0 0 1 0 10"), middle, 20, 10) == Approx(90));
    CHECK(check_arc(path("M0 20A20 10 90 0 1-10 0"), middle, 20, 10, 90) == Approx(90));
    const double c = math::cos(math::pi / 6),
                 s = math::sin(math::pi / 6); // the ends of both axes of an ellipse turned by 30°
    const Affine turned = {c, s, -s, c, 3, -4};
    CHECK(check_arc(path("M20 0A20 10 0 0 1 0 10", turned), {3, -4}, 20, 10, 30) == Approx(90));
    const Line flat = path("M20 0A20 10 0 0 1 0 10", {1, 0, 0, 2, 0, 0});
    CHECK(check_arc(flat, middle, 20, 20) == Approx(90));
    CHECK(flat.back() == Point2d{0, 20});
    CHECK(flat.size() < 60);
}

TEST_CASE("A mirror turns an arc the other way round") {
    CHECK(check_arc(path("M10 0A10 10 0 0 1 0 10", {-1, 0, 0, 1, 0, 0}), {0, 0}, 10, 10) == Approx(-90));
    CHECK(check_arc(path("M10 0A10 10 0 1 0 0 10", {0, 1, 1, 0, 0, 0}), {0, 0}, 10, 10) == Approx(270));
}

TEST_CASE("Arcs out of range are put right as SVG's appendix B.2.5 says") {
    // Too small: the radii grow until the ends can be reached.
    CHECK(check_arc(path("M-10 0A1 1 0 0 1 10 0"), {0, 0}, 10, 10) == Approx(180));
    CHECK(check_arc(path("M-10 0A2 1 0 1 1 10 0"), {0, 0}, 10, 5) == Approx(180));
    CHECK(check_arc(path("M10 0A-10-10 0 0 1 0 10"), {0, 0}, 10, 10) == Approx(90));
    CHECK(path("M1 2A0 5 0 0 1 9 9") == Line{{1, 2}, {9, 9}});
    CHECK(path("M1 2A5 0 0 0 1 9 9") == Line{{1, 2}, {9, 9}});
    CHECK(path("M1 2A5 5 0 1 1 1 2L3 3") == Line{{1, 2}, {3, 3}});
    CHECK(path("M1 2A1e-300 1e-300 0 1 1 2 3") == Line{{1, 2}, {2, 3}});
    // Almost a whole circle, and almost nothing.
    CHECK(std::abs(check_arc(path("M10 0A10 10 0 1 1 10-1e-9"), {0, 0}, 10, 10)) == Approx(360));
    CHECK(std::abs(check_arc(path("M10 0A10 10 0 1 0 10 1e-9"), {0, 0}, 10, 10)) == Approx(360));
    CHECK(path("M10 0A10 10 0 0 1 10 1e-15").size() == 2);
    CHECK(path("M10 0A10 10 0 0 0 10 1e-15").size() == 2);
    CHECK(path("M0 0A1e12 1e12 0 0 1 10 0").size() == 2);
    CHECK(path("M0 0A1e15 1e15 0 1 1 1e-15 0").back() == Point2d{1e-15, 0});
}

TEST_CASE("An arc's flags need no separators") {
    const Line expected = path("M0 0a1 1 0 0 1 5 5");
    CHECK(path("M0 0a1 1 0 01 5 5") == expected);
    CHECK(path("M0 0a1 1 0 015 5") == expected);
    CHECK(path("M0 0a1,1,0,0,1,5,5") == expected);
    CHECK(path("M0 0a1 1 0 0,1 5 5") == expected);
    CHECK(path("M0 0a1 1 0 01.5.5") == path("M0 0a1 1 0 0 1 0.5 0.5"));
    CHECK(path("M0 0a1 1 0 015 5 1 1 0 105-5") == path("M0 0a1 1 0 0 1 5 5a1 1 0 1 0 5 -5"));
}

TEST_CASE("Random arcs satisfy the equation of their ellipse and the flags") {
    Random random(7);
    for (int round = 0; round < 200; ++round) {
        const double rx = random.uniform(1, 30), ry = random.uniform(1, 30),
                     degrees = random.uniform(-360, 360);
        const Point2d centre = {random.uniform(-50, 50), random.uniform(-50, 50)};
        const double start = random.uniform(-3, 3),
                     turn = random.uniform(0.1, 6.1) * (random.chance(0.5) ? 1 : -1);
        const double c = math::cos(degrees * math::pi / 180), s = math::sin(degrees * math::pi / 180);
        const auto at = [&](double angle) {
            const double x = rx * math::cos(angle), y = ry * math::sin(angle);
            return centre + Point2d{c * x - s * y, s * x + c * y};
        };
        const Point2d from = at(start), to = at(start + turn);
        if (std::abs(std::abs(turn) - math::pi) < 0.01) continue; // the flag of a half circle says nothing
        const auto text = [](double x) { return " " + std::to_string(x); };
        std::string data = "M 0 0 A" + text(rx) + text(ry) + text(degrees);
        data += std::abs(turn) > math::pi ? " 1" : " 0";
        data += turn > 0 ? " 1" : " 0";
        data += text(to.x - from.x) + text(to.y - from.y);
        const Line line = path(data);
        // Six decimals in the text leave the centre uncertain, the turn far less.
        double total = 0;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point2d p = from + line[i - 1] - centre, q = from + line[i] - centre;
            const Point2d u = {(c * p.x + s * p.y) / rx, (c * p.y - s * p.x) / ry},
                          v = {(c * q.x + s * q.y) / rx, (c * q.y - s * q.x) / ry};
            CHECK(length(v) == Approx(1).margin(1e-3));
            total += math::atan2(cross(u, v), dot(u, v));
        }
        CHECK(total == Approx(turn).margin(1e-2));
    }
}

TEST_CASE("A bad path is an error that names the place") {
    CHECK(path_error("L1 2") == "d, character 1: a path begins with M");
    CHECK(path_error("  z") == "d, character 3: a path begins with M");
    CHECK(path_error("1 2") == "d, character 1: a command is missing");
    CHECK(path_error("M1") == "d, character 3: a number is missing");
    CHECK(path_error("M") == "d, character 2: a number is missing");
    CHECK(path_error("M1 2 L3") == "d, character 8: a number is missing");
    CHECK(path_error("M1 2 3") == "d, character 7: a number is missing");
    CHECK(path_error("M1 2 X3 4") == "d, character 6: there is no command 'X'");
    CHECK(path_error("M1 2Z3 4") == "d, character 6: a command is missing");
    CHECK(path_error("M1,,2") == "d, character 4: a number is missing");
    CHECK(path_error("M,1 2") == "d, character 2: a number is missing");
    CHECK(path_error("M1 2L3 4,Z") == "d, character 10: a number is missing");
    CHECK(path_error("M1 2,L3 4") == "d, character 6: a number is missing");
    CHECK(path_error("M1 2 - 3") == "d, character 6: a number is missing");
    CHECK(path_error("M1 2 . 3") == "d, character 6: a number is missing");
    CHECK(path_error("M1 2e 3") == "d, character 5: there is no command 'e'");
    CHECK(path_error("M1 2 L nan 3") == "d, character 8: a number is missing");
    CHECK(path_error("M1 2 L inf 3") == "d, character 8: a number is missing");
    CHECK(path_error("M1 1e16") == "d, character 4: a number is out of range");
    CHECK(path_error("M1 -1e999") == "d, character 4: a number is out of range");
    CHECK(path_error("M0 0C1 2 3 4 5") == "d, character 15: a number is missing");
    CHECK(path_error("M0 0A1 1 0 2 1 5 5") == "d, character 12: an arc's flag must be 0 or 1");
    CHECK(path_error("M0 0A1 1 0 0 -1 5 5") == "d, character 14: an arc's flag must be 0 or 1");
    CHECK(path_error("M0 0A1 1 0 0") == "d, character 13: an arc's flag must be 0 or 1");
    CHECK(path_error("M0 0;") == "d, character 5: a command is missing");
    CHECK(path_error("M0 0\xC3\xA4") == "d, character 5: a command is missing");
    CHECK(path_error(std::string("M0 0\0L1 1", 9)) == "d, character 5: a command is missing");
    // A path that is no path at all does not crash either.
    Random random(3);
    const std::string letters = "MmLlHhVvCcSsQqTtAaZz0123456789.-+eE, \t";
    int right = 0;
    for (int round = 0; round < 20000; ++round) {
        std::string data = "M1 1";
        for (int k = random.integer(0, 25); k > 0; --k)
            data += letters[random.integer(0, static_cast<int>(letters.size()) - 1)];
        try {
            for (const Subpath& s : subpaths(data))
                for (const Point2d p : s.points) REQUIRE((std::isfinite(p.x) && std::isfinite(p.y)));
            ++right;
        } catch (const Error& error) {
            REQUIRE(error.kind() == ErrorKind::input);
        }
    }
    CHECK(right > 500);
}

// --- transforms, numbers, lengths --------------------------------------------------------------------------

TEST_CASE("Transforms move points as computed by hand") {
    const auto moved = [](const std::string& text, Point2d p) { return svg_transform(text, "t") * p; };
    CHECK(moved("", {3, 4}) == Point2d{3, 4});
    CHECK(moved("none", {3, 4}) == Point2d{3, 4});
    CHECK(moved("matrix(1 2 3 4 5 6)", {10, 100}) == Point2d{315, 426});
    CHECK(moved("translate(5)", {3, 4}) == Point2d{8, 4});
    CHECK(moved("translate(5, -6)", {3, 4}) == Point2d{8, -2});
    CHECK(moved("scale(2)", {3, 4}) == Point2d{6, 8});
    CHECK(moved("scale(2 3)", {3, 4}) == Point2d{6, 12});
    CHECK(moved("rotate(90)", {3, 4}) == Point2d{-4, 3});
    CHECK(moved("rotate(-90)", {3, 4}) == Point2d{4, -3});
    CHECK(moved("rotate(180)", {3, 4}) == Point2d{-3, -4});
    CHECK(moved("rotate(270)", {3, 4}) == Point2d{4, -3});
    CHECK(moved("rotate(720)", {3, 4}) == Point2d{3, 4});
    CHECK(moved("rotate(90 1 2)", {3, 4}) == Point2d{-1, 4});
    const Point2d turned = moved("rotate(30)", {10, 0});
    CHECK(turned.x == Approx(8.660254037844387).epsilon(1e-15));
    CHECK(turned.y == Approx(5).epsilon(1e-15));
    const Point2d skewed = moved("skewX(45)", {3, 4}), other = moved("skewY(45)", {3, 4});
    CHECK(skewed.x == Approx(7).epsilon(1e-15));
    CHECK(skewed.y == 4);
    CHECK(other.x == 3);
    CHECK(other.y == Approx(7).epsilon(1e-15));
}

TEST_CASE("A list of transforms is applied from right to left") {
    const auto moved = [](const std::string& text, Point2d p) { return svg_transform(text, "t") * p; };
    CHECK(moved("translate(10 0) scale(2)", {1, 1}) == Point2d{12, 2});
    CHECK(moved("scale(2) translate(10 0)", {1, 1}) == Point2d{22, 2});
    CHECK(moved(" translate( 10,0 ),scale (2)rotate(90) ", {1, 0}) == Point2d{10, 2});
    CHECK(svg_transform("translate(1 2)rotate(90)translate(-1 -2)", "t") ==
          svg_transform("rotate(90,1,2)", "t"));
}

TEST_CASE("A bad transform, number or length is an error that names the place") {
    const auto transform_error = [](const std::string& text) {
        return message_of([&] { svg_transform(text, "t"); });
    };
    CHECK(transform_error("turn(5)") == "t, character 8: there is no transform 'turn'");
    CHECK(transform_error("rotate 5") == "t, character 8: '(' is missing");
    CHECK(transform_error("rotate(5") == "t, character 9: ')' is missing");
    CHECK(transform_error("rotate(5deg)") == "t, character 9: ')' is missing");
    CHECK(transform_error("rotate(1 2)") == "t, character 12: 'rotate' does not take 2 numbers");
    CHECK(transform_error("matrix(1)") == "t, character 10: 'matrix' does not take 1 number");
    CHECK(transform_error("scale()") == "t, character 8: 'scale' does not take 0 numbers");
    CHECK(transform_error("scale(1,)") == "t, character 9: a number is missing");
    CHECK(transform_error("(1)") == "t, character 1: the name of a transform is missing");
    CHECK(transform_error("skewX(90)") == "t, character 10: a skew by a right angle");
    CHECK(transform_error("scale(1e9) scale(1e9)") == "t, character 22: a number is out of range");
    CHECK(svg_numbers(" 1,2 -3.5.5 ", "n") == std::vector<double>{1, 2, -3.5, 0.5});
    CHECK(svg_numbers("", "n").empty());
    CHECK(message_of([] { svg_numbers("1 2 x", "n"); }) == "n, character 5: a number is missing");
    CHECK(message_of([] { svg_numbers("1 2,", "n"); }) == "n, character 5: a number is missing");
    CHECK(svg_length("10", "l", 200) == 10);
    CHECK(svg_length(" 1.5px ", "l", 200) == 1.5);
    CHECK(svg_length("1in", "l", 200) == 96);
    CHECK(svg_length("25.4mm", "l", 200) == Approx(96));
    CHECK(svg_length("2.54cm", "l", 200) == Approx(96));
    CHECK(svg_length("72pt", "l", 200) == Approx(96));
    CHECK(svg_length("6pc", "l", 200) == 96);
    CHECK(svg_length("2em", "l", 200) == 32);
    CHECK(svg_length("2ex", "l", 200) == 16);
    CHECK(svg_length("25%", "l", 200) == 50);
    CHECK(svg_length(" -50% ", "l", 200) == -100);
    for (const char* bad : {"2furlongs", "2 px", "5%%", "5%px"})
        CHECK(message_of([&] { svg_length(bad, "l", 200); }).starts_with("l, character"));
    CHECK(message_of([] { svg_length("wide", "l", 200); }) == "l, character 1: a number is missing");
}

// --- strokes.json ------------------------------------------------------------------------------------------

namespace {
const char* whole_file = R"({
  "origin": [50, 60.5],
  "parts": [
    {
      "name": "body",
      "stroke": [
        [0, 0],
        [100, 0],
        [100, 50.25],
        [1e-07, 50]
      ]
    },
    {
      "name": "left leg",
      "stroke": [
        [10, 50],
        [20, 50],
        [15, 90]
      ],
      "depth": -12.5,
      "view": "side",
      "symmetric": "x",
      "parent": "body",
      "height": 0.5,
      "label": "limb",
      "colour": "#0a80ff"
    }
  ],
  "calls": [
    {
      "move_part": {
        "part": "left leg",
        "translate": [1, -2, 3.5],
        "rotate": {
          "axis": "x",
          "degrees": -30
        },
        "scale": 2
      }
    },
    {
      "move_part": {
        "part": "body"
      }
    },
    {
      "set_symmetry": {
        "part": "left leg",
        "symmetric": false
      }
    },
    {
      "set_symmetry": {
        "part": "left leg",
        "symmetric": "z"
      }
    },
    {
      "refine": {}
    },
    {
      "refine": {
        "prune": 0.1,
        "merge": 0,
        "collapse": 0.02
      }
    },
    {
      "refine": {
        "part": "left leg",
        "branch": 2,
        "simplify": 0.01
      }
    },
    {
      "remove_part": "left leg"
    },
    {
      "add_part": {
        "name": "left leg",
        "stroke": [
          [1, 1],
          [2, 1],
          [2, 2]
        ],
        "view": "top",
        "symmetric": "y",
        "label": "tail"
      }
    }
  ]
}
)";
} // namespace

TEST_CASE("strokes.json survives the way to Strokes and back to the byte") {
    const Strokes strokes = json(whole_file);
    CHECK(strokes_to_json(strokes) == whole_file);
    CHECK(strokes.repairs.empty());
    CHECK(strokes.origin == Point2d{50, 60.5});
    REQUIRE(strokes.calls.size() == 11);
    CHECK(part_of(strokes, 0) == PartStroke{"body",
                                            {{0, 0}, {100, 0}, {100, 50.25}, {1e-7, 50}},
                                            0,
                                            Viewpoint::front,
                                            Symmetry::none,
                                            "",
                                            1,
                                            Label::background,
                                            {}});
    CHECK(part_of(strokes, 1) == PartStroke{"left leg",
                                            {{10, 50}, {20, 50}, {15, 90}},
                                            -12.5,
                                            Viewpoint::side,
                                            Symmetry::x,
                                            "body",
                                            0.5,
                                            Label::limb,
                                            Rgb8{10, 128, 255}});
    CHECK(std::get<MovePart>(strokes.calls[2]) == MovePart{"left leg", {1, -2, 3.5}, 'x', -30, 2});
    CHECK(std::get<MovePart>(strokes.calls[3]) == MovePart{"body", {}, 'z', 0, 1});
    CHECK(std::get<SetSymmetry>(strokes.calls[4]) == SetSymmetry{"left leg", Symmetry::none});
    CHECK(std::get<SetSymmetry>(strokes.calls[5]) == SetSymmetry{"left leg", Symmetry::z});
    CHECK(std::get<RefineSkeleton>(strokes.calls[6]) == RefineSkeleton{"", -1, {}, {}, {}, {}});
    CHECK(std::get<RefineSkeleton>(strokes.calls[7]) == RefineSkeleton{"", -1, {}, 0.1, 0.0, 0.02});
    CHECK(std::get<RefineSkeleton>(strokes.calls[8]) == RefineSkeleton{"left leg", 2, 0.01, {}, {}, {}});
    CHECK(std::get<RemovePart>(strokes.calls[9]) == RemovePart{"left leg"});
    CHECK(part_of(strokes, 10).view == Viewpoint::top);
}

TEST_CASE("Random strokes survive the way to JSON and back to the bit") {
    Random random(5);
    for (int round = 0; round < 50; ++round) {
        Strokes strokes;
        strokes.origin = {random.uniform(-1e6, 1e6), random.uniform(-1, 1)};
        const int parts = random.integer(1, 6);
        for (int i = 0; i < parts; ++i) {
            PartStroke part;
            part.name = "part \"" + std::to_string(i) + "\" \xC3\xA4";
            for (int k = random.integer(3, 30); k > 0; --k)
                part.stroke.push_back({random.uniform(-500, 500), random.uniform(0, 1e-3)});
            part.depth = random.chance(0.5) ? random.uniform(-9, 9) : 0;
            part.view = static_cast<Viewpoint>(random.integer(0, 2));
            part.symmetry = static_cast<Symmetry>(random.integer(0, 3));
            if (i > 0 && random.chance(0.5)) part.parent = "part \"0\" \xC3\xA4";
            part.height = random.chance(0.5) ? random.uniform(0.1, 2) : 1;
            part.label = static_cast<Label>(random.integer(0, 5));
            if (random.chance(0.5))
                part.colour = Rgb8{static_cast<std::uint8_t>(random.integer(0, 255)), 7, 255};
            strokes.calls.emplace_back(part);
            if (random.chance(0.2))
                strokes.calls.emplace_back(MovePart{part.name,
                                                    {random.uniform(), 0, 1},
                                                    'y',
                                                    random.uniform(-180, 180),
                                                    random.uniform(0.1, 3)});
        }
        const std::string text = strokes_to_json(strokes);
        const Strokes back = json(text);
        CHECK(back.origin == strokes.origin);
        CHECK(back.calls == strokes.calls);
        CHECK(back.repairs.empty());
        CHECK(strokes_to_json(back) == text);
    }
}

TEST_CASE("A part needs a name and a stroke only; the origin is the middle of the first one") {
    const Strokes strokes =
        json(R"({"parts": [{"name": "a", "stroke": [[0, 0], [10, 0], [4, 6]]}, )" + part_text("b") + "]}");
    CHECK(strokes.origin == Point2d{5, 3});
    CHECK(strokes.calls.size() == 2);
    CHECK(part_of(strokes, 0) == PartStroke{"a",
                                            {{0, 0}, {10, 0}, {4, 6}},
                                            0,
                                            Viewpoint::front,
                                            Symmetry::none,
                                            "",
                                            1,
                                            Label::background,
                                            {}});
    const Strokes called = json("{\"calls\": [{\"add_part\": " + part_text("a") + "}]}");
    CHECK(called.origin == Point2d{5, 5});
    REQUIRE(called.calls.size() == 1);
    CHECK(part_of(called, 0).name == "a");
    CHECK(strokes_to_json(called) == strokes_to_json(json("{\"parts\": [" + part_text("a") + "]}")));
}

TEST_CASE("symmetric: true mirrors along the depth of a part off the middle, else across the canvas") {
    const auto symmetry = [](const std::string& more) {
        return part_of(json(file_text(part_text("a", more))), 0).symmetry;
    };
    CHECK(symmetry(R"("symmetric": true)") == Symmetry::x);
    CHECK(symmetry(R"("symmetric": true, "depth": 3)") == Symmetry::z);
    CHECK(symmetry(R"("symmetric": true, "view": "side")") == Symmetry::z);
    CHECK(symmetry(R"("symmetric": true, "view": "side", "depth": -3)") == Symmetry::x);
    CHECK(symmetry(R"("symmetric": true, "view": "top")") == Symmetry::x);
    CHECK(symmetry(R"("symmetric": true, "view": "top", "depth": 3)") == Symmetry::y);
    CHECK(symmetry(R"("symmetric": false, "depth": 3)") == Symmetry::none);
    CHECK(symmetry(R"("symmetric": "y")") == Symmetry::y);
    const Strokes strokes = json(
        file_text(part_text("a", R"("depth": 3)"), R"({"set_symmetry": {"part": "a", "symmetric": true}})"));
    CHECK(std::get<SetSymmetry>(strokes.calls[1]).symmetry == Symmetry::z);
}

TEST_CASE("What can be put right in a stroke is put right, with a line about it") {
    Strokes strokes =
        json(R"({"parts": [{"name": "tail", "stroke": [[0,0],[0,0],[0,0],[5,0],[5,5],[5,5],[0,0]]}]})");
    CHECK(part_of(strokes, 0).stroke == Line{{0, 0}, {5, 0}, {5, 5}});
    CHECK(strokes.repairs == Lines{"part 'tail': 3 repeated points dropped"});
    strokes = json(R"({"parts": [{"name": "tail", "stroke": [[0,0],[5,0],[5,0],[5,5]]}]})");
    CHECK(strokes.repairs == Lines{"part 'tail': 1 repeated point dropped"});
    // Open or closed is all the same.
    CHECK(json(R"({"parts": [{"name": "tail", "stroke": [[0,0],[5,0],[5,5],[0,0]]}]})").repairs.empty());

    const auto circle = [](int count) {
        std::string text;
        for (int i = 0; i < count; ++i)
            text += (i ? ",[" : "[") + std::to_string(i) + "," + std::to_string(i % 7) + "]";
        return R"({"parts": [{"name": "tail", "stroke": [)" + text + "]}]}";
    };
    strokes = json(circle(200000));
    CHECK(part_of(strokes, 0).stroke.size() == 200000);
    CHECK(strokes.repairs.empty());
    strokes = json(circle(200001));
    const Line& stroke = part_of(strokes, 0).stroke;
    REQUIRE(stroke.size() == 20000);
    CHECK(strokes.repairs == Lines{"part 'tail': 200001 points thinned to 20000"});
    CHECK(stroke[0] == Point2d{0, 0});
    CHECK(stroke[10000] == Point2d{100000, 5});
    for (std::size_t i = 1; i < stroke.size(); ++i)
        REQUIRE(std::abs(stroke[i].x - stroke[i - 1].x - 10) <= 1);
}

TEST_CASE("A stroke without three different points is an error") {
    const auto stroke_error = [](const std::string& stroke) {
        return json_error(R"({"parts": [{"name": "tail", "stroke": )" + stroke + "}]}");
    };
    const std::string fact = "strokes.json: part 'tail': a stroke needs at least three points";
    CHECK(stroke_error("[]") == fact);
    CHECK(stroke_error("[[1, 2]]") == fact);
    CHECK(stroke_error("[[1, 2], [3, 4]]") == fact);
    CHECK(stroke_error("[[1, 2], [1, 2], [1, 2], [1, 2]]") == fact);
    CHECK(stroke_error("[[1, 2], [3, 4], [1, 2], [3, 4], [1, 2]]") == fact);
    CHECK(stroke_error("[[1, 2], [3, 4], [1, 2], [3, 5]]") == "no error");
    CHECK(stroke_error("7") == "strokes.json: part 'tail'.stroke: must be a list");
    CHECK(stroke_error("[[1, 2], [3]]") == "strokes.json: part 'tail'.stroke[1]: has fewer than 2 elements");
    CHECK(stroke_error("[[1, 2, 3]]") == "strokes.json: part 'tail'.stroke[0]: has more than 2 elements");
    CHECK(stroke_error("[[1, \"2\"]]") == "strokes.json: part 'tail'.stroke[0][1]: must be a number");
    CHECK(stroke_error("[[1, null]]") == "strokes.json: part 'tail'.stroke[0][1]: must be a number");
    CHECK(stroke_error("[[1, 1e16]]") ==
          "strokes.json: part 'tail'.stroke[0][1]: must lie between -1e+15 and 1e+15");
    CHECK(stroke_error("[[1, NaN]]") == "strokes.json: not valid JSON (line 1)");
    CHECK(stroke_error("[[1, Infinity]]") == "strokes.json: not valid JSON (line 1)");
    CHECK(stroke_error("[[1, 1e999]]") == "strokes.json: not valid JSON (line 1)");
}

TEST_CASE("A bad part is an error that names file, part and fact") {
    CHECK(part_error(R"("dept": 1)") == "strokes.json: part 'tail': unknown key 'dept'");
    CHECK(part_error(R"("depth": "near")") == "strokes.json: part 'tail'.depth: must be a number");
    CHECK(part_error(R"("view": "back")") == "strokes.json: part 'tail'.view: must be front, side or top");
    CHECK(part_error(R"("view": 1)") == "strokes.json: part 'tail'.view: must be a string");
    CHECK(part_error(R"("symmetric": "w")") ==
          "strokes.json: part 'tail'.symmetric: must be true, false, x, y or z");
    CHECK(part_error(R"("symmetric": "none")") ==
          "strokes.json: part 'tail'.symmetric: must be true, false, x, y or z");
    CHECK(part_error(R"("symmetric": 1)") ==
          "strokes.json: part 'tail'.symmetric: must be true, false, x, y or z");
    CHECK(part_error(R"("parent": "tail")") == "strokes.json: part 'tail': is its own parent");
    CHECK(part_error(R"("parent": "body")") ==
          "strokes.json: part 'tail': the parent 'body' does not come before it");
    CHECK(part_error(R"("parent": "a\nb")") ==
          "strokes.json: part 'tail': the parent 'a?b' does not come before it");
    CHECK(part_error(R"("height": 0)") == "strokes.json: part 'tail': height must be greater than 0");
    CHECK(part_error(R"("height": -2)") == "strokes.json: part 'tail': height must be greater than 0");
    CHECK(part_error(R"("height": null)") == "strokes.json: part 'tail'.height: must be a number");
    CHECK(part_error(R"("label": "nose")") == "strokes.json: part 'tail'.label: must be " + listed_parts());
    CHECK(part_error(R"("label": "background")") ==
          "strokes.json: part 'tail'.label: must be " + listed_parts());
    for (const char* colour : {"red", "#fff", "#12345g", "#1234567", "123456#", ""})
        CHECK(part_error("\"colour\": \"" + std::string(colour) + "\"") ==
              "strokes.json: part 'tail'.colour: must be a colour, #rrggbb");
    CHECK(json_error(file_text(part_text("a") + "," + part_text("a"))) ==
          "strokes.json: part 'a': there are two parts of this name");
    CHECK(json_error(
              file_text(part_text("a", R"("parent": "b")") + "," + part_text("b", R"("parent": "a")"))) ==
          "strokes.json: part 'a': the parent 'b' does not come before it");
    CHECK(json_error(file_text(part_text(""))) == "strokes.json: parts[0].name: must not be empty");
    CHECK(json_error(file_text(R"({"stroke": []})")) == "strokes.json: parts[0]: misses \"name\"");
    CHECK(json_error(file_text(R"({"name": "a"})")) == "strokes.json: part 'a': misses \"stroke\"");
    CHECK(json_error(file_text("7")) == "strokes.json: parts[0]: must be an object");
    CHECK(json_error(file_text(R"({"name": 7})")) == "strokes.json: parts[0].name: must be a string");
}

TEST_CASE("A bad file of strokes is an error") {
    CHECK(json_error("") == "strokes.json: not valid JSON (line 1)");
    CHECK(json_error("[]") == "strokes.json: must be an object");
    CHECK(json_error("{}") == "strokes.json: holds no part");
    CHECK(json_error(R"({"parts": []})") == "strokes.json: holds no part");
    CHECK(json_error(R"({"parts": {}})") == "strokes.json: parts: must be a list");
    CHECK(json_error(R"({"calls": 1})") == "strokes.json: calls: must be a list");
    CHECK(json_error(R"({"part": []})") == "strokes.json: unknown key 'part'");
    CHECK(json_error("{\"origin\": [1], \"parts\": [" + part_text("a") + "]}") ==
          "strokes.json: origin: has fewer than 2 elements");
    const std::string text = whole_file;
    for (std::size_t length = 0; length + 2 < text.size(); length += 7)
        CHECK_THROWS_AS(json(text.substr(0, length)), Error);
}

TEST_CASE("A bad call is an error that names its place") {
    CHECK(call_error("7") == "strokes.json: calls[0]: must be an object with one key, the call");
    CHECK(call_error("{}") == "strokes.json: calls[0]: must be an object with one key, the call");
    CHECK(call_error(R"({"remove_part": "tail", "refine": {}})") ==
          "strokes.json: calls[0]: must be an object with one key, the call");
    CHECK(call_error(R"({"paint": "tail"})") == "strokes.json: calls[0]: there is no call 'paint'");
    CHECK(call_error(R"({"remove_part": "tial"})") ==
          "strokes.json: calls[0].remove_part: there is no part 'tial' here");
    CHECK(call_error(R"({"remove_part": 1})") == "strokes.json: calls[0].remove_part: must be a string");
    CHECK(call_error(R"({"refine": {}}, {"remove_part": "tail"}, {"remove_part": "tail"})") ==
          "strokes.json: calls[2].remove_part: there is no part 'tail' here");
    CHECK(call_error(R"({"move_part": {}})") == "strokes.json: calls[0].move_part: misses \"part\"");
    CHECK(call_error(R"({"move_part": {"part": "leg"}})") ==
          "strokes.json: calls[0].move_part.part: there is no part 'leg' here");
    CHECK(call_error(R"({"move_part": {"part": "tail", "turn": 1}})") ==
          "strokes.json: calls[0].move_part: unknown key 'turn'");
    CHECK(call_error(R"({"move_part": {"part": "tail", "scale": 0}})") ==
          "strokes.json: move_part of 'tail': scale must be greater than 0");
    CHECK(call_error(R"({"move_part": {"part": "tail", "scale": -1}})") ==
          "strokes.json: move_part of 'tail': scale must be greater than 0");
    CHECK(call_error(R"({"move_part": {"part": "tail", "translate": [1, 2]}})") ==
          "strokes.json: calls[0].move_part.translate: has fewer than 3 elements");
    CHECK(call_error(R"({"move_part": {"part": "tail", "rotate": {"axis": "w", "degrees": 1}}})") ==
          "strokes.json: calls[0].move_part.rotate.axis: must be x, y or z");
    CHECK(call_error(R"({"move_part": {"part": "tail", "rotate": {"axis": "x"}}})") ==
          "strokes.json: calls[0].move_part.rotate: misses \"degrees\"");
    CHECK(
        call_error(R"({"move_part": {"part": "tail", "rotate": {"axis": "x", "degrees": 1, "angle": 2}}})") ==
        "strokes.json: calls[0].move_part.rotate: unknown key 'angle'");
    CHECK(call_error(R"({"set_symmetry": {"part": "tail"}})") ==
          "strokes.json: calls[0].set_symmetry: misses \"symmetric\"");
    CHECK(call_error(R"({"set_symmetry": {"part": "leg", "symmetric": true}})") ==
          "strokes.json: calls[0].set_symmetry.part: there is no part 'leg' here");
    CHECK(call_error(R"({"refine": {"part": "leg"}})") ==
          "strokes.json: calls[0].refine.part: there is no part 'leg' here");
    CHECK(call_error(R"({"refine": {"branch": 1}})") ==
          "strokes.json: calls[0].refine: a branch needs a part");
    CHECK(call_error(R"({"refine": {"part": "tail", "branch": 1, "prune": 0.1}})") ==
          "strokes.json: calls[0].refine: a branch alone knows simplify only");
    CHECK(call_error(R"({"refine": {"part": "tail", "branch": -1}})") ==
          "strokes.json: calls[0].refine.branch: must lie between 0 and 1e+06");
    CHECK(call_error(R"({"refine": {"part": "tail", "branch": 1.5}})") ==
          "strokes.json: calls[0].refine.branch: must be a whole number");
    CHECK(call_error(R"({"refine": {"merge": -0.1}})") ==
          "strokes.json: calls[0].refine.merge: must lie between 0 and 10");
    CHECK(call_error(R"({"refine": {"joints": 3}})") ==
          "strokes.json: calls[0].refine: unknown key 'joints'");
    CHECK(call_error(R"({"refine": 3})") == "strokes.json: calls[0].refine: must be an object");
    CHECK(call_error("{\"add_part\": " + part_text("tail") + "}") ==
          "strokes.json: part 'tail': there are two parts of this name");
    // A part that was removed is no parent, and its name is free again.
    CHECK(
        call_error("{\"remove_part\": \"tail\"}, {\"add_part\": " + part_text("leg", R"("parent": "tail")") +
                   "}") == "strokes.json: part 'leg': the parent 'tail' does not come before it");
    CHECK(call_error("{\"remove_part\": \"tail\"}, {\"add_part\": " + part_text("tail") + "}") == "no error");
}

// --- SVG ---------------------------------------------------------------------------------------------------

TEST_CASE("Every shape of a drawing is a part with the points computed by hand", "[needs-pugixml]") {
    CHECK(shape("<path d='M1 2L4 6 4 0z'/>").stroke == Line{{1, 2}, {4, 6}, {4, 0}});
    CHECK(shape("<path d='M1 2L4 6 4 0 1 2z'/>").stroke == Line{{1, 2}, {4, 6}, {4, 0}});
    CHECK(shape("<polygon points='1,2 4,6 4,0'/>").stroke == Line{{1, 2}, {4, 6}, {4, 0}});
    CHECK(shape("<polyline points='1 2 4 6 4 0 1 2'/>").stroke == Line{{1, 2}, {4, 6}, {4, 0}});
    CHECK(shape("<rect x='1' y='2' width='30' height='4'/>").stroke ==
          Line{{1, 2}, {31, 2}, {31, 6}, {1, 6}});
    CHECK(shape("<rect width='1in' height='4px'/>").stroke == Line{{0, 0}, {96, 0}, {96, 4}, {0, 4}});
    CHECK(shape("<svg:rect width='3' height='4'/>").stroke.size() == 4);
    for (const char* text : {"<circle cx='3' cy='4' r='10'/>", "<ellipse cx='3' cy='4' rx='10' ry='10'/>",
                             "<ellipse cx='3' cy='4' ry='10'/>"}) {
        Line line = shape(text).stroke;
        CHECK(line.size() > 40);
        CHECK(line.size() < 100);
        CHECK(area_of(line) == Approx(100 * math::pi).epsilon(0.002));
        line.push_back(line.front());
        CHECK(check_arc(line, {3, 4}, 10, 10) == Approx(360));
    }
    Line line = shape("<ellipse cx='3' cy='4' rx='10' ry='5'/>").stroke;
    line.push_back(line.front());
    CHECK(check_arc(line, {3, 4}, 10, 5) == Approx(360));
}

TEST_CASE("The corners of a rect are rounded by quarters of an ellipse", "[needs-pugixml]") {
    const Line line = shape("<rect x='0' y='0' width='40' height='20' rx='4' ry='2'/>").stroke;
    CHECK(std::abs(area_of(line)) == Approx(800 - (4 - math::pi) * 8).epsilon(0.001));
    for (const Point2d p : line)
        if (p.x < 4 && p.y < 2) CHECK(length(Point2d{(p.x - 4) / 4, (p.y - 2) / 2}) == Approx(1));
    CHECK(std::find(line.begin(), line.end(), Point2d{4, 0}) != line.end());
    CHECK(std::find(line.begin(), line.end(), Point2d{40, 18}) != line.end());
    // One radius stands for both; none is more than half a side.
    CHECK(shape("<rect width='40' height='20' rx='4'/>").stroke ==
          shape("<rect width='40' height='20' ry='4' rx='auto'/>").stroke);
    CHECK(area_of(shape("<rect width='20' height='20' rx='50'/>").stroke) ==
          Approx(100 * math::pi).epsilon(0.002));
}

TEST_CASE("Transforms of an element and of the groups around it add up", "[needs-pugixml]") {
    CHECK(shape("<path transform='translate(10 20)' d='M0 0L5 0 5 5z'/>").stroke ==
          Line{{10, 20}, {15, 20}, {15, 25}});
    CHECK(shape("<g transform='translate(10 20)'><g transform='scale(2)'><a><path transform='rotate(90)' "
                "d='M0 0L5 0 5 5z'/></a></g></g>")
              .stroke == Line{{10, 20}, {10, 30}, {0, 30}});
    CHECK(
        near(shape("<g transform='matrix(1 2 3 4 5 6) skewX(45)'><polygon points='0 0 1 0 0 1'/></g>").stroke,
             {{5, 6}, {6, 8}, {9, 12}}));
    CHECK(shape("<svg x='5' y='6'><rect width='1' height='1'/></svg>").stroke[0] == Point2d{5, 6});
    const Strokes strokes =
        svg("<g transform='scale(3)'><rect width='1' height='1'/></g><rect width='1' height='1'/>");
    CHECK(part_of(strokes, 0).stroke[2] == Point2d{3, 3});
    CHECK(part_of(strokes, 1).stroke[2] == Point2d{1, 1});
    CHECK(part_of(svg("<path " + triangle + "/>", "transform='translate(1 1)'"), 0).stroke[0] ==
          Point2d{1, 1});
    // A circle in a stretched group is an ellipse.
    Line line = shape("<g transform='scale(2 1)'><circle r='10'/></g>").stroke;
    line.push_back(line.front());
    CHECK(check_arc(line, {0, 0}, 20, 10) == Approx(360));
    CHECK(shape("<path style='transform: translate(3px, 4px) scale(2)' " + triangle + "/>").stroke ==
          Line{{3, 4}, {23, 4}, {3, 24}});
    CHECK(shape("<path style='transform: rotate(90deg)' " + triangle + "/>").stroke ==
          Line{{0, 0}, {0, 10}, {-10, 0}});
    CHECK(svg("<path style='transform: rotate3d(1, 1, 1, 45deg)' id='p' " + triangle + "/>").repairs ==
          Lines{"path 'p': the transform in style is not followed"});
}

TEST_CASE("Names come from the label, the id, the title or the number of the part, in this order",
          "[needs-pugixml]") {
    const Strokes strokes = svg("<path inkscape:label='Left  ear' id='path1' " + triangle +
                                "><title>no</title></path>" //
                                "<path id='path2' " +
                                triangle +
                                "><title>no</title></path>" //
                                "<path " +
                                triangle +
                                "><title> the\n tail </title></path>" //
                                "<path " +
                                triangle + "/><path id=' ' " + triangle + "/>");
    Lines names;
    for (std::size_t i = 0; i < strokes.calls.size(); ++i) names.push_back(part_of(strokes, i).name);
    CHECK(names == Lines{"Left ear", "path2", "the tail", "part-4", "part-5"});
    CHECK(strokes.repairs.empty());
}

TEST_CASE("Parts of one name in a drawing are numbered", "[needs-pugixml]") {
    const std::string leg = "<path inkscape:label='leg' " + triangle + "/>";
    const Strokes strokes =
        svg(leg + leg + "<path id='leg-3' " + triangle + "/>" + leg + "<path id='leg-2' " + triangle + "/>");
    Lines names;
    for (std::size_t i = 0; i < strokes.calls.size(); ++i) names.push_back(part_of(strokes, i).name);
    CHECK(names == Lines{"leg", "leg-2", "leg-3", "leg-4", "leg-2-2"});
    CHECK(strokes.repairs == Lines{"part 'leg-2': there was a part 'leg' before it",
                                   "part 'leg-4': there was a part 'leg' before it",
                                   "part 'leg-2-2': there was a part 'leg-2' before it"});
}

TEST_CASE("Attributes of a drawing's parts mean what the keys of strokes.json mean", "[needs-pugixml]") {
    const Strokes strokes =
        svg("<path id='body' " + triangle +
            "/><path id='leg' data-depth='-2.5' data-view='side' data-symmetric='true' data-parent='body' "
            "data-height='0.5' data-label='tail' fill='#123456' " +
            triangle + "/><path data-symmetric='false' " + triangle + "/><path data-symmetric='y' " +
            triangle + "/>");
    CHECK(part_of(strokes, 1) == PartStroke{"leg",
                                            {{0, 0}, {10, 0}, {0, 10}},
                                            -2.5,
                                            Viewpoint::side,
                                            Symmetry::x,
                                            "body",
                                            0.5,
                                            Label::tail,
                                            Rgb8{0x12, 0x34, 0x56}});
    CHECK(part_of(strokes, 2).symmetry == Symmetry::none);
    CHECK(part_of(strokes, 3).symmetry == Symmetry::y);
    CHECK(strokes.origin == Point2d{5, 5});
    CHECK(svg("<path " + triangle + "/>", "data-origin='3, -4.5'").origin == Point2d{3, -4.5});
    // A drawing and the JSON of it are the same model.
    const Strokes back = json(strokes_to_json(strokes));
    CHECK(back.calls == strokes.calls);
    CHECK(back.origin == strokes.origin);
}

TEST_CASE("The colour is that of the fill, else that of the outline", "[needs-pugixml]") {
    const auto colour = [](const std::string& attributes) {
        return shape("<path " + attributes + " " + triangle + "/>").colour;
    };
    using Colour = std::optional<Rgb8>;
    CHECK(colour("") == Colour{});
    CHECK(colour("fill='#F80'") == Rgb8{255, 136, 0});
    CHECK(colour("fill='#0a0B0c'") == Rgb8{10, 11, 12});
    CHECK(colour("fill='#0a0b0c80'") == Rgb8{10, 11, 12});
    CHECK(colour("fill='rgb(1, 2,300)'") == Rgb8{1, 2, 255});
    CHECK(colour("fill='RGB(100% 50% 0%)'") == Rgb8{255, 128, 0});
    CHECK(colour("fill='rgba(1,2,3,0.5)'") == Rgb8{1, 2, 3});
    CHECK(colour("fill='rgb(1 2 3 / 50)'") == Rgb8{1, 2, 3});
    CHECK(colour("fill='Red'") == Rgb8{255, 0, 0});
    CHECK(colour("fill='teal'") == Rgb8{0, 128, 128});
    CHECK(colour("fill='orange'") == Rgb8{255, 165, 0});
    CHECK(colour("stroke='blue'") == Rgb8{0, 0, 255});
    CHECK(colour("fill='none' stroke='blue'") == Rgb8{0, 0, 255});
    CHECK(colour("fill='lime' stroke='blue'") == Rgb8{0, 255, 0});
    CHECK(colour("fill='lime' style='stroke:red; FILL : navy !important'") == Rgb8{0, 0, 128});
    CHECK(colour("style='fill:#ffffff;fill-opacity:1;stroke:none'") == Rgb8{255, 255, 255});
    CHECK(colour("fill='transparent' stroke='red'") == Rgb8{255, 0, 0});
    CHECK(colour("fill='hsl(120, 100%, 25%)'") == Rgb8{0, 128, 0});
    CHECK(colour("fill='hsla(-120deg 100% 50% / 50%)'") == Rgb8{0, 0, 255});
    CHECK(colour("fill='rebeccapurple'") == Rgb8{0x66, 0x33, 0x99});
    CHECK(colour("color='#102030' fill='currentColor'") == Rgb8{16, 32, 48});
    CHECK(colour("style='--skin: tan; fill: var(--skin)'") == Rgb8{0xd2, 0xb4, 0x8c});
    CHECK(colour("fill='var(--none, navy)'") == Rgb8{0, 0, 128});
    CHECK(shape("<g fill='red'><path " + triangle + "/></g>").colour == Rgb8{255, 0, 0});
    CHECK(shape("<g fill='red'><path fill='inherit' " + triangle + "/></g>").colour == Rgb8{255, 0, 0});
    CHECK(shape("<g fill='red'><g style='fill:white'><path " + triangle + "/></g></g>").colour ==
          Rgb8{255, 255, 255});
    CHECK(shape("<g fill='red'><path fill='none' stroke='blue' " + triangle + "/></g>").colour ==
          Rgb8{0, 0, 255});
    for (const char* odd : {"url(#shade)", "bluish", "#12", "#ggg", "rgb(1,2)", "rgb(a,b,c)", "rgb", "#"}) {
        const Strokes strokes =
            svg("<path id='p' fill='" + std::string(odd) + "' stroke='red' " + triangle + "/>");
        CHECK(part_of(strokes, 0).colour == Rgb8{255, 0, 0});
        CHECK(strokes.repairs == Lines{"part 'p': '" + std::string(odd) + "' is no plain colour, left out"});
    }
}

TEST_CASE("What is not drawn is no part, and what cannot be one is named", "[needs-pugixml]") {
    const std::string path = "<path id='no' " + triangle + "/>";
    std::string inside = "<rect id='yes' width='1' height='1'/>";
    for (const char* group : {"defs", "clipPath", "symbol", "marker", "mask", "pattern", "metadata"})
        inside += "<" + std::string(group) + ">" + path + "</" + group + ">";
    inside +=
        "<g display='none'>" + path + "<text>t</text></g><g style='fill:red;display: NONE'>" + path + "</g>";
    inside += "<path display='none' d='nonsense'/><!-- comment --><title>t</title>";
    const Strokes strokes = svg(inside);
    REQUIRE(strokes.calls.size() == 1);
    CHECK(part_of(strokes, 0).name == "yes");
    CHECK(strokes.repairs ==
          Lines{"g: not displayed, left out", "g: not displayed, left out", "path: not displayed, left out"});
    const Strokes others =
        svg("<rect width='1' height='1'/><line id='l' x2='1'/><text>t</text><image/><use href='#l'/>"
            "<path id='p' d=''/><path/><rect id='r' width='0' height='3'/><circle/><polygon/>");
    CHECK(others.calls.size() == 1);
    CHECK(others.repairs == Lines{"line 'l': has no area, left out", "text: not a shape, left out",
                                  "image: not a shape, left out", "line 'l': has no area, left out",
                                  "path 'p': empty, left out", "path: empty, left out",
                                  "rect 'r': empty, left out", "circle: empty, left out",
                                  "polygon: empty, left out"});
}

TEST_CASE("Open paths are closed, and each outline of a path is a part, with a line about it",
          "[needs-pugixml]") {
    Strokes strokes = svg("<path id='p' d='M0 0L10 0 10 10'/>");
    CHECK(strokes.repairs == Lines{"part 'p': the open path was closed"});
    CHECK(part_of(strokes, 0).stroke == Line{{0, 0}, {10, 0}, {10, 10}});
    strokes = svg("<polyline id='p' points='0 0 10 0 10 10'/>");
    CHECK(strokes.repairs == Lines{"part 'p': the open path was closed"});
    // Back where it began, if only almost.
    CHECK(svg("<path d='M0 0L10 0 10 10 0 0'/>").repairs.empty());
    CHECK(shape("<path d='m0.1 0.1 0.1 0 0 0.3-0.1-0.3'/>").stroke.size() == 3);
    CHECK(svg("<path d='m0.1 0.1 0.1 0 0 0.3-0.1-0.3'/>").repairs.empty());
    strokes = svg("<path id='p' d='M0 0h1v1zM10 10h5v5h-5zM20 20h1v1z'/>");
    CHECK(strokes.calls.size() == 3);
    CHECK(strokes.repairs ==
          Lines{"part 'p-2': one more outline of 'p'", "part 'p-3': one more outline of 'p'"});
    CHECK(part_of(strokes, 1).stroke == Line{{10, 10}, {15, 10}, {15, 15}, {10, 15}});
    strokes = svg("<path id='p' d='M0 0h1v1zM10 10v5h5v-5'/>");
    CHECK(strokes.repairs ==
          Lines{"part 'p': the open path was closed", "part 'p-2': one more outline of 'p'"});
    // Movements of the pen alone are no subpaths.
    CHECK(svg("<path d='M5 5M0 0h1v1zM10 10'/>").repairs.empty());
    strokes = svg("<path id='p' d='M0 0h0h5v5z'/>");
    CHECK(strokes.repairs == Lines{"part 'p': 1 repeated point dropped"});
}

TEST_CASE("A bad drawing is an error that names file, element and place", "[needs-pugixml]") {
    const auto bad = [](const std::string& inside) { return svg_error(inside); };
    CHECK(bad("<path id='p' d='M0 0L1'/>") == "drawing.svg: path 'p': d, character 7: a number is missing");
    CHECK(bad("<path inkscape:label='tail' id='p' d='M0 0L1'/>") ==
          "drawing.svg: path 'tail' (id 'p'): d, character 7: a number is missing");
    CHECK(bad("<path id='p' d='M0 0L1 1'/>") == "drawing.svg: no shape can be a part; path 'p': has no area");
    CHECK(bad("<path id='p' d='M3 3'/>") == "drawing.svg: no shape can be a part; path 'p': empty");
    CHECK(bad("<path id='p' transform='scale(0)' " + triangle + "/>") ==
          "drawing.svg: no shape can be a part; path 'p': empty");
    CHECK(bad("<path id='p' fill='none' " + triangle + "/>") ==
          "drawing.svg: no shape can be a part; path 'p': not painted");
    CHECK(bad("<path id='p' transform='scale(1e15)' d='M0 0L10 0 10 10z'/>") ==
          "drawing.svg: part 'p'.stroke[1][0]: must lie between -1e+15 and 1e+15");
    CHECK(bad("<path id='p' transform='spin(3)' d='M0 0'/>") ==
          "drawing.svg: path 'p': transform, character 8: there is no transform 'spin'");
    CHECK(bad("<g id='g' transform='scale'><path/></g>") ==
          "drawing.svg: g 'g': transform, character 6: '(' is missing");
    CHECK(bad("<g transform='scale(1e9)'><g id='g' transform='scale(1e9)'/></g>") ==
          "drawing.svg: g 'g': the transforms together are out of range");
    CHECK(bad("<polygon id='p' points='1 2 3'/>") ==
          "drawing.svg: polygon 'p': points: the last one has no y");
    CHECK(bad("<polygon id='p' points='1 2 x'/>") ==
          "drawing.svg: polygon 'p': points, character 5: a number is missing");
    CHECK(bad("<rect id='r' width='-1' height='3'/>") == "drawing.svg: rect 'r': width must not be negative");
    CHECK(bad("<rect id='r' width='1ly' height='3'/>") ==
          "drawing.svg: rect 'r': width, character 4: only the units px, in, cm, mm, Q, pt, pc, em, rem, ex "
          "and % are known");
    CHECK(bad("<circle id='c' r='-3'/>") == "drawing.svg: circle 'c': r must not be negative");
    CHECK(bad("<path id='p' data-depth='deep' " + triangle + "/>") ==
          "drawing.svg: path 'p': data-depth, character 1: a number is missing");
    CHECK(bad("<path id='p' data-depth='1 2' " + triangle + "/>") ==
          "drawing.svg: path 'p': data-depth must be a number");
    CHECK(bad("<path id='p' data-depth='' " + triangle + "/>") ==
          "drawing.svg: path 'p': data-depth must be a number");
    CHECK(bad("<path id='p' data-height='0' " + triangle + "/>") ==
          "drawing.svg: part 'p': height must be greater than 0");
    CHECK(bad("<path id='p' data-view='back' " + triangle + "/>") ==
          "drawing.svg: part 'p'.view: must be front, side or top");
    CHECK(bad("<path id='p' data-symmetric='' " + triangle + "/>") ==
          "drawing.svg: part 'p'.symmetric: must be true, false, x, y or z");
    CHECK(bad("<path id='p' data-label='nose' " + triangle + "/>") ==
          "drawing.svg: part 'p'.label: must be " + listed_parts());
    CHECK(bad("<path id='p' data-parent='p' " + triangle + "/>") ==
          "drawing.svg: part 'p': is its own parent");
    CHECK(bad("<path id='p' data-parent='q' " + triangle + "/><path id='q' data-parent='p' " + triangle +
              "/>") == "drawing.svg: part 'p': the parent 'q' does not come before it");
    CHECK(bad("<text>only</text>") ==
          "drawing.svg: holds no path, polygon, polyline, rect, circle, ellipse or line");
    CHECK(svg_error("<path " + triangle + "/>", "data-origin='1'") ==
          "drawing.svg: data-origin must be two numbers");
    CHECK(svg_error("<path " + triangle + "/>", "data-origin='1 b'") ==
          "drawing.svg: data-origin, character 3: a number is missing");
}

TEST_CASE("What is not SVG is an error", "[needs-pugixml]") {
    const auto bad = [](const std::string& text) {
        return message_of([&] { strokes_from_svg(text, "drawing.svg"); });
    };
    CHECK(bad("") == "drawing.svg: not valid XML (line 1): no document element found");
    CHECK(bad("plain text") == "drawing.svg: not valid XML (line 1): no document element found");
    CHECK(bad("<svg>\n<g>\n</svg>") == "drawing.svg: not valid XML (line 3): start-end tags mismatch");
    CHECK(bad("<html><svg/></html>") == "drawing.svg: not an SVG file, its root is <html>");
    CHECK(bad("<svg/>") == "drawing.svg: holds no path, polygon, polyline, rect, circle, ellipse or line");
    const auto deep = [](int depth) {
        std::string text;
        for (int i = 0; i < depth; ++i) text += "<g>";
        text += "<rect width='1' height='1'/>";
        for (int i = 0; i < depth; ++i) text += "</g>";
        return text;
    };
    CHECK(svg(deep(150)).calls.size() == 1);
    CHECK(svg_error(deep(100'000)) == "drawing.svg: groups are nested too deeply");
    const std::string text =
        svg_text("<g transform='scale(2)'><path id='p' fill='red' " + triangle + "/></g>");
    for (std::size_t length = 0; length + 3 < text.size(); ++length)
        CHECK_THROWS_AS(strokes_from_svg(text.substr(0, length), "drawing.svg"), Error);
    // Damaged bytes give a model or an error, nothing else.
    Random random(9);
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = text;
        for (int k = random.integer(1, 4); k > 0; --k)
            damaged[random.integer(0, static_cast<int>(damaged.size()) - 1)] =
                static_cast<char>(random.integer(0, 255));
        try {
            const Strokes strokes = strokes_from_svg(damaged, "drawing.svg");
            CHECK_FALSE(strokes.calls.empty());
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::input);
        }
    }
}

// --- names -------------------------------------------------------------------------------------------------

TEST_CASE("A part's name says what it is") {
    for (const char* name :
         {"head",     "Face",     "EAR",      "ears",    "left_ear",    "leftEar",     "ear2",
          "ear.001",  "eye",      "Eyes",     "horn",    "antlers",     "beak",        "snout",
          "muzzle",   "nose",     "mouth",    "crown",   "hat",         "hair",        "antenna",
          "antennae", "antennas", "forehead", "LEFTEar", "right-eye-3", "head of hair"})
        CHECK(label_of_part(name) == Label::head);
    for (const char* name : {"body", "Torso", "torsoes", "trunk", "belly", "bellies", "chest", "abdomen",
                             "shell", "neck", "upperBody"})
        CHECK(label_of_part(name) == Label::body);
    for (const char* name : {"tail", "Tails", "tail_tip", "tail2", "my tail"})
        CHECK(label_of_part(name) == Label::tail);
    for (const char* name : {"left_wing", "wings", "leftwing", "rightWing", "hindwings", "Wing-2"})
        CHECK(label_of_part(name) == Label::wing);
    for (const char* name : {"claw", "leg", "leftArm", "front leg", "hand", "part-3", "path1234", "", "blob",
                             "42", "heart", "swing", "tailor", "forearm", "\xC3\xA4\xC3\xB6", "bodyguard"})
        CHECK(label_of_part(name) == Label::limb);
    // The labels' own names are known, not guessed.
    for (const Label label : {Label::head, Label::body, Label::limb, Label::tail, Label::wing})
        for (const char* more : {"", "s", "_2"}) {
            const std::string name = std::string(name_of(label)) + more;
            CAPTURE(name);
            CHECK(known_label(name == "bodys" ? "bodies" : name) == label);
        }
    CHECK(known_label("left limb") == Label::limb);
    CHECK(known_label("blob") == Label::background);
    // The last word of a compound counts.
    CHECK(label_of_part("body_wing") == Label::wing);
    CHECK(label_of_part("wing claw") == Label::limb);
    CHECK(label_of_part("head hand") == Label::limb);
    CHECK(label_of_part("dragonHead_left") == Label::head);
}
