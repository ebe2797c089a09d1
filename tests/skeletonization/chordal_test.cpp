// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shapes.hpp"
#include "skeletonization/chordal_ridges.hpp"
#include "skeletonization/outline.hpp"
#include "skeletonization/topology.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

void fill_box(Mask& mask, int left, int top, int right, int bottom) {
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) mask(x, y) = 1;
}

SkeletonizationOptions chordal() {
    SkeletonizationOptions options;
    options.method = SkeletonMethod::chordal;
    return options;
}

int junctions(const SkeletonGraph& graph) {
    return static_cast<int>(
        std::count_if(graph.vertices.begin(), graph.vertices.end(), [](const auto& v) { return !v.end; }));
}

struct Edge {
    Point2i a, b;
};

std::vector<Edge> edges_of(const std::vector<std::vector<Point2i>>& loops) {
    std::vector<Edge> edges;
    for (const std::vector<Point2i>& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
    return edges;
}

// Edges that follow each other share a corner and nothing else.
bool apart(const Edge& e, const Edge& f) {
    if (e.b == f.a || f.b == e.a) {
        const Point2i free_e = e.b == f.a ? e.a : e.b, free_f = e.b == f.a ? f.b : f.a;
        const Point2i shared = e.b == f.a ? e.b : e.a;
        return orientation(free_e, shared, free_f) != 0 ||
               dot(to_double(free_e) - to_double(shared), to_double(free_f) - to_double(shared)) < 0;
    }
    return orientation(e.a, e.b, f.a) * orientation(e.a, e.b, f.b) > 0 ||
           orientation(f.a, f.b, e.a) * orientation(f.a, f.b, e.b) > 0 ||
           std::max(e.a.x, e.b.x) < std::min(f.a.x, f.b.x) ||
           std::max(f.a.x, f.b.x) < std::min(e.a.x, e.b.x) ||
           std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) || std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y);
}

bool simple(const std::vector<std::vector<Point2i>>& loops) {
    const std::vector<Edge> edges = edges_of(loops);
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (!apart(edges[i], edges[k])) return false;
    return true;
}

} // namespace

TEST_CASE("the smooth outline of any mask is simple loops that keep apart") {
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        Mask mask(20, 20);
        const double density = random.uniform(0.2, 0.9);
        for (std::uint8_t& pixel : mask) pixel = random.chance(density);
        const auto loops = smooth_outline(mask);
        REQUIRE(loops.size() == follow_borders(mask).size());
        REQUIRE(simple(loops));
    }
    CHECK(smooth_outline(Mask(5, 5)).empty());
    CHECK(smooth_outline(Mask(1, 1, 1)).size() == 1);
}

TEST_CASE("the smooth outline of a slanted bar has no staircase") {
    Mask mask(200, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 10; x < 190; ++x) mask(x, y) = 5 * std::abs(y - 50) <= 100 - std::abs(x - 100);
    double outline = 0;
    for (const Edge& edge : edges_of(smooth_outline(mask)))
        outline += distance(to_double(edge.a), to_double(edge.b)) / outline_units;
    // A rhombus with blunt ends, half a pixel larger all around. Its staircase would be a sixteenth longer.
    CHECK(outline == Approx(4 * std::sqrt(90.0 * 90 + 18 * 18) + 2 * 5 + 3).epsilon(0.01));
}

TEST_CASE("the chordal axis of a rectangle is its middle line up to half its width before the ends") {
    for (const int height : {3, 8, 21, 40}) {
        Mask mask(220, 60);
        fill_box(mask, 10, 5, 209, 4 + height);
        const Mask ridges = chordal_ridges(mask, 20);
        const double middle = 5 + (height - 1) / 2.0;
        int first = 220, last = 0;
        CAPTURE(height);
        for (int x = 0; x < 220; ++x)
            for (int y = 0; y < 60; ++y) {
                if (!ridges(x, y)) continue;
                REQUIRE(std::abs(y - middle) <= 0.5);
                first = std::min(first, x);
                last = std::max(last, x);
            }
        CHECK(first == Approx(9.5 + height / 2.0).margin(3));
        CHECK(last == Approx(209.5 - height / 2.0).margin(3));
        CHECK(topology(fill_spurious_cycles(ridges, mask)) == CountedTopology{1, 0});
    }
}

TEST_CASE("the chordal axes of T, cross and comb have their junctions and ends") {
    Mask t(200, 160), cross(200, 160), comb(200, 160);
    fill_box(t, 10, 20, 189, 43);
    fill_box(t, 88, 20, 111, 149);
    fill_box(cross, 10, 70, 189, 89);
    fill_box(cross, 90, 5, 109, 154);
    fill_box(comb, 10, 20, 189, 39);
    for (int tooth = 0; tooth < 4; ++tooth) fill_box(comb, 10 + 56 * tooth, 20, 21 + 56 * tooth, 140);
    const auto numbers = [](const Mask& mask) {
        const SkeletonGraph graph = skeletonize(all_of(mask, Label::limb), chordal()).graph;
        return std::pair{junctions(graph), static_cast<int>(graph.vertices.size()) - junctions(graph)};
    };
    CHECK(numbers(t) == std::pair{1, 3});
    CHECK(numbers(cross) == std::pair{1, 4});
    CHECK(numbers(comb) == std::pair{2, 4}); // at the outer teeth the axis just turns
}

