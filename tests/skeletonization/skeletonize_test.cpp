// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pantin/error.hpp"
#include "shapes.hpp"
#include "skeletonization/topology.hpp"
#include "skeletonization/voronoi_skeleton.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

// A figure with a head, a trunk, two arms, two legs.
LabelMap stick_figure(int dx = 0, int dy = 0) {
    const auto part = [&](Point2d a, Point2d b, double radius) {
        Mask mask(161 + dx, 161 + dy);
        fill_capsule(mask, {a.x + dx, a.y + dy}, {b.x + dx, b.y + dy}, radius);
        return mask;
    };
    LabelMap labels(161 + dx, 161 + dy);
    const auto paint = [&](const Mask& mask, Label label) {
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask.data()[i]) labels.data()[i] = static_cast<std::uint8_t>(label);
    };
    paint(part({80, 62}, {30, 80}, 5), Label::limb);
    paint(part({80, 62}, {130, 84}, 5), Label::limb);
    paint(part({80, 100}, {50, 150}, 6), Label::limb);
    paint(part({80, 100}, {112, 150}, 6), Label::limb);
    paint(part({80, 52}, {80, 102}, 10), Label::body);
    paint(part({80, 28}, {80, 28}, 17), Label::head);
    return labels;
}

int ends_with(const SkeletonGraph& graph, Label label) {
    return static_cast<int>(
        std::count_if(graph.vertices.begin(), graph.vertices.end(),
                      [&](const SkeletonVertex& v) { return v.end && v.label == label; }));
}

} // namespace

TEST_CASE("a figure has a head, four limb ends and a trunk") {
    for (const Residual residual : {Residual::arc, Residual::chord}) {
        SkeletonizationOptions options;
        options.residual = residual;
        const Skeletonization s = skeletonize(stick_figure(), options);
        CHECK(ends_with(s.graph, Label::head) == 1);
        CHECK(ends_with(s.graph, Label::limb) == 4);
        CHECK(ends_with(s.graph, Label::body) == 0);
        CHECK(cycles(s.graph) == 0);
        CHECK(s.contour.size() == 1);
        CHECK(s.voronoi.size() == s.residuals.size());
        CHECK(s.graph.width == 161);
    }
}

TEST_CASE("the skeleton moves with the figure") {
    // The image grows with the shift, so the scale is given back to the options.
    SkeletonizationOptions options;
    const Skeletonization a = skeletonize(stick_figure(), options);
    options.residual_threshold *= 161.0 / 198.0;
    options.merge_distance *= 161.0 / 198.0;
    const Skeletonization b = skeletonize(stick_figure(37, 12), options);
    REQUIRE(a.graph.vertices.size() == b.graph.vertices.size());
    for (std::size_t i = 0; i < a.graph.vertices.size(); ++i) {
        CHECK(b.graph.vertices[i].x == a.graph.vertices[i].x + 37);
        CHECK(b.graph.vertices[i].y == a.graph.vertices[i].y + 12);
    }
    REQUIRE(count(a.skeleton) == count(b.skeleton));
    for (int y = 0; y < a.skeleton.height(); ++y)
        for (int x = 0; x < a.skeleton.width(); ++x) REQUIRE(a.skeleton(x, y) == b.skeleton(x + 37, y + 12));
}

TEST_CASE("skeletons lie in their shape, are connected and have its holes") {
    Random random(31);
    int done = 0;
    for (int round = 0; round < 120; ++round) {
        const Mask mask = random_blob(random, random.integer(24, 90));
        SkeletonizationOptions options;
        options.residual = random.chance(0.5) ? Residual::arc : Residual::chord;
        options.fill_holes_share = random.chance(0.5) ? 0 : 0.05;
        options.cut_cycles = false;
        Skeletonization s;
        try {
            s = skeletonize(all_of(mask, Label::limb), options);
        } catch (const CharacterRejected&) {
            continue;
        }
        ++done;
        REQUIRE(topology(s.skeleton) == topology(s.mask));
        REQUIRE(topology(s.voronoi_raster) == topology(s.mask));
        for (std::size_t i = 0; i < mask.size(); ++i) REQUIRE(s.skeleton.data()[i] <= s.mask.data()[i]);
        REQUIRE(graph_components(s.raw) == 1);
        REQUIRE(cycles(s.raw) <= topology(s.mask).holes); // a hole of a few pixels may vanish in a junction
    }
    CHECK(done > 80);
}

