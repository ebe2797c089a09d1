// SPDX-License-Identifier: MIT
// The whole step on small pages that are drawn here.
#include "pantin/detection.hpp"

#include <catch2/catch.hpp>

#include "canvas.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// The character's mask on the page.
Mask on_page(const Detection& detection, const DetectedCharacter& character) {
    Mask page(detection.width, detection.height);
    const Box& box = character.box;
    const Mask mask = resize_mask(character.mask, box.width, box.height);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) page(box.x + x, box.y + y) = mask(x, y);
    return page;
}

bool has_no_character(const RgbImage& page) {
    try {
        detect(page);
    } catch (const Error& error) {
        return error.kind() == ErrorKind::no_character;
    }
    return false;
}

} // namespace

TEST_CASE("One character: box with margin, crop, scale and filled mask") {
    Canvas canvas(400, 300);
    draw_animal(canvas, {80, 60}, 240, 20);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() == 1);
    const DetectedCharacter& animal = found.characters[0];
    CHECK(animal.scale == 1);
    CHECK(animal.drawing == crop(canvas.image, animal.box));
    CHECK(animal.mask.width() == animal.box.width);
    CHECK(animal.score > 0.9);
    CHECK(animal.score <= 1);
    // Ink from x ≈ 83 to 317: a margin of max(4, 2 %) = 5 pixels.
    CHECK(std::abs(animal.box.x - 78) <= 1);
    CHECK(std::abs(animal.box.x + animal.box.width - 322) <= 2);
    const Mask mask = on_page(found, animal);
    CHECK(mask(188, 168) == 1); // body
    CHECK(mask(284, 132) == 1); // head
    CHECK(mask(140, 250) == 1); // inside a leg
    CHECK(mask(190, 250) == 0); // between the legs
}

TEST_CASE("An outline with gaps is never hollow") {
    for (double gap : {0.0, 8.0, 16.0, 30.0}) {
        INFO("gap " << gap);
        Canvas whole(400, 300), open(400, 300);
        draw_animal(whole, {80, 60}, 240, 0);
        draw_animal(open, {80, 60}, 240, gap);
        const Detection truth = detect(whole.image), found = detect(open.image);
        REQUIRE(found.characters.size() == 1);
        const double iou =
            intersection_over_union(on_page(found, found.characters[0]), on_page(truth, truth.characters[0]));
        CHECK(iou > 0.93);
    }
}

TEST_CASE("Characters side by side are never joined and come left to right, then top to bottom") {
    Canvas canvas(640, 480);
    draw_animal(canvas, {20, 20}, 180, 15);
    draw_animal(canvas, {205, 22}, 180, 15); // 8 px from head to tail
    draw_stick_figure(canvas, {430, 20}, 200);
    draw_stick_figure(canvas, {540, 20}, 200);
    draw_animal(canvas, {20, 250}, 180);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() == 5);
    for (std::size_t i = 1; i < 5; ++i) {
        const Box a = found.characters[i - 1].box, b = found.characters[i].box;
        const int ax = 2 * a.x + a.width, bx = 2 * b.x + b.width;
        CHECK((ax < bx || (ax == bx && 2 * a.y + a.height < 2 * b.y + b.height)));
    }
}

TEST_CASE("Marks inside a character and beside it belong to it, dust does not") {
    Canvas canvas(400, 400);
    canvas.arc({200, 120}, 70, 70, 0, 360); // head
    canvas.disc({175, 110}, 6, 6);          // eyes
    canvas.disc({225, 110}, 6, 6);
    canvas.polyline({{160, 188}, {160, 330}, {240, 330}, {240, 188}, {160, 188}});
    canvas.disc({200, 230}, 5, 5);                                            // button
    canvas.arc({275, 250}, 18, 14, 0, 360);                                   // a hand beside the body
    canvas.polyline({{160, 44}, {240, 44}, {225, 20}, {175, 20}, {160, 44}}); // a hat above the head
    canvas.disc({30, 370}, 1, 1);                                             // dust
    canvas.disc({370, 30}, 1, 1);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() == 1);
    const Mask mask = on_page(found, found.characters[0]);
    CHECK(mask(175, 110) == 1);
    CHECK(mask(275, 250) == 1);
    CHECK(mask(200, 32) == 1);
    CHECK(mask(30, 370) == 0);
    CHECK(connected_components(found.characters[0].mask).list.size() == 1);
}

