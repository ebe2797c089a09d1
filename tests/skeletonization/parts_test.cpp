// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>

#include "shapes.hpp"
#include "skeletonization/parts.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

void paint(LabelMap& labels, Point2d a, Point2d b, double radius, Label label) {
    Mask mask(labels.width(), labels.height());
    fill_capsule(mask, a, b, radius);
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask.data()[i]) labels.data()[i] = static_cast<std::uint8_t>(label);
}

// A thick trunk with a head, a short stub of a tail that raises no ridge, and a wing folded upon it.
LabelMap stubby() {
    LabelMap labels(321, 200);
    paint(labels, {255, 100}, {280, 60}, 18, Label::head);
    paint(labels, {60, 93}, {22, 90}, 6, Label::tail);
    paint(labels, {80, 100}, {240, 100}, 50, Label::body);
    paint(labels, {170, 100}, {190, 100}, 10, Label::wing);
    return labels;
}

// A trunk on two pairs of legs; the feet of the first pair touch.
LabelMap touching_feet() {
    LabelMap labels(321, 261);
    for (const double x : {80.0, 240.0}) {
        paint(labels, {x - 20, 60}, {x - 20, 220}, 7, Label::limb);
        paint(labels, {x + 20, 60}, {x + 20, 220}, 7, Label::limb);
    }
    paint(labels, {60, 220}, {100, 220}, 6, Label::limb);
    paint(labels, {60, 60}, {260, 60}, 25, Label::body);
    paint(labels, {290, 40}, {290, 40}, 20, Label::head);
    return labels;
}

int ends_with(const SkeletonGraph& graph, Label label) {
    return static_cast<int>(
        std::count_if(graph.vertices.begin(), graph.vertices.end(),
                      [&](const SkeletonVertex& v) { return v.end && v.label == label; }));
}

} // namespace

TEST_CASE("a short tail that no ridge enters gets an end, a patch upon the body does not") {
    SkeletonizationOptions options;
    options.recover_parts_share = 0;
    CHECK(ends_with(skeletonize(stubby(), options).graph, Label::tail) == 0);
    options.recover_parts_share = 0.005;
    const Skeletonization s = skeletonize(stubby(), options);
    CHECK(ends_with(s.graph, Label::tail) == 1);
    CHECK(ends_with(s.graph, Label::wing) == 0);
    CHECK(ends_with(s.graph, Label::head) == 1);
    CHECK(topology(s.skeleton) == CountedTopology{1, 0});
    options.recover_parts_share = 0.5; // smaller than half of the shape: noise
    CHECK(ends_with(skeletonize(stubby(), options).graph, Label::tail) == 0);
}

TEST_CASE("parts that ridges run through get no anchor") {
    const LabelMap labels = touching_feet();
    SkeletonizationOptions options;
    const Skeletonization s = skeletonize(labels, options);
    CHECK(anchor_missing_parts(s.voronoi_raster, s.mask, labels, 0.005) == s.voronoi_raster);
    CHECK(count(anchor_missing_parts(Mask(321, 261), s.mask, labels, 0.005)) ==
          4); // head, joined legs, two legs
}

TEST_CASE("legs whose feet touch are cut apart at the feet") {
    SkeletonizationOptions options;
    options.cut_cycles = false;
    const Skeletonization joined = skeletonize(touching_feet(), options);
    CHECK(cycles(joined.graph) == 1);
    CHECK(ends_with(joined.graph, Label::limb) == 2);
    options.cut_cycles = true;
    const Skeletonization cut = skeletonize(touching_feet(), options);
    CHECK(cycles(cut.graph) == 0);
    CHECK(graph_components(cut.graph) == 1);
    REQUIRE(ends_with(cut.graph, Label::limb) == 4);
    for (const SkeletonVertex& v : cut.graph.vertices)
        if (v.label == Label::limb) CHECK(v.y > 200);
}

TEST_CASE("cycles of one part alone are left, and cutting never parts a skeleton") {
    Mask ring(120, 120);
    fill_disc(ring, 60, 60, 50);
    fill_disc(ring, 60, 60, 35, 0);
    const Skeletonization body = skeletonize(all_of(ring, Label::body));
    CHECK(cycles(body.graph) == 1);
    CHECK(cycles(skeletonize(all_of(ring, Label::tail)).graph) == 1); // no body to be far from

    Random random(41);
    for (int round = 0; round < 60; ++round) {
        const Mask mask = random_blob(random, random.integer(24, 80));
        const Mask skeleton = remove_redundant_pixels(zhang_suen(mask));
        if (count(skeleton) == 0) continue;
        LabelMap labels(mask.width(), mask.height());
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask.data()[i]) labels.data()[i] = random.chance(0.3) ? 2 : 3;
        const Mask cut = cut_cycles(skeleton, labels, 3);
        REQUIRE(topology(cut).components == 1);
        REQUIRE(topology(cut).holes <= topology(skeleton).holes);
        for (std::size_t i = 0; i < mask.size(); ++i) REQUIRE(cut.data()[i] <= skeleton.data()[i]);
    }
}