TEST_CASE("residuals: shorter way round, smallest over repeated visits, infinite between borders") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // A bar of 6×3: from the middle of the upper to the middle of the lower side it is 7 either way.
    const BorderSites bar = border_sites(follow_borders(Mask(6, 3, 1)), 6, 3);
    const auto index = [](const BorderSites& sites, Point2i p) {
        return static_cast<int>(std::find(sites.points.begin(), sites.points.end(), p) -
                                sites.points.begin());
    };
    REQUIRE(bar.points.size() == 14);
    CHECK(residual_between(bar, index(bar, {2, 0}), index(bar, {2, 2}), Residual::arc) == 6);
    CHECK(residual_between(bar, index(bar, {2, 0}), index(bar, {2, 2}), Residual::chord) == 4);
    CHECK(residual_between(bar, index(bar, {3, 0}), index(bar, {2, 2}), Residual::arc) == 7);
    CHECK(residual_between(bar, index(bar, {0, 0}), index(bar, {1, 0}), Residual::chord) == 0);

    // Two squares joined by a neck of one pixel's width, which is visited on both sides.
    const Mask dumbbell = picture({"###..###", "########", "###..###"});
    const BorderSites neck = border_sites(follow_borders(dumbbell), 8, 3);
    const int middle = index(neck, {3, 1});
    REQUIRE(neck.visits[middle].size() == 2);
    CHECK(neck_residual(neck.visits[middle], neck.lengths) == Approx(6 + 2 * std::sqrt(2.0)));
    CHECK(neck_residual(neck.visits[index(neck, {0, 0})], neck.lengths) == -1);
    CHECK(border_arc(neck, middle, index(neck, {4, 1})) == Approx(1));

    const Mask ring = picture({"#####", "#...#", "#...#", "#...#", "#####"});
    const BorderSites two = border_sites(follow_borders(ring), 5, 5);
    CHECK(neck_residual(two.visits[index(two, {0, 2})], two.lengths) == infinity);
    const Mask thick = picture({"#######", "#######", "##...##", "##...##", "##...##", "#######", "#######"});
    const BorderSites wall = border_sites(follow_borders(thick), 7, 7);
    CHECK(border_arc(wall, index(wall, {0, 3}), index(wall, {1, 3})) == infinity);
}

TEST_CASE("necks of one pixel hold the skeleton together") {
    Mask mask(120, 60);
    fill_disc(mask, 28, 30, 22);
    fill_disc(mask, 91, 30, 22);
    for (int x = 28; x <= 91; ++x) mask(x, 30) = 1;
    const Skeletonization s = skeletonize(all_of(mask, Label::limb));
    CHECK(topology(s.skeleton) == CountedTopology{1, 0});
    for (int x = 52; x <= 68; ++x) CHECK(s.skeleton(x, 30) == 1);
    // A plus whose arms are all one pixel wide, and a neck along a diagonal.
    Mask plus(101, 101);
    for (int i = 10; i < 91; ++i) plus(i, 50) = plus(50, i) = 1;
    const SkeletonGraph cross = skeletonize(all_of(plus, Label::limb)).graph;
    CHECK(cross.vertices.size() == 5);
    CHECK(ends_with(cross, Label::limb) == 4);
    Mask diagonal(101, 101);
    for (int i = 30; i < 71; ++i) diagonal(i, i) = 1;
    fill_disc(diagonal, 22, 22, 14);
    fill_disc(diagonal, 79, 79, 14);
    CHECK(topology(skeletonize(all_of(diagonal, Label::limb)).skeleton) == CountedTopology{1, 0});
}

TEST_CASE("a whisker of one pixel's width below the threshold is no branch") {
    Mask mask(321, 80);
    fill_capsule(mask, {30, 40}, {290, 40}, 15);
    for (int y = 18; y < 26; ++y) mask(160, y) = 1;
    const SkeletonGraph graph = skeletonize(all_of(mask, Label::limb)).graph;
    CHECK(graph.vertices.size() == 2);
}

TEST_CASE("gaps are bridged inside the mask, an empty raster gets the deepest pixel") {
    Mask mask(40, 20);
    fill_capsule(mask, {6, 10}, {33, 10}, 4);
    Mask raster(40, 20);
    raster(8, 10) = raster(9, 10) = raster(30, 10) = raster(20, 12) = 1;
    const Mask joined = restore_topology(raster, mask);
    CHECK(topology(joined).components == 1);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        CHECK(joined.data()[i] >= raster.data()[i]);
        CHECK(joined.data()[i] <= mask.data()[i]);
    }
    const Mask point = restore_topology(Mask(40, 20), mask);
    CHECK(count(point) == 1);
    const Grid<int> depth = squared_distance_transform(mask);
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (point.data()[i]) CHECK(depth.data()[i] == *std::max_element(depth.begin(), depth.end()));
}