TEST_CASE("Shadow, yellow paper and noise change little") {
    Canvas clean(480, 360), photo(480, 360, {245, 230, 170});
    for (Canvas* canvas : {&clean, &photo}) draw_animal(*canvas, {100, 60}, 280, 12, 4, {30, 30, 60});
    photo.photograph([](int x, int y) { return 1.0 - 0.35 * x / 480 - 0.15 * y / 360; }, 6);
    const Detection a = detect(clean.image), b = detect(photo.image);
    REQUIRE(a.characters.size() == 1);
    REQUIRE(b.characters.size() == 1);
    CHECK(intersection_over_union(on_page(a, a.characters[0]), on_page(b, b.characters[0])) > 0.95);
}

TEST_CASE("Coloured fills and light pencil are characters") {
    Canvas filled(400, 300);
    filled.disc({200, 130}, 110, 70, {230, 120, 60});
    filled.disc({320, 100}, 40, 40, {60, 120, 230});
    filled.line({150, 180}, {150, 270}, 12, {230, 120, 60});
    filled.line({240, 180}, {240, 270}, 12, {230, 120, 60});
    const Detection a = detect(filled.image);
    REQUIRE(a.characters.size() == 1);
    CHECK(on_page(a, a.characters[0])(200, 130) == 1);
    CHECK(on_page(a, a.characters[0])(195, 250) == 0);

    Canvas pencil(400, 300, {250, 248, 240});
    draw_animal(pencil, {80, 60}, 240, 10, 2, {205, 203, 200});
    pencil.photograph([](int, int) { return 1.0; }, 2);
    const Detection b = detect(pencil.image);
    REQUIRE(b.characters.size() == 1);
    CHECK(on_page(b, b.characters[0])(188, 168) == 1);
}

TEST_CASE("A filled cut-out is its own silhouette, holes and all; one of lines is closed") {
    RgbaImage page(240, 200, Rgba8{0, 0, 0, 0});
    Mask truth(240, 200);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 240; ++x) {
            const bool body = std::hypot(x - 120, y - 110) < 70, hole = std::hypot(x - 90, y - 110) < 12;
            const bool head = std::hypot(x - 120, y - 30) < 24;
            truth(x, y) = (body && !hole) || head;
            if (truth(x, y)) page(x, y) = head ? Rgba8{255, 255, 255, 255} : Rgba8{240, 235, 150, 255};
        }
    RgbImage colours(240, 200, Rgb8{255, 255, 255});
    const Detection found = detect(colours, find_cut_out_ink(page));
    REQUIRE(found.characters.size() == 1);
    CHECK(found.characters[0].exact_mask);
    CHECK(on_page(found, found.characters[0]) == truth);

    // Filled but for the head, which is a line: the head is closed, the hole stays.
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 240; ++x)
            if (std::hypot(x - 120, y - 30) < 20 && y < 44) page(x, y) = {0, 0, 0, 0};
    const Detection hollow = detect(colours, find_cut_out_ink(page));
    REQUIRE(hollow.characters.size() == 1);
    CHECK(on_page(hollow, hollow.characters[0]) == truth);

    RgbaImage lines(240, 200, Rgba8{0, 0, 0, 0});
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 240; ++x)
            if (std::abs(std::hypot(x - 120, y - 100) - 70) < 2) lines(x, y) = {255, 255, 255, 255};
    const Detection closed = detect(colours, find_cut_out_ink(lines));
    REQUIRE(closed.characters.size() == 1);
    CHECK_FALSE(closed.characters[0].exact_mask);
    CHECK(on_page(closed, closed.characters[0])(120, 100) == 1);
}

TEST_CASE("A character's ink is without that of its neighbours") {
    Canvas canvas(500, 300);
    draw_animal(canvas, {20, 60}, 240);
    canvas.arc({262, 235}, 14, 14, 0, 360, 3); // below the head, inside of the animal's box
    draw_animal(canvas, {290, 60}, 190);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() >= 2);
    for (const DetectedCharacter& c : found.characters) {
        CHECK(c.ink.width() == c.drawing.width());
        CHECK(c.ink.height() == c.drawing.height());
        CHECK(*std::max_element(c.ink.begin(), c.ink.end()) == 255);
    }
}

