// SPDX-License-Identifier: MIT
// Things without labels, scenes with the truth of their characters, looks, sheets on a desk.
#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "doodle/doodle.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pantin/label.hpp"

using namespace pantin;
using namespace pantin::doodle;

namespace {

DoodleOptions plain(int width, int height) {
    DoodleOptions options;
    options.width = width, options.height = height;
    options.photo = options.paper = options.colour = 0.0;
    return options;
}

long inked(const RgbImage& picture, const Box& box) {
    const GreyImage grey = greyscale(picture);
    long count = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) count += grey(x, y) < 235;
    return count;
}

Mask instance(const Page& page, std::size_t k) {
    Mask mask(page.instances.width(), page.instances.height());
    for (std::size_t i = 0; i < mask.size(); ++i) mask.data()[i] = page.instances.data()[i] == k + 1;
    return mask;
}

bool meet(const Box& a, const Box& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

// How much the colour differs between two places.
double step_at(const RgbImage& picture, Point2d inside, Point2d outside) {
    const Rgb8 a = picture(static_cast<int>(inside.x), static_cast<int>(inside.y)),
               b = picture(static_cast<int>(outside.x), static_cast<int>(outside.y));
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

} // namespace

TEST_CASE("things have ink and no labels, every species in its own way") {
    const std::vector<std::string> species = species_of("thing");
    CHECK(species.size() == 27);
    for (const std::string& name : species) {
        std::set<std::vector<std::uint8_t>> pictures;
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            INFO(name << " " << seed);
            DoodleOptions options = plain(128, 128);
            options.species = name;
            const Doodle d = draw_character("thing", seed, options);
            CHECK(d.type == "thing");
            CHECK(d.species == name);
            CHECK(std::all_of(d.labels.begin(), d.labels.end(), [](int label) { return label == 0; }));
            CHECK(inked(d.picture, {0, 0, 128, 128}) > 60);
            const GreyImage grey = greyscale(d.picture);
            pictures.insert({grey.begin(), grey.end()});
        }
        CHECK(pictures.size() == 4);
    }
    CHECK_THROWS_AS(draw_character("thing:dragon", 1), Error);
}

TEST_CASE("a thing among characters leaves no instance") {
    const Page page = draw_page({"humanoid", "thing:house", "quadruped"}, 3, plain(480, 200));
    REQUIRE(page.characters.size() == 3);
    CHECK(page.characters[1].type == "thing");
    std::set<int> seen(page.instances.begin(), page.instances.end());
    CHECK(seen == std::set<int>{0, 1, 3});
}

TEST_CASE("a scene's truth holds its characters and nothing of its things") {
    std::set<std::string> kinds_of_things;
    int through = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        INFO(seed);
        const Page page = draw_scene("family", seed, plain(500, 360));
        CHECK(page.characters.size() >= 2);
        CHECK(page.characters.size() <= 6);
        CHECK(page.things.size() >= 1);
        long unequal = 0;
        std::vector<long> area(page.characters.size() + 1, 0);
        for (std::size_t i = 0; i < page.labels.size(); ++i) {
            unequal += (page.labels.data()[i] != 0) != (page.instances.data()[i] != 0);
            ++area.at(page.instances.data()[i]);
        }
        CHECK(unequal == 0);
        for (std::size_t k = 0; k < page.characters.size(); ++k) {
            const Character& c = page.characters[k];
            CHECK((c.type == "humanoid" || c.type == "quadruped" || c.type == "flying"));
            CHECK(area[k + 1] > 150);
            CHECK(connected_components(instance(page, k)).list.size() == 1);
            for (std::size_t j = 0; j < k; ++j) CHECK_FALSE(meet(c.box, page.characters[j].box));
        }
        for (const Character& thing : page.things) {
            kinds_of_things.insert(thing.species);
            CHECK(thing.type == "thing");
            if (thing.box.width == 0) continue;
            CHECK(inked(page.picture, thing.box) > 0);
            if (thing.species == "grass line")
                for (const Character& c : page.characters) through += meet(thing.box, c.box);
        }
        CHECK(page.picture == draw_scene("family", seed, plain(500, 360)).picture);
    }
    for (const char* name : {"sun", "house", "grass line", "word"}) CHECK(kinds_of_things.count(name) == 1);
    CHECK(through > 3); // lines of grass at people's feet
    CHECK_THROWS_AS(draw_scene("party", 1), Error);
}

