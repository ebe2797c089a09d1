// SPDX-License-Identifier: MIT
// Sub-skeletons of outlines: BoundedDP, cylinders, refinement.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/math.hpp"
#include "core/random.hpp"
#include "pantin/error.hpp"
#include "pantin/geometry.hpp"
#include "pantin/modeling.hpp"

using namespace pantin;

namespace {

using Line = std::vector<Point2d>;

double area_of(const Line& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i], loop[(i + 1) % loop.size()]);
    return twice / 2;
}

bool inside(const Line& loop, Point2d p) {
    bool in = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2d a = loop[i], b = loop[(i + 1) % loop.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
}

bool is_simple(const Line& loop) {
    const auto turn = [](Point2d a, Point2d b, Point2d c) { return cross(b - a, c - a); };
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            if (i == 0 && k == n - 1) continue;
            const Point2d a = loop[i], b = loop[i + 1], c = loop[k], d = loop[(k + 1) % n];
            if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return false;
        }
    return true;
}

int roots(const SubSkeleton& s) {
    std::vector<int> parent(s.joints.size());
    for (int i = 0; i < std::ssize(parent); ++i) parent[i] = i;
    const auto root = [&](int i) {
        while (parent[i] != i) i = parent[i];
        return i;
    };
    for (const auto& [a, b] : s.bones) parent[root(a)] = root(b);
    int count = 0;
    for (int i = 0; i < std::ssize(parent); ++i) count += parent[i] == i;
    return count;
}

void check_skeleton(const SubSkeleton& s) {
    REQUIRE(!s.joints.empty());
    CHECK(s.bones.size() + 1 == s.joints.size());
    CHECK(roots(s) == 1);
    for (const auto& joint : s.joints) {
        CHECK(inside(s.outline.corners, joint.place));
        CHECK(joint.radius > 0);
    }
    for (const auto& [a, b] : s.bones)
        for (int k = 1; k < 8; ++k)
            CHECK(inside(s.outline.corners,
                         s.joints[a].place + k / 8.0 * (s.joints[b].place - s.joints[a].place)));
}

// A blob whose radius is a sum of a few waves: limbs and bays.
Line blob(Random& random, int lobes, double depth) {
    const double phase = random.uniform(0, 6), other = random.uniform(0, 6), small = random.uniform(0, 0.15);
    Line line;
    for (int i = 0; i < 300; ++i) {
        const double a = 2 * math::pi * i / 300;
        const double r = 1 + depth * math::sin(lobes * a + phase) + small * math::sin(2 * a + other);
        line.push_back({100 * r * math::cos(a), 100 * r * math::sin(a)});
    }
    return line;
}

Line capsule(double half, double radius) {
    Line line;
    for (int i = 0; i <= 40; ++i) {
        const double a = math::pi * (i / 40.0 - 0.5);
        line.push_back({half + radius * math::cos(a), radius * math::sin(a)});
    }
    for (int i = 0; i <= 40; ++i) {
        const double a = math::pi * (i / 40.0 + 0.5);
        line.push_back({-half + radius * math::cos(a), radius * math::sin(a)});
    }
    return line;
}

std::string failure(const Line& stroke) {
    try {
        sub_skeleton(stroke);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

} // namespace

TEST_CASE("strokes become simple polygons with their interior on the left") {
    Random random(41);
    for (int round = 0; round < 40; ++round) {
        Line stroke = blob(random, 3 + round % 5, 0.4);
        const double area = area_of(stroke);
        if (round % 2) std::reverse(stroke.begin(), stroke.end());
        const SimplePolygon polygon = simple_polygon(stroke);
        CHECK(polygon.cut == 0);
        CHECK(polygon.corners.size() < 120);
        CHECK(is_simple(polygon.corners));
        CHECK(area_of(polygon.corners) == Approx(area).epsilon(0.02));
    }
}

TEST_CASE("crossings of a stroke are cut off with the smaller loop, and counted") {
    // A square whose last side overshoots and comes back in a little loop.
    const Line stroke = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, -10}, {-10, -10}, {-10, 5}, {5, 5}};
    const SimplePolygon polygon = simple_polygon(stroke);
    CHECK(polygon.cut >= 1);
    CHECK(is_simple(polygon.corners));
    CHECK(area_of(polygon.corners) == Approx(10000).epsilon(0.03));
    Random random(42);
    for (int round = 0; round < 60; ++round) {
        Line scribble(30);
        for (Point2d& p : scribble) p = {random.uniform(), random.uniform()};
        const SimplePolygon cut = simple_polygon(scribble);
        CHECK(cut.cut > 0);
        CHECK(is_simple(cut.corners));
        check_skeleton(sub_skeleton(scribble));
    }
}