TEST_CASE("Light drawings on a dark page are inverted") {
    Canvas board(400, 300, {30, 40, 35});
    draw_animal(board, {80, 60}, 240, 10, 3, {240, 240, 240});
    const Detection found = detect(board.image);
    REQUIRE(found.characters.size() == 1);
    CHECK(on_page(found, found.characters[0])(188, 168) == 1);
    CHECK(found.characters[0].drawing(5, 5) == board.image(0, 0)); // the drawing itself stays as it is
    CHECK(found.characters[0].ink(5, 5) == 0);                     // and the board is paper
}

TEST_CASE("The sheet's edge, the table around it, ruled lines and a frame are no characters") {
    Canvas canvas(480, 360, {90, 60, 40});
    for (int y = 20; y < 345; ++y)
        for (int x = 25; x < 460; ++x) canvas.image(x, y) = {240, 238, 230};
    draw_animal(canvas, {120, 60}, 240, 10);
    const Detection table = detect(canvas.image);
    REQUIRE(table.characters.size() == 1);
    CHECK(std::abs(table.characters[0].box.x - 118) < 8);

    Canvas ruled(480, 400);
    for (int y : {20, 55, 350, 380}) ruled.line({0, 1.0 * y}, {479, 1.0 * y}, 2, {120, 150, 220});
    draw_animal(ruled, {120, 80}, 240, 10);
    REQUIRE(detect(ruled.image).characters.size() == 1);

    Canvas framed(480, 400);
    framed.polyline({{20, 20}, {460, 20}, {460, 380}, {20, 380}, {20, 20}});
    draw_animal(framed, {60, 80}, 160, 10);
    draw_animal(framed, {260, 80}, 160, 10);
    CHECK(detect(framed.image).characters.size() == 2);
}

TEST_CASE("A character that is cut by the page's border is kept") {
    Canvas canvas(320, 240);
    draw_animal(canvas, {-20, 30}, 220, 10);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() == 1);
    CHECK(found.characters[0].box.x == 0);
    CHECK(on_page(found, found.characters[0])(79, 129) == 1);
}

TEST_CASE("A large page has a mask of at most the working size") {
    Canvas canvas(700, 560);
    draw_animal(canvas, {40, 20}, 620, 10, 6);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() == 1);
    const DetectedCharacter& animal = found.characters[0];
    CHECK(std::max(animal.mask.width(), animal.mask.height()) == 512);
    CHECK(animal.scale == Approx(512.0 / std::max(animal.box.width, animal.box.height)));
    CHECK(animal.drawing.width() == animal.box.width);
    DetectionOptions thesis;
    thesis.working_size = 321;
    const Mask mask = detect(canvas.image, thesis).characters[0].mask;
    CHECK(std::max(mask.width(), mask.height()) == 321);
}

TEST_CASE("At most 64 characters are kept, the largest ones") {
    Canvas canvas(900, 900);
    for (int i = 0; i < 81; ++i)
        canvas.arc({50.0 + 100 * (i % 9), 50.0 + 100 * (i / 9)}, i < 64 ? 30 : 20, i < 64 ? 30 : 20, 0, 360);
    const Detection found = detect(canvas.image);
    REQUIRE(found.characters.size() == 64);
    for (const DetectedCharacter& character : found.characters) CHECK(character.box.width > 60);
}

TEST_CASE("Pages without a character say so") {
    CHECK(has_no_character(RgbImage(64, 64, Rgb8{255, 255, 255})));
    CHECK(has_no_character(RgbImage(64, 64, Rgb8{0, 0, 0})));
    CHECK(has_no_character(RgbImage(640, 480, Rgb8{200, 190, 150})));
    CHECK(has_no_character(RgbImage(16, 16, Rgb8{255, 255, 255})));
    Canvas noise(320, 240, {200, 200, 200});
    noise.photograph([](int, int) { return 1.0; }, 12);
    CHECK(has_no_character(noise.image));
    Canvas dust(320, 240);
    dust.disc({100, 100}, 1, 1);
    CHECK(has_no_character(dust.image));
}