TEST_CASE("the chordal axis of a ring is a cycle, that of a disc is nothing") {
    Mask ring(120, 120);
    fill_disc(ring, 60, 60, 50);
    CHECK(count(chordal_ridges(ring, 60)) == 0);
    fill_disc(ring, 60, 60, 30, 0);
    const Mask ridges = chordal_ridges(ring, 20);
    CHECK(topology(ridges) == CountedTopology{1, 1});
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x)
            if (ridges(x, y)) CHECK(length(Point2d{x - 60.0, y - 60.0}) == Approx(40.5).margin(1.5));
    CHECK(cycles(skeletonize(all_of(ring, Label::limb), chordal()).graph) == 1);
}

TEST_CASE(
    "chordal: hair and whiskers are no branches, thin limbs reach their tips, a fork ends where it forks") {
    Mask mask(321, 120);
    fill_capsule(mask, {60, 60}, {200, 60}, 20);
    for (const double x : {80, 120, 160}) fill_capsule(mask, {x, 40}, {x + 4, 30}, 1); // hair
    fill_capsule(mask, {200, 60}, {290, 60}, 3);                                       // an arm
    fill_capsule(mask, {290, 60}, {298, 52}, 2);                                       // and two fingers
    fill_capsule(mask, {290, 60}, {298, 68}, 2);
    SkeletonizationOptions options = chordal();
    options.recover_parts_share = 0;
    const SkeletonGraph graph = skeletonize(all_of(mask, Label::limb), options).graph;
    REQUIRE(graph.vertices.size() == 2);
    const SkeletonVertex& tip = graph.vertices[graph.vertices[0].x > graph.vertices[1].x ? 0 : 1];
    CHECK(tip.x == Approx(290).margin(5));
    CHECK(tip.y == Approx(60).margin(2));
    options.residual_threshold = 7;
    CHECK(skeletonize(all_of(mask, Label::limb), options).graph.vertices.size() > 2);
}

TEST_CASE("chordal axes of random blobs lie inside, and are homotopic to them from the start") {
    Random random(11);
    int empty = 0;
    for (int round = 0; round < 150; ++round) {
        const Mask mask = random_blob(random, 100);
        CAPTURE(round);
        const Mask ridges = chordal_ridges(mask, 30.0 * 100 / 321);
        for (std::size_t i = 0; i < mask.size(); ++i) REQUIRE(ridges.data()[i] <= mask.data()[i]);
        if (count(ridges) == 0)
            ++empty;
        else
            CHECK(topology(fill_spurious_cycles(ridges, mask)) == topology(mask));
        CHECK(chordal_ridges(mask, 30.0 * 100 / 321) == ridges);
    }
    CHECK(empty < 30);
}

TEST_CASE("chordal skeletons of random blobs are homotopic to them") {
    Random random(12);
    SkeletonizationOptions options = chordal();
    options.fill_holes_share = 0;
    options.cut_cycles = false;
    for (int round = 0; round < 150; ++round) {
        const Mask mask = random_blob(random, 90);
        CAPTURE(round);
        try {
            const Skeletonization s = skeletonize(all_of(mask, Label::limb), options);
            CHECK(topology(s.voronoi_raster) == topology(mask));
            CHECK(topology(s.skeleton) == topology(mask));
            CHECK(graph_components(s.graph) == 1);
            for (std::size_t i = 0; i < mask.size(); ++i) REQUIRE(s.skeleton.data()[i] <= mask.data()[i]);
        } catch (const CharacterRejected&) {
            continue; // a dot
        }
    }
}

TEST_CASE("chordal axes of masks of noise, of lines and of dots") {
    Random random(13);
    for (int round = 0; round < 60; ++round) {
        Mask mask(40, 40);
        const double density = random.uniform(0.3, 0.95);
        for (std::uint8_t& pixel : mask) pixel = random.chance(density);
        mask = largest_component(mask);
        const Mask ridges = chordal_ridges(mask, 0);
        CHECK(topology(restore_topology(ridges, mask)) == topology(mask));
    }
    const std::vector<std::vector<std::string>> pictures = {
        {"#"}, {"##"}, {"########"}, {"#..", ".#.", "..#"}, {"#.#", ".#.", "#.#"}};
    for (const auto& rows : pictures)
        CHECK(topology(restore_topology(chordal_ridges(picture(rows), 1), picture(rows))) ==
              CountedTopology{1, 0});
}