TEST_CASE("a thin strip that crosses itself keeps its length") {
    Random random(43);
    for (int round = 0; round < 60; ++round) {
        // A leg of a hundred by one, whose sides change places `round % 3 + 1` times on the way.
        const double angle = 2 * math::pi * random.uniform(), c = math::cos(angle), s = math::sin(angle);
        const int twists = 1 + round % 3;
        Line there, back;
        for (int i = 0; i <= twists + 1; ++i) {
            const double x = 100.0 * i / (twists + 1), y = i % 2 ? 0.5 : -0.5;
            there.push_back({c * x - s * y, s * x + c * y});
            back.insert(back.begin(), {c * x + s * y, s * x - c * y});
        }
        Line stroke = there;
        stroke.insert(stroke.end(), back.begin(), back.end());
        const SimplePolygon polygon = simple_polygon(stroke);
        CHECK(polygon.cut == 0);
        CHECK(polygon.uncrossed >= 1);
        CHECK(is_simple(polygon.corners));
        double far = 0;
        for (const Point2d& p : polygon.corners)
            for (const Point2d& q : polygon.corners) far = std::max(far, distance(p, q));
        CHECK(far == Approx(100).epsilon(0.02));
    }
}

TEST_CASE("strips thinner than the tolerance keep their length and some of their area") {
    Random random(44);
    for (int round = 0; round < 150; ++round) {
        const double width = 100 * random.uniform(0.0005, 0.01), angle = 2 * math::pi * random.uniform();
        const double c = math::cos(angle), s = math::sin(angle), x0 = random.uniform(-500, 500);
        Line stroke;
        for (const Point2d p : {Point2d{0, 0}, {30, 0}, {100, 0}, {100, width}, {60, width}, {0, width}})
            stroke.push_back({x0 + c * p.x - s * p.y, s * p.x + c * p.y});
        std::rotate(stroke.begin(), stroke.begin() + round % 6, stroke.end());
        if (round % 2) std::reverse(stroke.begin(), stroke.end());
        CAPTURE(round, width, angle);
        const SimplePolygon polygon = simple_polygon(stroke);
        CHECK(is_simple(polygon.corners));
        double far = 0;
        for (const Point2d& p : polygon.corners)
            for (const Point2d& q : polygon.corners) far = std::max(far, distance(p, q));
        CHECK(far == Approx(100).epsilon(0.02));
        CHECK(area_of(polygon.corners) > 0.2 * 100 * width); // at worst a sliver of it is left
        CHECK(area_of(polygon.corners) < 1.05 * 100 * width);
        check_skeleton(sub_skeleton(stroke));
    }
    // What has no area stays without one, at every tolerance and in any direction.
    for (int round = 0; round < 40; ++round) {
        const double angle = 2 * math::pi * random.uniform(), c = math::cos(angle), s = math::sin(angle);
        CAPTURE(angle);
        CHECK(failure({{0, 0}, {100 * c, 100 * s}, {40 * c, 40 * s}}) == "stroke: has no area");
    }
    SimplePolygonOptions coarse;
    coarse.finer = 0;
    CHECK_THROWS_AS(simple_polygon({{0, 0}, {100, 0}, {100, 0.1}, {0, 0.1}}, coarse), Error);
}

TEST_CASE("BoundedDP keeps what Douglas and Peucker keep, and where the shape varies") {
    Cylinder cylinder;
    for (int i = 0; i <= 40; ++i) {
        cylinder.axis.push_back({static_cast<double>(i), i < 20 ? 0.4 * i : 0.4 * (40 - i)});
        cylinder.left.push_back(3);
        cylinder.right.push_back(3);
    }
    CHECK(bounded_dp(cylinder, 1, 1) == douglas_peucker(cylinder.axis, 1));
    for (Point2d& p : cylinder.axis) p.y = 0;
    CHECK(bounded_dp(cylinder, 1, 1) == std::vector<int>{0, 40});
    for (int i = 12; i <= 18; ++i) cylinder.left[i] = cylinder.right[i] = 6; // a knee
    CHECK(bounded_dp(cylinder, 1, 0) == std::vector<int>{0, 40});
    const std::vector<int> kept = bounded_dp(cylinder, 1, 1);
    CHECK(std::count(kept.begin(), kept.end(), 12) == 1);
    CHECK(std::count(kept.begin(), kept.end(), 18) == 1);
    CHECK(kept.size() < 12);
    std::size_t fewest = kept.size();
    for (const double threshold : {0.1, 0.3, 1.0, 3.0, 10.0})
        CHECK(bounded_dp(cylinder, threshold, 1).size() <=
              std::max(fewest, bounded_dp(cylinder, 0.1, 1).size()));
}

