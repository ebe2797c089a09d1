// SPDX-License-Identifier: MIT
// Generated drawings: their truth, their variety, the same bytes from the same seed.
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>

#include <catch2/catch.hpp>

#include "doodle/doodle.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pantin/label.hpp"
#include "plain.hpp"

using namespace pantin;
using namespace pantin::doodle;

namespace {

std::array<long, label_count> areas(const LabelMap& labels) {
    std::array<long, label_count> count{};
    long unknown = 0;
    for (std::uint8_t label : labels) ++(label < label_count ? count[label] : unknown);
    CHECK(unknown == 0);
    return count;
}

long area_of(const LabelMap& labels, Label label) { return areas(labels)[static_cast<std::size_t>(label)]; }

double middle_x(const LabelMap& labels, Label label) {
    double sum = 0;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) sum += labels(x, y) == static_cast<int>(label) ? x : 0;
    return sum / area_of(labels, label);
}

void check_whole(const LabelMap& labels, const Box& box) {
    const Mask mask = foreground(labels);
    const Components pieces = connected_components(mask);
    REQUIRE(pieces.list.size() == 1);
    CHECK(pieces.list.front().box == box);
    CHECK(fill_holes(mask) == mask);
}

} // namespace

TEST_CASE("a doodle follows from its seed to the bit") {
    DoodleOptions options;
    options.width = options.height = 160;
    options.photo = options.colour = 0.5;
    for (const std::string& type : character_types())
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            const Doodle a = draw_character(type, seed, options), b = draw_character(type, seed, options);
            CHECK(a.picture == b.picture);
            CHECK(a.labels == b.labels);
            CHECK((a.species == b.species && a.pose == b.pose && a.box == b.box));
            CHECK_FALSE(a.picture == draw_character(type, seed + 100, options).picture);
        }
}

TEST_CASE("every species has a head, a body and what moves it, in one piece without holes") {
    for (const std::string& type : character_types())
        for (const std::string& species : species_of(type))
            for (std::uint64_t seed = 0; seed < 5; ++seed) {
                INFO(species << " " << seed);
                DoodleOptions options = plain(160);
                options.species = species;
                const Doodle d = draw_character(type, seed, options);
                CHECK(d.type == type);
                CHECK(d.species == species);
                const auto count = areas(d.labels);
                CHECK(count[1] > 20);
                CHECK(count[2] > 20);
                CHECK(count[type == "flying" ? 5 : 3] > 20);
                check_whole(d.labels, d.box);
                CHECK(std::max(d.box.width, d.box.height) > 70);
            }
}

TEST_CASE("ink lies on the silhouette, and the silhouette's border lies under ink") {
    double outside = 0, inked = 0, bare = 0, border = 0;
    for (std::uint64_t seed = 0; seed < 45; ++seed) {
        DoodleOptions options = plain(200);
        options.gaps = 0.0, options.pen = 3.0;
        const Doodle d = draw_character(character_types()[seed % 3], seed, options);
        const GreyImage grey = greyscale(d.picture);
        Mask ink(grey.width(), grey.height());
        for (std::size_t i = 0; i < grey.size(); ++i) ink.data()[i] = grey.data()[i] < 190;
        const Mask body = foreground(d.labels), near_body = dilate_square(body, 2),
                   near_ink = dilate_square(ink, 5);
        const Mask core = erode_square(body, 1);
        for (std::size_t i = 0; i < ink.size(); ++i) {
            inked += ink.data()[i];
            outside += ink.data()[i] && !near_body.data()[i];
            const bool edge = body.data()[i] && !core.data()[i];
            border += edge;
            bare += edge && !near_ink.data()[i];
        }
    }
    CHECK(outside / inked < 0.005);
    CHECK(bare / border < 0.06);
}

