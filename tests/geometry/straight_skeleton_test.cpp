// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "core/math.hpp"
#include "core/random.hpp"
#include "pantin/error.hpp"
#include "pantin/straight_skeleton.hpp"

using namespace pantin;

namespace {

using Loop = std::vector<Point2d>;

double diagonal_of(const std::vector<Point2d>& points) {
    Point2d low = points[0], high = low;
    for (const Point2d& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return distance(low, high);
}

double turn(Point2d a, Point2d b, Point2d c) { return cross(b - a, c - a); }

bool cross_each_other(Point2d a, Point2d b, Point2d c, Point2d d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

// The boundary of an edge's face from its end back to its beginning, as node numbers, counter-clockwise.
std::vector<int> way_back(const StraightSkeleton& s, int edge) {
    std::vector<int> way = {s.next[edge]};
    while (way.back() != edge && way.size() <= s.nodes.size()) {
        int to = -1;
        for (const auto& arc : s.arcs) {
            if (arc.left == edge && arc.from == way.back()) to = arc.to;
            if (arc.right == edge && arc.to == way.back()) to = arc.from;
        }
        if (to < 0) break;
        way.push_back(to);
    }
    return way;
}

void check_faces(const StraightSkeleton& s, double diagonal) {
    double sum = 0, polygon = 0;
    for (int e = 0; e < std::ssize(s.corners); ++e) {
        const Point2d from = s.corners[e], to = s.corners[s.next[e]],
                      direction = (1 / distance(from, to)) * (to - from);
        const std::vector<int> way = way_back(s, e);
        REQUIRE(way.back() == e);
        double twice = cross(from, to);
        int phase =
            0; // monotone: on beyond the edge's end (a reflex corner), back, and on again to its beginning
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            const Point2d a = s.nodes[way[i]].place, b = s.nodes[way[i + 1]].place;
            twice += cross(a, b);
            const double forward = dot(b - a, direction);
            if (std::abs(forward) > 1e-9 * diagonal && (forward < 0) != (phase == 1)) ++phase;
        }
        CHECK(phase <= 2);
        CHECK(twice > 0);
        sum += twice;
        polygon += cross(from, to);
    }
    CHECK(sum == Approx(polygon).epsilon(1e-9));
}

int roots(const StraightSkeleton& s) {
    std::vector<int> parent(s.nodes.size());
    for (int i = 0; i < std::ssize(parent); ++i) parent[i] = i;
    const auto root = [&](int i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    int count = static_cast<int>(parent.size());
    for (const auto& arc : s.arcs) {
        const int a = root(arc.from), b = root(arc.to);
        count -= a != b;
        parent[a] = b;
    }
    return count;
}

void check_planar(const StraightSkeleton& s, double diagonal) {
    const auto place = [&](int node) { return s.nodes[node].place; };
    for (std::size_t i = 0; i < s.arcs.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Point2d a = place(s.arcs[i].from), b = place(s.arcs[i].to), c = place(s.arcs[k].from),
                          d = place(s.arcs[k].to);
            const double nearest = std::min({distance(a, c), distance(a, d), distance(b, c), distance(b, d)});
            if (nearest > 1e-9 * diagonal && cross_each_other(a, b, c, d)) FAIL("arcs cross");
        }
}

// Everything that holds for the straight skeleton of any polygon with this many holes.
void check_all(const StraightSkeleton& s, int holes) {
    const double diagonal = diagonal_of(s.corners);
    for (const auto& arc : s.arcs)
        for (const int edge : {arc.left, arc.right})
            for (const int node : {arc.from, arc.to}) {
                const Point2d from = s.corners[edge], along = s.corners[s.next[edge]] - from;
                const double height = cross(along, s.nodes[node].place - from) / length(along);
                CHECK(std::abs(height - s.nodes[node].time) < 1e-9 * diagonal);
            }
    for (const auto& arc : s.arcs) CHECK(s.nodes[arc.from].time <= s.nodes[arc.to].time + 1e-9 * diagonal);
    CHECK(roots(s) == 1);
    CHECK(std::ssize(s.arcs) == std::ssize(s.nodes) - 1 + holes); // a tree, and a cycle around each hole
    check_faces(s, diagonal);
    if (s.corners.size() <= 200) check_planar(s, diagonal);
}

bool has_node(const StraightSkeleton& s, Point2d place, double time) {
    return std::any_of(s.nodes.begin(), s.nodes.end(), [&](const auto& n) {
        return distance(n.place, place) < 1e-12 && std::abs(n.time - time) < 1e-12;
    });
}

Loop regular(int n, double inner = 1) {
    Loop loop;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * math::pi * i / n, r = i % 2 ? inner : 1;
        loop.push_back({r * math::cos(angle), r * math::sin(angle)});
    }
    return loop;
}

Loop star_shaped(Random& random, int n) {
    std::vector<double> angles(n);
    for (double& a : angles) a = random.uniform(0, 2 * math::pi);
    std::sort(angles.begin(), angles.end());
    Loop loop;
    for (const double a : angles) {
        const double r = random.uniform(0.3, 1);
        loop.push_back({r * math::cos(a), r * math::sin(a)});
    }
    return loop;
}

// Random points in an order without crossings (2-opt): as tangled as simple polygons get.
Loop tangled(Random& random, int n) {
    Loop loop(n);
    for (Point2d& p : loop) p = {random.uniform(), random.uniform()};
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < n; ++i)
            for (int j = i + 2; j < n; ++j) {
                if (i == 0 && j == n - 1) continue;
                if (!cross_each_other(loop[i], loop[i + 1], loop[j], loop[(j + 1) % n])) continue;
                std::reverse(loop.begin() + i + 1, loop.begin() + j + 1);
                changed = true;
            }
    }
    return loop;
}