TEST_CASE("the sub-skeleton of a capsule is its axis") {
    const SubSkeleton s = sub_skeleton(capsule(100, 20));
    check_skeleton(s);
    double left = 0, right = 0;
    for (const auto& joint : s.joints) {
        CHECK(std::abs(joint.place.y) < 8);
        left = std::min(left, joint.place.x);
        right = std::max(right, joint.place.x);
    }
    CHECK(right > 95);
    CHECK(left < -95);
    CHECK(s.joints.size() <= 12);
}

TEST_CASE("sub-skeletons are trees inside their shapes, one limb to a lobe, at every size") {
    Random random(43);
    for (int round = 0; round < 60; ++round) {
        const int lobes = 3 + round % 5;
        const Line stroke = blob(random, lobes, 0.45);
        CAPTURE(round, lobes);
        const SubSkeleton s = sub_skeleton(stroke);
        check_skeleton(s);
        std::vector<int> degree(s.joints.size());
        for (const auto& [a, b] : s.bones) ++degree[a], ++degree[b];
        CHECK(std::count(degree.begin(), degree.end(), 1) >= lobes);
        Line moved = stroke;
        for (Point2d& p : moved) p = 8 * p; // exact in doubles
        const SubSkeleton larger = sub_skeleton(moved);
        REQUIRE(larger.joints.size() == s.joints.size());
        for (std::size_t j = 0; j < s.joints.size(); ++j)
            CHECK(distance(larger.joints[j].place, 8 * s.joints[j].place) == 0);
    }
}

TEST_CASE("refinement keeps a tree inside the shape, and larger thresholds never give more joints") {
    Random random(44);
    int fewer = 0;
    for (int round = 0; round < 40; ++round) {
        const SubSkeleton whole = sub_skeleton(blob(random, 3 + round % 5, 0.45));
        const SubSkeleton same = refine(whole, {0, 0, 0, 0});
        CHECK(same.joints.size() == whole.joints.size());
        CHECK(same.bones == whole.bones);
        for (int which = 0; which < 3; ++which) {
            std::size_t fewest = whole.joints.size();
            for (const double threshold : {0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.3, 0.6}) {
                RefinementOptions options{0, 0, 0, 0};
                (which == 0 ? options.prune : which == 1 ? options.merge : options.collapse) = threshold;
                const SubSkeleton refined = refine(whole, options);
                CAPTURE(round, which, threshold);
                CHECK(refined.joints.size() <= fewest);
                CHECK(refined.bones.size() + 1 == refined.joints.size());
                CHECK(roots(refined) == 1);
                for (const auto& joint : refined.joints) CHECK(inside(whole.outline.corners, joint.place));
                fewest = std::min(fewest, refined.joints.size());
            }
        }
        fewer += refine(whole).joints.size() < whole.joints.size();
    }
    CHECK(fewer > 15);
}

TEST_CASE("bad strokes are refused in a line") {
    CHECK(failure({{0, 0}, {1, 1}}) == "stroke: has fewer than three points");
    CHECK(failure({{0, 0}, {1, 1}, {2, 2}, {3, 3}}) == "stroke: has no area");
    CHECK(failure(Line(50, {3, 3})) == "stroke: has no area");
    CHECK(failure({{0, 0}, {1, std::numeric_limits<double>::infinity()}, {2, 0}}) ==
          "stroke: a coordinate is not a number");
    CHECK(failure({{0, 0}, {0, 0}, {10, 0}, {10, 0}, {10, 10}, {0, 10}}) == "none");
    Line dense;
    for (int i = 0; i < 1000000; ++i)
        dense.push_back({math::cos(2 * math::pi * i / 1e6), 0.5 * math::sin(2 * math::pi * i / 1e6)});
    CHECK(failure(dense) == "none");
}