TEST_CASE("a hole that the raster does not surround is surrounded") {
    Mask mask(30, 20, 1);
    for (int x = 12; x < 18; ++x) mask(x, 9) = mask(x, 10) = 0;
    Mask raster(30, 20);
    raster(3, 10) = 1;
    CHECK(topology(restore_topology(raster, mask)) == CountedTopology{1, 1});
    CHECK(topology(restore_topology(Mask(30, 20), mask)) == CountedTopology{1, 1});
}

TEST_CASE("pockets between ridges stay cycles when they are not filled, and gaps are bridged all the same") {
    Random random(31);
    int pockets = 0;
    for (int round = 0; round < 200; ++round) {
        const Mask mask = largest_component(random_blob(random, random.integer(16, 40)));
        Mask raster = mask;
        for (auto& pixel : raster) pixel = pixel && random.chance(0.5);
        const Mask filled = restore_topology(raster, mask), kept = restore_topology(raster, mask, false);
        const Mask simple = fill_spurious_cycles(raster, mask);
        REQUIRE(topology(kept).components == topology(filled).components);
        int differ = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
            REQUIRE(kept.data()[i] >= raster.data()[i]);
            // Exactly the pixels that the raster encloses are not there.
            REQUIRE((filled.data()[i] - kept.data()[i]) == (simple.data()[i] - raster.data()[i]));
            differ += filled.data()[i] != kept.data()[i];
        }
        if (differ > 0) REQUIRE(topology(kept).holes > topology(filled).holes);
        pockets += differ > 0;
    }
    CHECK(pockets > 100);
    // The whole step: two ridges side by side round one pixel are a cycle of the graph.
    const Mask ring = picture({".....", ".###.", ".#.#.", ".###.", "....."});
    CHECK(topology(restore_topology(ring, Mask(5, 5, 1), false)) == CountedTopology{1, 1});
}

TEST_CASE("cycles of the raster are filled unless they go round a hole") {
    const Mask ring = picture({".....", ".###.", ".#.#.", ".###.", "....."});
    const Mask full(5, 5, 1);
    CHECK(count(fill_spurious_cycles(ring, full)) == 9);
    Mask holed = full;
    holed(2, 2) = 0;
    CHECK(fill_spurious_cycles(ring, holed) == ring);
    // Open to the image's border: no cycle.
    const Mask bay = picture({".#.#.", ".#.#.", ".###.", ".....", "....."});
    CHECK(fill_spurious_cycles(bay, full) == bay);
}

TEST_CASE("holes are filled up to the share that the options allow") {
    Mask mask(100, 100);
    fill_disc(mask, 50, 50, 40);
    fill_disc(mask, 50, 35, 3, 0);  // 29 pixels
    fill_disc(mask, 50, 60, 15, 0); // 709 pixels
    SkeletonizationOptions options;
    options.fill_holes_share = 0;
    CHECK(skeletonize(all_of(mask, Label::limb), options).contour.size() == 3);
    options.fill_holes_share = 0.02;
    const Skeletonization s = skeletonize(all_of(mask, Label::limb), options);
    CHECK(s.contour.size() == 2);
    CHECK(cycles(s.graph) == 1);
    // The pixels of a filled hole have the nearest part.
    for (const SkeletonVertex& v : s.graph.vertices) CHECK(v.label == Label::limb);
}