// A slab with cuts of random depth into it, all of them facing one long edge.
Loop slits(Random& random, int cuts) {
    Loop loop = {{0, -1}, {2.0 * cuts + 1, -1}};
    for (int i = cuts; i >= 0; --i) {
        const double height = random.uniform(1, 5);
        loop.push_back({2.0 * i + 1, height});
        loop.push_back({2.0 * i, height});
        if (i > 0) loop.push_back({2.0 * i - 0.5, random.uniform(-0.7, 0.5)});
    }
    return loop;
}

// A square with a grid of square holes of three sizes: many events at a time.
std::vector<Loop> sieve(Random& random, int side) {
    const double s = side;
    std::vector<Loop> loops = {{{0, 0}, {s, 0}, {s, s}, {0, s}}};
    for (int i = 0; i < side * side; ++i) {
        const double x = i % side + 0.5, y = i / side + 0.5, r = 0.125 * random.integer(1, 3);
        loops.push_back({{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}});
    }
    return loops;
}

// Of all bits of the nodes and arcs (FNV-1a).
std::uint64_t fingerprint(const StraightSkeleton& s) {
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](std::uint64_t bits) { hash = (hash ^ bits) * 1099511628211u; };
    for (const auto& node : s.nodes)
        for (const double value : {node.place.x, node.place.y, node.time})
            add(std::bit_cast<std::uint64_t>(value));
    for (const auto& arc : s.arcs)
        for (const int value : {arc.from, arc.to, arc.left, arc.right})
            add(static_cast<std::uint64_t>(value));
    return hash;
}

std::string failure(const std::vector<Loop>& loops) {
    try {
        straight_skeleton(loops);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

} // namespace

TEST_CASE("straight skeletons with known nodes: rectangle, L, T, comb, regular polygons, stars") {
    const StraightSkeleton rectangle = straight_skeleton({{{0, 0}, {5, 0}, {5, 2}, {0, 2}}});
    check_all(rectangle, 0);
    CHECK(rectangle.nodes.size() == 6);
    CHECK(has_node(rectangle, {1, 1}, 1));
    CHECK(has_node(rectangle, {4, 1}, 1));

    const StraightSkeleton l = straight_skeleton({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 6}, {0, 6}}});
    check_all(l, 0);
    for (const Point2d p : {Point2d{3, 1}, {1, 1}, {1, 5}}) CHECK(has_node(l, p, 1));

    const StraightSkeleton t =
        straight_skeleton({{{0, 4}, {0, 6}, {9, 6}, {9, 4}, {5.5, 4}, {5.5, 0}, {3.5, 0}, {3.5, 4}}});
    check_all(t, 0);
    for (const Point2d p : {Point2d{1, 5}, {8, 5}, {4.5, 1}}) CHECK(has_node(t, p, 1));

    Loop comb = {{0, -1}, {11, -1}};
    for (int i = 5; i >= 0; --i) {
        comb.push_back({2.0 * i + 1, 3});
        comb.push_back({2.0 * i, 3});
        if (i == 0) break;
        comb.push_back({2.0 * i, 0});
        comb.push_back({2.0 * i - 1, 0});
    }
    const StraightSkeleton teeth = straight_skeleton({comb});
    check_all(teeth, 0);
    for (int i = 0; i < 6; ++i) CHECK(has_node(teeth, {2.0 * i + 0.5, 2.5}, 0.5));

    for (const int n : {3, 4, 5, 6, 7, 12, 64}) {
        const StraightSkeleton s = straight_skeleton({regular(n)});
        CAPTURE(n);
        check_all(s, 0);
        for (std::size_t i = n; i < s.nodes.size(); ++i) CHECK(length(s.nodes[i].place) < 1e-12);
    }
    for (const int n : {6, 10, 16, 50}) {
        CAPTURE(n);
        check_all(straight_skeleton({regular(n, 0.4)}), 0);
    }
}

