// SPDX-License-Identifier: MIT
// Warnings about the silhouette: values worked out by hand.
#include <catch2/catch.hpp>

#include "pantin/image.hpp"
#include "pantin/warnings.hpp"
#include "warnings/figures.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

template <class T> void paint(Grid<T>& grid, Box box, T value) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) grid(x, y) = value;
}

// A silhouette of 40 × 40 pixels in a crop of 100 × 100, with 20 × 20 pixels of black ink in it.
struct Drawn {
    Grid<float> ink{100, 100};
    LabelMap labels{100, 100};
    Mask mask{100, 100};
    Drawn() {
        fill(labels, 20, 20, 60, 60, Label::body);
        paint<std::uint8_t>(mask, {20, 20, 40, 40}, 1);
        paint(ink, {30, 30, 20, 20}, 1.0F);
    }
    double lost() const { return lost_ink(ink, mask, labels); }
};

} // namespace

TEST_CASE("A silhouette that fills its crop is marked, one that leaves a third of it is not", "[warnings]") {
    LabelMap labels(20, 10);
    CHECK(filled_crop(labels) == 0);
    fill(labels, 0, 0, 20, 10, Label::head);
    CHECK(filled_crop(labels) == 1);
    fill(labels, 0, 0, 10, 5, Label::background);
    CHECK(filled_crop(labels) == Approx(0.75));
    CHECK(is_marked(WarningKind::filled_crop, filled_crop(labels)));
    fill(labels, 10, 0, 14, 5, Label::background);
    CHECK(filled_crop(labels) == Approx(0.65));
    CHECK_FALSE(is_marked(WarningKind::filled_crop, filled_crop(labels)));
    CHECK(filled_crop(LabelMap()) == 0);
}

TEST_CASE("Ink outside of the silhouette counts by its darkness", "[warnings]") {
    Drawn drawn;
    CHECK(drawn.lost() == 0);
    paint(drawn.ink, {70, 70, 10, 10}, 0.5F); // a piece of its own
    CHECK(drawn.lost() == Approx(50.0 / 450));
    CHECK(is_marked(WarningKind::lost_ink, drawn.lost()));
    paint(drawn.ink, {70, 70, 10, 10}, 0.25F);
    CHECK(drawn.lost() == Approx(25.0 / 425));
    CHECK_FALSE(is_marked(WarningKind::lost_ink, drawn.lost()));
    paint(drawn.ink, {70, 70, 10, 10}, 0.15F); // no ink, but noise
    CHECK(drawn.lost() == 0);
}

TEST_CASE("Ink that the texture reaches, and a neighbour's ink, are not lost", "[warnings]") {
    Drawn drawn;
    REQUIRE(ink_margin(100, 100) == 2);
    paint(drawn.ink, {60, 30, 2, 20}, 1.0F); // the outer half of the outline
    CHECK(drawn.lost() == 0);
    paint(drawn.ink, {60, 30, 3, 20}, 1.0F);
    CHECK(drawn.lost() == Approx(20.0 / 460));
    paint(drawn.ink, {60, 30, 3, 20}, 0.0F);
    paint(drawn.ink, {80, 80, 20, 20}, 1.0F); // cut by the crop
    CHECK(drawn.lost() == 0);
    paint<std::uint8_t>(drawn.mask, {85, 85, 2, 2}, 1); // unless the mask says that it is the character's
    CHECK(drawn.lost() == Approx(0.5));
    CHECK(lost_ink(Grid<float>(10, 10), Mask(10, 10), LabelMap(10, 10)) == 0);
}

TEST_CASE("What the silhouette leaves out of a mask is measured beyond the reach of the texture",
          "[warnings]") {
    Drawn drawn;
    CHECK(lost_mask(drawn.mask, drawn.labels) == 0);
    fill(drawn.labels, 58, 20, 60, 60, Label::background); // within reach
    CHECK(lost_mask(drawn.mask, drawn.labels) == 0);
    fill(drawn.labels, 48, 20, 60, 60, Label::background);
    // The texture reaches columns 48 and 49; ten of forty are beyond.
    CHECK(lost_mask(drawn.mask, drawn.labels) == Approx(0.25));
    CHECK(is_marked(WarningKind::lost_mask, lost_mask(drawn.mask, drawn.labels)));
    CHECK(lost_mask(Mask(10, 10), LabelMap(10, 10)) == 0);
}
