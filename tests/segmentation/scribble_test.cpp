// SPDX-License-Identifier: MIT
// When a drawing counts as a scribble, one fact at a time.
#include <catch2/catch.hpp>

#include "pantin/segmentation.hpp"

using namespace pantin;

namespace {

// Long strokes, one part, none of the types, and a network that is sure of it.
Segmentation scribble(Label label = Label::body) {
    Segmentation seen;
    seen.router = {{"ground", 1.0}};
    seen.confidence = 0.97;
    seen.stroke_ratio = 1.6;
    seen.type = {0.02, 0.02, 0.01, 0.95};
    seen.labels = LabelMap(20, 20, static_cast<std::uint8_t>(label));
    return seen;
}

Segmentation with_limbs(Segmentation seen) {
    for (int x = 0; x < 20; ++x)
        for (int y = 15; y < 20; ++y) seen.labels(x, y) = static_cast<std::uint8_t>(Label::limb);
    return seen;
}

} // namespace

TEST_CASE("long strokes, one part and no type are a scribble; a head alone, a fish and a bird are none") {
    CHECK(is_scribble(scribble(), {}));
    CHECK_FALSE(is_scribble(scribble(Label::head), {}));
    CHECK_FALSE(is_scribble(with_limbs(scribble()), {}));
    Segmentation outline = scribble();
    outline.stroke_ratio = 1;
    CHECK_FALSE(is_scribble(outline, {}));
    Segmentation bird = scribble();
    bird.type = {0.01, 0.03, 0.9, 0.06};
    bird.confidence = 0.8; // many feathers
    CHECK_FALSE(is_scribble(bird, {}));
}

TEST_CASE(
    "where the network is sure of no part it is a scribble with several, too; without a type head always") {
    Segmentation seen = with_limbs(scribble());
    seen.confidence = 0.8;
    CHECK(is_scribble(seen, {}));
    seen.type.reset();
    CHECK(is_scribble(seen, {}));
    seen.confidence = 0.97;
    CHECK_FALSE(is_scribble(seen, {}));
    seen.router.clear(); // labels that were given
    seen.confidence = 0;
    CHECK_FALSE(is_scribble(seen, {}));
}