TEST_CASE("an animal that faces right has its head on the right") {
    std::set<std::string> poses;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        DoodleOptions options = plain(128);
        options.species = "horse";
        const Doodle d = draw_character("quadruped", seed, options);
        poses.insert(d.pose);
        const double lead = middle_x(d.labels, Label::head) - middle_x(d.labels, Label::body);
        if (d.pose == "E") CHECK(lead > 0);
        if (d.pose == "W") CHECK(lead < 0);
    }
    CHECK(poses.count("E") == 1);
    CHECK(poses.count("W") == 1);
}

TEST_CASE("the characters of a page keep apart and their boxes hold their labels") {
    DoodleOptions options = plain(420);
    options.height = 300;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Page page = draw_page({"humanoid", "quadruped:cow", "flying", "head", "blob"}, seed, options);
        REQUIRE(page.characters.size() == 5);
        CHECK(page.characters[1].species == "cow");
        std::set<int> seen;
        long unequal = 0, beyond = 0;
        for (int y = 0; y < 300; ++y)
            for (int x = 0; x < 420; ++x) {
                const int id = page.instances(x, y);
                unequal += (id != 0) != (page.labels(x, y) != 0);
                if (id == 0) continue;
                const Box& box = page.characters[static_cast<std::size_t>(id) - 1].box;
                beyond += x < box.x || x >= box.x + box.width || y < box.y || y >= box.y + box.height;
                seen.insert(id);
            }
        CHECK(unequal == 0);
        CHECK(beyond == 0);
        CHECK(seen.size() == 5);
        CHECK(connected_components(foreground(page.labels)).list.size() == 5);
    }
}

TEST_CASE("heads, blobs and scribbles have one part only") {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const auto head = areas(draw_character("head", seed, plain(128)).labels);
        CHECK((head[1] > 500 && head[2] + head[3] + head[4] + head[5] == 0));
        const auto blob = areas(draw_character("blob", seed, plain(128)).labels);
        CHECK((blob[2] > 500 && blob[1] + blob[3] + blob[4] + blob[5] == 0));
        CHECK(area_of(draw_character("scribble", seed, plain(128)).labels, Label::body) > 100);
    }
}

TEST_CASE("a photographed page is darker, coloured and uneven, with the same truth") {
    DoodleOptions options = plain(160);
    const Doodle screen = draw_character("humanoid", 3, options);
    options.photo = 1.0;
    const Doodle photo = draw_character("humanoid", 3, options);
    CHECK(screen.labels == photo.labels);
    CHECK(screen.picture(0, 0) == Rgb8{255, 255, 255});
    std::set<int> shades;
    for (const Rgb8& pixel : photo.picture) shades.insert(pixel.g);
    CHECK(shades.size() > 40);
    CHECK(greyscale(photo.picture)(0, 0) < 252);
}

TEST_CASE("unknown types, unknown species and tiny pages are refused") {
    CHECK_THROWS_AS(draw_character("fish", 1), Error);
    CHECK_THROWS_AS(draw_character("quadruped:bee", 1), Error);
    CHECK_THROWS_AS(draw_character("humanoid", 1, plain(63)), Error);
    CHECK_THROWS_AS(draw_page({"humanoid", "nobody"}, 1), Error);
}

TEST_CASE("testdata is what the generator draws today") {
    // The same options as in tools/make_testdata.sh; the seed is 1000003·series + number.
    DoodleOptions options = plain(640);
    options.height = 480, options.pen = 4, options.fill = 0.9;
    CHECK(draw_character("humanoid", 21'000'063u + 6, options).picture ==
          load_image("testdata/humanoid.png"));
    DoodleOptions small = plain(320);
    small.pen = 3, small.fill = 0.95;
    const LabelMap labels = draw_character("quadruped", 22'000'066u + 8, small).labels;
    CHECK(labels == load_grey("testdata/labels_quadruped.png"));
    DoodleOptions photo = plain(640);
    photo.height = 480, photo.photo = 1.0, photo.paper = 0.1, photo.colour = 0.25, photo.fill = 0.85;
    const Doodle drawing = draw_character(character_types()[10 % 3], 24'000'072u + 10, photo);
    std::ifstream file("testdata/photo.jpg", std::ios::binary);
    const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
    CHECK(encode_jpeg(drawing.picture) == bytes);
}
