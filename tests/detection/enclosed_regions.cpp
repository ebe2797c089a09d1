// SPDX-License-Identifier: MIT
// Open outlines, their enclosed regions and silhouettes.
#include "detection/enclosed_regions.hpp"

#include <catch2/catch.hpp>

#include "canvas.hpp"
#include "detection/ink_silhouette.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

Mask ink_of(const Canvas& canvas) {
    Mask ink(canvas.image.width(), canvas.image.height());
    for (std::size_t i = 0; i < ink.size(); ++i) ink.data()[i] = canvas.image.data()[i].g < 128;
    return ink;
}
int count(const Mask& mask) { return static_cast<int>(std::count(mask.begin(), mask.end(), 1)); }

Mask disc_mask(int width, int height, Point2d centre, double radius) {
    Mask mask(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) mask(x, y) = distance({1.0 * x, 1.0 * y}, centre) <= radius;
    return mask;
}

} // namespace

TEST_CASE("A circle encloses its inside with and without a gap in it") {
    for (double gap : {0.0, 3.0, 10.0, 30.0, 60.0}) {
        INFO("gap of " << gap << " degrees");
        Canvas canvas(160, 160);
        canvas.arc({80, 80}, 60, 60, gap / 2, 360 - gap / 2);
        CHECK(intersection_over_union(silhouette_of(ink_of(canvas)), disc_mask(160, 160, {80, 80}, 61.5)) >
              0.97);
    }
    Canvas half(160, 160);
    half.arc({80, 80}, 60, 60, 0, 180);
    CHECK(count(find_enclosed_regions(ink_of(half))) ==
          0); // half a circle encloses nothing: its mouth is its widest place
}

TEST_CASE("Several gaps are closed as well as one") {
    Canvas canvas(160, 160);
    for (double from : {0.0, 90.0, 180.0, 270.0}) canvas.arc({80, 80}, 60, 60, from + 12, from + 78);
    CHECK(intersection_over_union(silhouette_of(ink_of(canvas)), disc_mask(160, 160, {80, 80}, 61.5)) > 0.97);
}

TEST_CASE("The space between legs, or between arm and body, stays outside") {
    Canvas canvas(200, 200);
    canvas.polyline(
        {{40, 60}, {160, 60}, {160, 170}, {140, 170}, {140, 100}, {60, 100}, {60, 170}, {40, 170}, {40, 60}});
    const Mask shape = silhouette_of(ink_of(canvas));
    CHECK(shape(50, 150) == 1);
    CHECK(shape(100, 80) == 1);
    CHECK(shape(100, 140) == 0);
}

TEST_CASE("A leg without a foot is closed at its end, not at its top") {
    Canvas canvas(220, 200);
    canvas.polyline({{60, 180}, {60, 100}, {30, 100}, {30, 30}, {190, 30}, {190, 100}, {78, 100}, {78, 180}});
    const Mask shape = silhouette_of(ink_of(canvas));
    CHECK(shape(110, 65) == 1);
    CHECK(shape(69, 120) == 1);
    CHECK(shape(69, 172) == 1);
    CHECK(shape(69, 190) == 0);
    CHECK(shape(120, 150) == 0);
}

TEST_CASE("A tail of two lines that do not meet is filled") {
    Canvas canvas(260, 120);
    canvas.polyline(
        {{240, 30}, {140, 40}, {110, 20}, {50, 20}, {20, 60}, {50, 100}, {110, 100}, {140, 60}, {240, 55}});
    const Mask shape = silhouette_of(ink_of(canvas));
    CHECK(shape(80, 60) == 1);
    CHECK(shape(180, 46) == 1);
    CHECK(shape(230, 43) == 1);
}

TEST_CASE("The silhouette of a stick figure is its strokes, two and a half pens wide") {
    Canvas canvas(140, 220);
    draw_stick_figure(canvas, {20, 10}, 200, 4);
    const Mask ink = ink_of(canvas), shape = silhouette_of(ink);
    CHECK(pen_width(ink) == Approx(4).margin(1));
    CHECK(shape(70, 40) == 1);  // head
    CHECK(shape(50, 110) == 0); // between arm and leg
    CHECK(shape(70, 190) == 0); // between the legs
    CHECK(shape(70, 120) == 1); // body
    int width = 0;
    for (int x = 50; x < 90; ++x) width += shape(x, 120);
    CHECK(width >= 9);
    CHECK(width <= 12);
}

TEST_CASE("A figure of detached lines stays lines") {
    Canvas canvas(240, 240);
    canvas.arc({120, 40}, 38, 30, 0, 360);
    canvas.polyline({{20, 105}, {115, 85}, {125, 85}, {220, 105}});
    canvas.line({120, 90}, {120, 225});
    canvas.line({75, 230}, {165, 230});
    const Mask shape = silhouette_of(ink_of(canvas));
    CHECK(shape(120, 40) == 1);
    CHECK(shape(80, 160) == 0);
    CHECK(shape(160, 160) == 0);
    CHECK(connected_components(shape).list.size() == 1); // the head hangs on the body
}

TEST_CASE("An outline with a gap almost as wide as itself is not hollow") {
    Canvas canvas(260, 160);
    canvas.polyline(
        {{30, 120}, {30, 60}, {60, 40}, {200, 40}, {230, 60}, {230, 120}, {200, 125}, {120, 125}});
    const Mask ink = ink_of(canvas), shape = silhouette_of(ink); // from (30, 120) to (120, 125): open
    CHECK(shape(130, 80) == 1);
    CHECK(shape(70, 80) == 1);
    CHECK(count(shape) > 3 * count(ink));
}

TEST_CASE("A silhouette is one piece without holes and contains all ink") {
    std::mt19937 random{5};
    for (int trial = 0; trial < 30; ++trial) {
        Canvas canvas(90, 80);
        const auto at = [&] { return Point2d{5.0 + random() % 80, 5.0 + random() % 70}; };
        const int lines = 1 + static_cast<int>(random() % 6);
        for (int i = 0; i < lines; ++i) canvas.line(at(), at(), 1 + random() % 5);
        const Mask ink = ink_of(canvas), shape = silhouette_of(ink);
        CHECK(connected_components(shape).list.size() == 1);
        CHECK(fill_holes(shape) == shape);
        bool contains = true;
        for (std::size_t i = 0; i < ink.size(); ++i) contains = contains && shape.data()[i] >= ink.data()[i];
        CHECK(contains);
    }
}

TEST_CASE("Degenerate ink encloses nothing") {
    CHECK(count(find_enclosed_regions(Mask(20, 20))) == 0);
    CHECK(count(silhouette_of(Mask(20, 20))) == 0);
    CHECK(count(find_enclosed_regions(Mask(20, 20, 1))) == 0);
    CHECK(silhouette_of(Mask(20, 20, 1)) == Mask(20, 20, 1));
    Mask dot(20, 20);
    dot(10, 10) = 1;
    CHECK(count(find_enclosed_regions(dot)) == 0);
    CHECK(silhouette_of(dot)(10, 10) == 1);
    Mask row(40, 5);
    for (int x = 3; x < 37; ++x) row(x, 2) = 1; // all points on one line: no triangle
    CHECK(count(find_enclosed_regions(row)) == 0);
}

TEST_CASE("A silhouette does not depend on where on the page the ink is") {
    Canvas canvas(200, 200), moved(230, 215);
    draw_animal(canvas, {20, 20}, 160, 25);
    draw_animal(moved, {47, 33}, 160, 25);
    CHECK(crop(silhouette_of(ink_of(moved)), {27, 13, 200, 200}) == silhouette_of(ink_of(canvas)));
}
