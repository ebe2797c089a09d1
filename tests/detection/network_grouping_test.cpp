// SPDX-License-Identifier: MIT
// Ink grouped by what a network claims: whole pieces, divided pieces, pieces that nobody claims; the finder
// on a page with a small network.
#include <catch2/catch.hpp>

#include "core/file.hpp"
#include "detection/network_grouping.hpp"
#include "pantin/image.hpp"

namespace pantin {
namespace {

void fill(Mask& mask, const Box& box) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) mask(x, y) = 1;
}
void claim(Grid<int>& owner, const Box& box, int number) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) owner(x, y) = number;
}

} // namespace

TEST_CASE("A piece of ink goes whole to the detection that claims most of it") {
    Mask ink(60, 40);
    fill(ink, {5, 5, 20, 10});
    fill(ink, {40, 5, 10, 20});
    Claims claims{Grid<int>(60, 40, 0), {0.9, 0.8}};
    claim(claims.owner, {0, 0, 24, 40}, 2); // sees all but one column
    claim(claims.owner, {24, 0, 2, 40}, 1);
    claim(claims.owner, {42, 0, 6, 10}, 1);
    DetectionOptions far;
    far.claimed_reach = 10;
    const Grouping grouping = group_by_claims(ink, claims, far);
    REQUIRE(grouping.boxes.size() == 2);
    CHECK(grouping.boxes[0] == Box{40, 5, 10, 20});
    CHECK(grouping.boxes[1] == Box{5, 5, 20, 10});
    CHECK(grouping.scores == std::vector<double>{0.9, 0.8});
    CHECK(grouping.groups(24, 5) == 2);
    CHECK(grouping.groups(45, 24) == 1);
    CHECK(grouping.groups(0, 0) == 0);
}

TEST_CASE("Characters that touch are divided at the claims") {
    Mask ink(60, 20);
    fill(ink, {5, 8, 50, 4});
    Claims claims{Grid<int>(60, 20, 0), {0.9, 0.8}};
    claim(claims.owner, {5, 0, 20, 20}, 1);
    claim(claims.owner, {35, 0, 20, 20}, 2);
    DetectionOptions far;
    far.claimed_reach = 10;
    const Grouping grouping = group_by_claims(ink, claims, far);
    REQUIRE(grouping.boxes.size() == 2);
    CHECK(grouping.groups(28, 9) == 1);
    CHECK(grouping.groups(31, 9) == 2);
}

TEST_CASE("Ink that nobody claims belongs to what is near, or to nothing") {
    Mask ink(100, 40);
    fill(ink, {10, 5, 30, 30});
    fill(ink, {41, 12, 1, 3}); // a finger
    fill(ink, {80, 10, 4, 4}); // a stain
    Claims claims{Grid<int>(100, 40, 0), {0.9, 0.7}};
    claim(claims.owner, {10, 5, 30, 30}, 1);
    claim(claims.owner, {60, 0, 5, 5}, 2); // sees a character where no ink is
    const Grouping grouping = group_by_claims(ink, claims, {});
    REQUIRE(grouping.boxes.size() == 1);
    CHECK(grouping.boxes[0] == Box{10, 5, 32, 30});
    CHECK(grouping.groups(41, 13) == 1);
    CHECK(grouping.groups(82, 12) == 0);
}

TEST_CASE("A line of grass is a character's as far as the character reaches, a house beside it not at all") {
    Mask ink(300, 100);
    fill(ink, {100, 20, 40, 60});
    fill(ink, {0, 78, 300, 2});   // grass, through the feet
    fill(ink, {143, 30, 80, 40}); // a house, near
    Claims claims{Grid<int>(300, 100, 0), {0.9}};
    claim(claims.owner, {100, 20, 40, 60}, 1);
    const Grouping grouping = group_by_claims(ink, claims, {});
    REQUIRE(grouping.boxes.size() == 1);
    CHECK(grouping.groups(98, 79) == 1);
    CHECK(grouping.groups(80, 79) == 0);
    CHECK(grouping.groups(180, 79) == 0);
    CHECK(grouping.groups(143, 50) == 0);
    CHECK(grouping.groups(200, 50) == 0);
}

TEST_CASE("Of two claims on a pixel the stronger counts, where the mask is at least one half") {
    CharacterFinder::Found a{0.9, 0, 0, 40, 40, Grid<float>(28, 28, 0.6f)};
    CharacterFinder::Found b{0.8, 20, 0, 60, 40, Grid<float>(28, 28, 0.9f)};
    CharacterFinder::Found faint{1.0, 0, 0, 80, 40, Grid<float>(28, 28, 0.4f)};
    const Grid<int> owner = CharacterFinder::claims({a, b, faint}, 40, 20, 2);
    CHECK(owner(5, 5) == 1);
    CHECK(owner(15, 5) == 2);
    CHECK(owner(28, 5) == 2);
    CHECK(owner(35, 5) == 0);
}

TEST_CASE("A detection mostly inside a larger one of no lower score is a part of it") {
    const auto found = [](double score, double left, double right, float inside) {
        return CharacterFinder::Found{score, left, 0, right, 40, Grid<float>(28, 28, inside)};
    };
    const auto count = [](std::vector<CharacterFinder::Found> list, const DetectionOptions& options = {}) {
        return whole_characters(std::move(list), options).size();
    };
    const CharacterFinder::Found whole = found(0.9, 0, 80, 0.9f);
    CHECK(count({whole, found(0.8, 10, 40, 0.9f)}) == 1);
    CHECK(count({whole, found(0.8, 10, 40, 0.9f)}, {.contained_share = 1.01}) == 2);
    CHECK(count({whole, found(0.8, 70, 110, 0.9f)}) == 2);                  // a quarter of it lies inside
    CHECK(count({found(0.9, 0, 80, 0.2f), found(0.8, 10, 40, 0.9f)}) == 2); // the larger mask does not say so
    CHECK(count({found(0.95, 10, 40, 0.9f), whole}) == 2);  // the smaller one has the higher score
    CHECK(count({whole, whole}) == 2);                      // neither is larger
    CHECK(count({whole, found(0.4, 100, 140, 0.9f)}) == 1); // too low a score
}

TEST_CASE("The finder reads a page of any size and gives places on it") {
    const std::vector<unsigned char> bytes = read_file("testdata/mask_rcnn_tiny.safetensors");
    const CharacterFinder finder(bytes, "tiny");
    const RgbImage page = load_image("testdata/demo.png");
    const std::vector<CharacterFinder::Found> found = finder.find(page, ink_darkness(page), 2);
    REQUIRE(!found.empty());
    for (const CharacterFinder::Found& f : found) {
        CHECK(f.left >= 0);
        CHECK(f.top >= 0);
        CHECK(f.right <= page.width() + 1e-3);
        CHECK(f.bottom <= page.height() + 1e-3);
        CHECK(f.mask.width() == 28);
    }
    for (std::size_t i = 1; i < found.size(); ++i) CHECK(found[i - 1].score >= found[i].score);
    const std::vector<CharacterFinder::Found> again = finder.find(page, ink_darkness(page), 1);
    REQUIRE(again.size() == found.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(again[i].mask == found[i].mask);
}

} // namespace pantin