TEST_CASE("straight skeletons go around holes") {
    const Loop outer = {{0, 0}, {6, 0}, {6, 6}, {0, 6}};
    const StraightSkeleton s = straight_skeleton({outer, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}});
    check_all(s, 1);
    for (const Point2d p : {Point2d{1, 1}, {5, 1}, {5, 5}, {1, 5}}) CHECK(has_node(s, p, 1));
    check_all(straight_skeleton({{{0, 0}, {7, 0}, {6, 6}, {0, 6}},
                                 {{2, 2}, {3, 2.2}, {3, 4}, {2, 3.5}},
                                 {{4, 1}, {5, 1.3}, {4.5, 3}}}),
              2);
}

TEST_CASE("straight skeletons of 500 random simple polygons of 10 to 1000 corners are what they must be") {
    Random random(31);
    for (int round = 0; round < 380; ++round) {
        const int n = round % 20 == 0 ? random.integer(200, 1000) : random.integer(10, 100);
        CAPTURE(round, n);
        check_all(straight_skeleton({star_shaped(random, n)}), 0);
    }
    for (int round = 0; round < 120; ++round) {
        CAPTURE(round);
        check_all(straight_skeleton({tangled(random, 10 + round)}), 0);
    }
}

TEST_CASE("straight skeletons on grids, where many events coincide") {
    Random random(32);
    for (int round = 0; round < 60; ++round) {
        Loop skyline = {{0, 0}, {24, 0}}; // towers of whole heights: parallel, collinear and opposite edges
        for (int x = 23; x >= 0; --x) {
            const double height = random.integer(1, 5);
            skyline.push_back({x + 1.0, height});
            skyline.push_back({static_cast<double>(x), height});
        }
        CAPTURE(round);
        const StraightSkeleton s = straight_skeleton({skyline});
        CHECK(roots(s) == 1);
        CHECK(std::ssize(s.arcs) == std::ssize(s.nodes) - 1);
        check_faces(s, diagonal_of(s.corners));
    }
}

TEST_CASE("straight skeletons of large polygons have the bits that they had when every corner examined "
          "every edge") {
    Random random(35);
    const struct {
        std::vector<Loop> loops;
        std::uint64_t expected;
    } cases[] = {
        {{star_shaped(random, 3000)}, 0x0ad8a7ad4011d1dcu}, {{tangled(random, 300)}, 0xf4cb2ef20c69a906u},
        {{slits(random, 1000)}, 0x0be421ebfb2e8c25u},       {{regular(400, 0.6)}, 0x955ebeba56a1f651u},
        {sieve(random, 25), 0x6bfa9e7867254b45u},
    };
    for (const auto& c : cases) {
        const StraightSkeleton s = straight_skeleton(c.loops);
        CAPTURE(s.corners.size());
        CHECK(roots(s) == 1);
        CHECK(fingerprint(s) == c.expected);
    }
}

TEST_CASE("straight skeletons do not depend on orientation, doubles and points on straight lines") {
    const Loop loop = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 6}, {0, 6}};
    Loop other = {{0, 0}, {1, 0}, {1, 0}, {4, 0}, {4, 2}, {3, 2}, {2, 2}, {2, 6}, {0, 6}, {0, 3}};
    std::reverse(other.begin(), other.end());
    const StraightSkeleton a = straight_skeleton({loop}), b = straight_skeleton({other});
    REQUIRE(a.nodes.size() == b.nodes.size());
    for (const auto& node : a.nodes) CHECK(has_node(b, node.place, node.time));
}

TEST_CASE("straight skeletons refuse what is no polygon, and end on what crosses itself") {
    CHECK(failure({}) == "straight skeleton: there is no corner");
    CHECK(failure({{{0, 0}, {1, 1}}}) == "straight skeleton: a loop has fewer than three corners");
    CHECK(failure({{{0, 0}, {1, 1}, {2, 2}, {1, 1}}}) ==
          "straight skeleton: a loop has fewer than three corners");
    CHECK(failure({{{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}, {2, 0}}}) ==
          "straight skeleton: a coordinate is not a number");
    Random random(33);
    for (int round = 0; round < 50; ++round) {
        Loop loop(20);
        for (Point2d& p : loop) p = {random.uniform(), random.uniform()};
        CHECK(straight_skeleton({loop}).nodes.size() >= 20);
    }
}
