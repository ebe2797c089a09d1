// SPDX-License-Identifier: MIT
// A sheet in a photograph: found, its corners, its flat picture; and what is no sheet.
#include <catch2/catch.hpp>

#include <random>

#include "detection/canvas.hpp"
#include "pantin/sheet.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// Whether p lies in the convex polygon whose corners go clockwise on the screen.
bool inside(const SheetCorners& corners, Point2d p) {
    for (std::size_t i = 0; i < 4; ++i)
        if (cross(corners[(i + 1) % 4] - corners[i], p - corners[i]) < 0) return false;
    return true;
}

RgbImage desk_with(const SheetCorners& corners, Rgb8 sheet, Rgb8 desk, int width = 640, int height = 480) {
    std::mt19937 random{17};
    RgbImage picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb8 c = inside(corners, {x + 0.5, y + 0.5}) ? sheet : desk;
            const int noise = static_cast<int>(random() % 7) - 3;
            const auto shake = [&](std::uint8_t v) {
                return static_cast<std::uint8_t>(std::clamp(v + noise, 0, 255));
            };
            picture(x, y) = {shake(c.r), shake(c.g), shake(c.b)};
        }
    return picture;
}

double largest_error(const SheetCorners& a, const SheetCorners& b) {
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) most = std::max(most, distance(a[i], b[i]));
    return most;
}

} // namespace

TEST_CASE("A sheet on a desk is found, its corners to two pixels") {
    const std::vector<SheetCorners> sheets = {{{{120, 60}, {560, 100}, {520, 420}, {70, 380}}},
                                              {{{200, 40}, {430, 40}, {600, 440}, {40, 430}}},
                                              {{{60, 50}, {590, 45}, {585, 440}, {66, 430}}}};
    for (const SheetCorners& corners : sheets)
        for (const Rgb8 desk : {Rgb8{90, 60, 40}, Rgb8{30, 32, 35}, Rgb8{200, 170, 120}}) {
            const std::optional<SheetCorners> found = find_sheet(desk_with(corners, {235, 234, 228}, desk));
            REQUIRE(found);
            CHECK(largest_error(*found, corners) < 2);
        }
}

TEST_CASE("What is drawn on a sheet, up to its edge, does not hide it") {
    const SheetCorners corners{{{120, 60}, {560, 100}, {520, 420}, {70, 380}}};
    Canvas canvas(640, 480);
    canvas.image = desk_with(corners, {240, 240, 236}, {80, 70, 60});
    draw_animal(canvas, {200, 140}, 220);
    canvas.line({300, 250}, {300, 430}, 4); // beyond the edge
    const std::optional<SheetCorners> found = find_sheet(canvas.image);
    REQUIRE(found);
    CHECK(largest_error(*found, corners) < 2);
}

TEST_CASE("A page without a desk, a framed drawing, half a shadow and a small card are no sheets") {
    Canvas page(640, 480, {244, 242, 235});
    draw_animal(page, {200, 140}, 220);
    CHECK_FALSE(find_sheet(page.image));
    Canvas framed = page;
    framed.polyline({{40, 40}, {600, 40}, {600, 440}, {40, 440}, {40, 40}}, 5);
    CHECK_FALSE(find_sheet(framed.image));
    Canvas shadow = page;
    for (int y = 0; y < 480; ++y)
        for (int x = 0; x < 640; ++x)
            if (x + y > 600) {
                Rgb8& c = shadow.image(x, y);
                c = {static_cast<std::uint8_t>(c.r * 0.7), static_cast<std::uint8_t>(c.g * 0.7),
                     static_cast<std::uint8_t>(c.b * 0.7)};
            }
    CHECK_FALSE(find_sheet(shadow.image));
    CHECK_FALSE(find_sheet(
        desk_with({{{250, 200}, {350, 200}, {350, 280}, {250, 280}}}, {240, 240, 240}, {80, 60, 40})));
    CHECK_FALSE(find_sheet(RgbImage(40, 40, Rgb8{200, 200, 200})));
}

TEST_CASE("A flattened sheet has the proportions of the sheet, and its corners in its corners") {
    // A camera above an A4 sheet of 297 × 210, tilted by 35°.
    const double c = std::cos(0.61), s = std::sin(0.61), focal = 0.75 * 640, away = 480;
    SheetCorners corners;
    const std::array<Point2d, 4> sheet{{{-148.5, -105}, {148.5, -105}, {148.5, 105}, {-148.5, 105}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const double depth = away - s * sheet[i].y;
        corners[i] = {320 + focal * sheet[i].x / depth, 240 + focal * c * sheet[i].y / depth};
    }
    RgbImage picture = desk_with(corners, {240, 240, 240}, {60, 50, 40});
    const Point2d mark = 0.9 * corners[1] + 0.1 * corners[3]; // on the diagonal, near the top right corner
    for (int y = -4; y <= 4; ++y)
        for (int x = -4; x <= 4; ++x)
            picture(static_cast<int>(mark.x) + x, static_cast<int>(mark.y) + y) = {0, 0, 0};
    const RgbImage flat = flattened(picture, corners);
    CHECK(static_cast<double>(flat.width()) / flat.height() == Approx(297.0 / 210).epsilon(0.03));
    int dark = 0, in_corner = 0;
    for (int y = 0; y < flat.height(); ++y)
        for (int x = 0; x < flat.width(); ++x)
            if (flat(x, y).r < 100) ++dark, in_corner += x > 0.8 * flat.width() && y < 0.25 * flat.height();
    CHECK(dark > 40);
    CHECK(in_corner == dark);
}