TEST_CASE("rings are loops; discs, dots and empty pictures are rejected with their reason") {
    Mask ring(120, 120);
    fill_disc(ring, 60, 60, 50);
    fill_disc(ring, 60, 60, 35, 0);
    const Skeletonization s = skeletonize(all_of(ring, Label::limb));
    CHECK(cycles(s.graph) == 1);
    CHECK(s.graph.vertices.size() == 3);

    const auto reason = [](const LabelMap& labels) -> std::string {
        try {
            skeletonize(labels);
        } catch (const CharacterRejected& rejected) {
            return rejected.step() + ": " + rejected.what();
        }
        return "accepted";
    };
    Mask disc(60, 60);
    fill_disc(disc, 30, 30, 20);
    CHECK(reason(all_of(disc, Label::head)) == "skeletonize: the skeleton is a single point");
    CHECK(reason(LabelMap(16, 16, 2)) == "skeletonize: the skeleton is a single point");
    SkeletonizationOptions all;
    all.reject_point = false;
    const SkeletonGraph point = skeletonize(all_of(disc, Label::head), all).graph;
    CHECK(point.vertices.size() == 1);
    CHECK(point.edges.empty());
    CHECK(point.vertices.front().label == Label::head);
    LabelMap dot(16, 16);
    CHECK(reason(dot) == "skeletonize: the silhouette is empty");
    dot(3, 4) = 1;
    CHECK(reason(dot) == "skeletonize: the skeleton is a single point");
    CHECK(reason(LabelMap(1, 1, 1)) == "skeletonize: the skeleton is a single point");
    LabelMap comb(700, 700); // teeth of one pixel
    for (int y = 0; y < 700; ++y)
        for (int x = 0; x < 700; ++x) comb(x, y) = y % 2 == 0 || x == 0;
    CHECK(reason(comb).starts_with("skeletonize: the silhouette's border has "));
    CHECK(reason(comb).ends_with(" points; the limit is 100000"));
    CHECK(reason(LabelMap(300, 1, 3)) == "accepted"); // a line from end to end of the image
}

TEST_CASE("only the largest component of the silhouette counts") {
    LabelMap labels = stick_figure();
    const SkeletonGraph expected = skeletonize(labels).graph;
    for (int y = 2; y < 8; ++y)
        for (int x = 2; x < 40; ++x) labels(x, y) = 4;
    CHECK(skeletonize(labels).graph == expected);
}

TEST_CASE("a round shape with a small head gets a lower threshold instead of a single point") {
    LabelMap duck(200, 200);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            if (std::hypot(x - 100, y - 110) < 70) duck(x, y) = static_cast<std::uint8_t>(Label::body);
            if (std::hypot(x - 100, y - 42) < 12) duck(x, y) = static_cast<std::uint8_t>(Label::head);
        }
    SkeletonizationOptions options;
    options.recover_parts_share = 0;
    const Skeletonization found = skeletonize(duck, options);
    REQUIRE(found.graph.edges.size() == 1);
    CHECK(found.threshold < options.residual_threshold * std::max(duck.width(), duck.height()) / 321);
    CHECK(std::any_of(found.graph.vertices.begin(), found.graph.vertices.end(),
                      [](const SkeletonVertex& v) { return v.end && v.label == Label::head; }));
    options.lower_threshold = false;
    CHECK_THROWS_AS(skeletonize(duck, options), CharacterRejected);
}

TEST_CASE(
    "straight skeleton, thinning and chordal axis give skeletons of the same kind as the Voronoi diagram") {
    LabelMap cross(161, 161);
    for (int y = 0; y < 161; ++y)
        for (int x = 0; x < 161; ++x) {
            const bool across = std::abs(y - 80) <= 10 && x >= 5 && x <= 155,
                       upright = std::abs(x - 80) <= 10 && y >= 5 && y <= 155;
            if (across || upright)
                cross(x, y) = static_cast<std::uint8_t>(
                    std::max(std::abs(x - 80), std::abs(y - 80)) > 30 ? Label::limb : Label::body);
        }
    for (const SkeletonMethod method : {SkeletonMethod::voronoi, SkeletonMethod::straight,
                                        SkeletonMethod::thinning, SkeletonMethod::chordal}) {
        SkeletonizationOptions options;
        options.method = method;
        const Skeletonization s = skeletonize(cross, options);
        CAPTURE(static_cast<int>(method));
        CHECK(s.voronoi.empty() == (method != SkeletonMethod::voronoi));
        CHECK(cycles(s.graph) == 0);
        for (std::size_t i = 0; i < s.skeleton.size(); ++i) CHECK((!s.skeleton.data()[i] || cross.data()[i]));
        int reached = 0; // arms with an end of label limb in their outer third
        for (const Point2d tip : {Point2d{5, 80}, {155, 80}, {80, 5}, {80, 155}})
            reached +=
                std::any_of(s.graph.vertices.begin(), s.graph.vertices.end(), [&](const SkeletonVertex& v) {
                    return v.end && v.label == Label::limb && distance({v.x, v.y}, tip) < 25;
                });
        CHECK(reached == 4);
    }
}
