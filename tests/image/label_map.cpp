// SPDX-License-Identifier: MIT
// Pieces of parts and the nearest part.
#include <catch2/catch.hpp>

#include "image/label_map.hpp"
#include "image/nearest_pixel.hpp"

using namespace pantin;

TEST_CASE("pieces are 8-connected, in raster order, and small ones are left out") {
    LabelMap labels(6, 4);
    labels(0, 0) = labels(1, 1) = 3; // one piece, by a corner
    labels(4, 1) = labels(4, 2) = labels(3, 3) = 3;
    labels(5, 0) = 5;
    const std::vector<LabelPiece> pieces = pieces_of(part_mask(labels, {Label::limb}));
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].pixels == std::vector<Point2i>{{0, 0}, {1, 1}});
    CHECK(pieces[1].box == Box{3, 1, 2, 3});
    CHECK(cropped_mask(pieces[1])(0, 2) == 1);
    CHECK(pieces_of(part_mask(labels, {Label::limb}), 3).size() == 1);
    CHECK(pieces_of(part_mask(labels, {Label::limb, Label::wing})).size() == 2);
}

TEST_CASE("every pixel takes the label of the nearest one that has one") {
    LabelMap labels(5, 1);
    CHECK(nearest_labels(labels) == labels);
    labels(0, 0) = 1;
    labels(4, 0) = 2;
    const LabelMap filled = nearest_labels(labels);
    CHECK(filled(1, 0) == 1);
    CHECK(filled(2, 0) == 1);
    CHECK(filled(3, 0) == 2);
}

TEST_CASE("a point between pixels has the value of the nearest, one beside the grid that of the border") {
    Grid<int> grid(3, 1);
    grid(1, 0) = 7;
    grid(2, 0) = 9;
    CHECK(at_nearest(grid, {0.6, 0.3}) == 7);
    CHECK(at_nearest(grid, {5, -4}) == 9);
    CHECK(pixel_at({0.5, 1.5}) == Point2i{0, 2});
    CHECK(pixel_at_or_after({0.5, -0.5}) == Point2i{1, 0});
}