TEST_CASE("a look changes the colours and not the truth") {
    for (const std::string& look : looks())
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            INFO(look << " " << seed);
            DoodleOptions options = plain(160, 160);
            options.pen = 2.5;
            const Doodle usual = draw_character("quadruped", seed, options);
            options.look = look;
            const Doodle d = draw_character("quadruped", seed, options);
            CHECK(d.species == usual.species);
            CHECK_FALSE(d.picture == usual.picture);
            const Rgb8 ground = d.picture(0, 0);
            const int light = ground.r + ground.g + ground.b;
            if (look == "chalk") CHECK(light < 300);
            if (look == "crayon") CHECK(ground == Rgb8{255, 255, 255});
            if (look == "tinted" || look == "kraft") CHECK((light > 250 && light < 730));
            if (look == "grid") CHECK(d.labels == usual.labels);
            if (look == "chalk") { // the strokes are lighter than the board
                const GreyImage grey = greyscale(d.picture);
                CHECK(*std::max_element(grey.begin(), grey.end()) > greyscale(d.picture)(0, 0) + 60);
            }
        }
    DoodleOptions options = plain(160, 160);
    options.look = "neon";
    CHECK_THROWS_AS(draw_character("humanoid", 1, options), Error);
}

TEST_CASE("without outlines an area has one colour up to its border") {
    DoodleOptions options = plain(200, 200);
    options.look = "no-outline", options.species = "teddy";
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Doodle d = draw_character("humanoid", seed, options);
        const Mask body = foreground(d.labels), core = erode_square(body, 2);
        const Rgb8 ground = d.picture(0, 0);
        long bare = 0, edge = 0, beyond = 0;
        const Mask around = dilate_square(body, 2);
        for (std::size_t i = 0; i < body.size(); ++i) {
            const bool same = d.picture.data()[i] == ground;
            if (core.data()[i]) ++edge, bare += same;
            beyond += !around.data()[i] && !same;
        }
        CHECK(bare < 0.03 * edge);
        CHECK(beyond == 0);
    }
}

TEST_CASE("a sheet on a desk lies where its corners say, with the flat page's truth") {
    const DoodleOptions options = plain(640, 480);
    const DoodleOptions sheet = sheet_options(options);
    CHECK(sheet.width == 512);
    CHECK(sheet.height == 362);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        INFO(seed);
        const Page flat = draw_scene("family", seed, sheet);
        const DeskPhoto photo = on_desk(flat, seed, 640, 480);
        CHECK(photo.page.picture.width() == 640);
        CHECK(photo.page.picture.height() == 480);
        Point2d middle{0, 0};
        for (Point2d p : photo.corners) middle = middle + 0.25 * p;
        double steps = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const Point2d a = photo.corners[i], b = photo.corners[(i + 1) % 4];
            CHECK((a.x >= 0 && a.y >= 0 && a.x < 640 && a.y < 480));
            CHECK(cross(b - a, middle - a) > 0); // clockwise on the page, convex
            const Point2d edge = 0.5 * (a + b), inward = (1.0 / distance(edge, middle)) * (middle - edge);
            steps += step_at(photo.page.picture, edge + 8.0 * inward, edge - 8.0 * inward);
        }
        CHECK(steps > 200); // paper is lighter than the desk on all sides together
        REQUIRE(photo.page.characters.size() == flat.characters.size());
        // Corner by corner: labels lie inside the sheet only, and nearly as much of it is labelled as of the
        // flat page.
        long outside = 0, labelled = 0, area = 0, flat_labelled = 0;
        for (int y = 0; y < 480; ++y)
            for (int x = 0; x < 640; ++x) {
                bool inside = true;
                for (std::size_t i = 0; i < 4; ++i) {
                    const Point2d a = photo.corners[i], b = photo.corners[(i + 1) % 4];
                    inside =
                        inside && cross(b - a, Point2d{double(x), double(y)} - a) > -1.0 * distance(a, b);
                }
                area += inside;
                labelled += photo.page.labels(x, y) != 0;
                outside += photo.page.labels(x, y) != 0 && !inside;
            }
        for (std::uint8_t label : flat.labels) flat_labelled += label != 0;
        CHECK(outside == 0);
        const double share = static_cast<double>(labelled) / area,
                     wanted = static_cast<double>(flat_labelled) / flat.labels.size();
        CHECK(share > 0.6 * wanted);
        CHECK(share < 1.7 * wanted);
        CHECK(photo.page.picture == on_desk(flat, seed, 640, 480).page.picture);
    }
}
