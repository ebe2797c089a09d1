// SPDX-License-Identifier: MIT
// How parts hang on one another: both events, parents, copies.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.hpp"
#include "modeling/rooted.hpp"
#include "modeling/solids.hpp"
#include "pantin/model.hpp"
#include "pantin/modeling.hpp"

using namespace pantin;

namespace {

using Joint = JointTree::Joint;

// A path of joints with one radius.
JointTree path(const std::vector<Vec3>& places, double radius) {
    JointTree tree;
    for (const Vec3& p : places) tree.joints.push_back({p, radius, 0});
    for (int j = 1; j < std::ssize(places); ++j) tree.bones.emplace_back(j - 1, j);
    return tree;
}

JointTree random_tree(Random& random, int joints, Vec3 centre, double size) {
    JointTree tree;
    for (int j = 0; j < joints; ++j) {
        const auto coordinate = [&] { return random.uniform(-size, size); };
        const Vec3 offset{coordinate(), coordinate(), coordinate()};
        tree.joints.push_back({centre + offset, random.uniform(0.5, 3), 0});
        if (j > 0) tree.bones.emplace_back(random.integer(0, j - 1), j);
    }
    return tree;
}

std::vector<int> degrees(const JointTree& tree) {
    std::vector<int> degree(tree.joints.size());
    for (const auto& [a, b] : tree.bones) ++degree[a], ++degree[b];
    return degree;
}

// The way from a point to a segment: the distance falls and rises once along it, so three parts of it narrow
// down to the foot.
double to_segment(Vec3 p, Vec3 a, Vec3 b) {
    double low = 0, high = 1;
    const auto at = [&](double t) { return distance(p, a + t * (b - a)); };
    for (int step = 0; step < 200; ++step) {
        const double third = (high - low) / 3;
        (at(low + third) > at(high - third) ? low : high) +=
            at(low + third) > at(high - third) ? third : -third;
    }
    return std::min({at(low), at(0), at(1)});
}

// Eq. (1) over all ends and junctions of the child and all bones of the parent.
double least_distance(const JointTree& child, const JointTree& parent) {
    double least = std::numeric_limits<double>::infinity();
    const std::vector<int> degree = degrees(child);
    for (std::size_t j = 0; j < degree.size(); ++j) {
        if (degree[j] == 2) continue;
        for (const Joint& joint : parent.joints)
            least = std::min(least, distance(child.joints[j].place, joint.place));
        for (const auto& [a, b] : parent.bones)
            least = std::min(
                least, to_segment(child.joints[j].place, parent.joints[a].place, parent.joints[b].place));
    }
    return least;
}

int trees_in(const JointTree& tree) { return static_cast<int>(tree.joints.size() - tree.bones.size()); }

bool has_bone(const JointTree& tree, int a, int b) {
    return std::any_of(tree.bones.begin(), tree.bones.end(),
                       [&](const auto& bone) { return bone == std::pair(a, b) || bone == std::pair(b, a); });
}

JointTree mirrored_in_x(JointTree tree) {
    for (Joint& joint : tree.joints) joint.place.x = -joint.place.x;
    return tree;
}

const JointTree torso = path({{-10, 0, 0}, {10, 0, 0}}, 3);

} // namespace

TEST_CASE("a part is joined where Eq. (1) is smallest, as brute force finds it") {
    Random random(61);
    int splits = 0;
    for (int round = 0; round < 300; ++round) {
        const JointTree parent = random_tree(random, random.integer(1, 9), {}, 10);
        const JointTree child = random_tree(random, random.integer(1, 6), {random.uniform(-20, 20), 0, 4}, 6);
        const Connection connection = connect({parent, child}, {{}, {0, -1}});
        const Attachment& attachment = connection.attachments[1];
        CAPTURE(round);
        REQUIRE(attachment.parent == 0);
        const Joint &own = connection.tree.joints[attachment.joint],
                    &other = connection.tree.joints[attachment.parent_joint];
        CHECK(own.part == 1);
        CHECK(other.part == 0);
        const double least = least_distance(child, parent);
        if (degrees(child)[attachment.joint - static_cast<int>(parent.joints.size())] != 2)
            CHECK(distance(own.place, other.place) == Approx(least).margin(1e-9));
        else // no end or junction lies in the parent, and this joint is nearer
            CHECK(distance(own.place, other.place) < least);
        // A new joint where the event says so; what was drawn stays as it was.
        CHECK(connection.tree.joints.size() == parent.joints.size() + child.joints.size() + attachment.split);
        CHECK((attachment.parent_joint >= std::ssize(parent.joints)) == attachment.split);
        for (std::size_t j = 0; j < parent.joints.size(); ++j)
            CHECK(connection.tree.joints[j].place == parent.joints[j].place);
        CHECK(trees_in(connection.tree) == 1);
        splits += attachment.split;
    }
    CHECK(splits > 50);
    CHECK(splits < 280);
}

TEST_CASE("a leg under the middle of a torso splits its bone at the foot of the perpendicular") {
    const JointTree leg = path({{2, -2, 0}, {2, -10, 0}}, 1);
    const Connection c = connect({torso, leg}, {{}, {}});
    REQUIRE(c.attachments[1].parent == 0);
    CHECK(c.attachments[1].split);
    CHECK(c.attachments[1].joint == 2);
    REQUIRE(c.attachments[1].parent_joint == 4);
    CHECK(c.tree.joints[4] == Joint{{2, 0, 0}, 3, 0});
    CHECK(c.tree.bones == std::vector<std::pair<int, int>>{{0, 4}, {2, 3}, {4, 1}, {4, 2}});
}

TEST_CASE("a leg beyond the end of a torso joins that end") {
    const JointTree leg = path({{11, -2, 0}, {11, -10, 0}}, 1);
    const Connection c = connect({torso, leg}, {{}, {}});
    REQUIRE(c.attachments[1].parent == 0);
    CHECK_FALSE(c.attachments[1].split);
    CHECK(c.attachments[1].parent_joint == 1);
    CHECK(c.tree.joints.size() == 4);
    CHECK(c.tree.bones == std::vector<std::pair<int, int>>{{0, 1}, {2, 3}, {1, 2}});
    // The foot on the very end is no foot inside the bone.
    const Connection exact = connect({torso, path({{10, -2, 0}, {10, -10, 0}}, 1)}, {{}, {}});
    CHECK_FALSE(exact.attachments[1].split);
    CHECK(exact.attachments[1].parent_joint == 1);
}

TEST_CASE("two legs split one bone in three, and a split joint has the radius of the cylinder there") {
    JointTree cone = torso;
    cone.joints[1].radius = 5;
    const Connection c =
        connect({cone, path({{-5, -2, 0}, {-5, -9, 0}}, 1), path({{5, -2, 0}, {5, -9, 0}}, 1)}, {{}, {}, {}});
    const Joint &left = c.tree.joints[c.attachments[1].parent_joint],
                &right = c.tree.joints[c.attachments[2].parent_joint];
    CHECK(left == Joint{{-5, 0, 0}, 3.5, 0});
    CHECK(right.place == Vec3{5, 0, 0});
    CHECK(right.radius == Approx(4.5));
    CHECK(has_bone(c.tree, 0, c.attachments[1].parent_joint));
    CHECK(has_bone(c.tree, c.attachments[1].parent_joint, c.attachments[2].parent_joint));
    CHECK(has_bone(c.tree, c.attachments[2].parent_joint, 1));
    CHECK_FALSE(has_bone(c.tree, 0, 1));
    CHECK(trees_in(c.tree) == 1);
}

TEST_CASE("a foot hangs on the leg and not on the torso that comes before it") {
    const JointTree leg = path({{0, -2, 0}, {0, -10, 0}}, 1), foot = path({{0.5, -10.5, 0}, {4, -11, 0}}, 1);
    const Connection c = connect({torso, leg, foot}, {{}, {}, {}});
    CHECK(c.attachments[0].parent == -1);
    CHECK(c.attachments[1].parent == 0);
    CHECK(c.attachments[2].parent == 1);
    CHECK_FALSE(c.attachments[2].split);
    CHECK(trees_in(c.tree) == 1);
    const ModelSkeleton skeleton = rooted(c.tree);
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        CHECK(skeleton.joints[j].parent < static_cast<int>(j));
        CHECK((skeleton.joints[j].parent < 0) == (j == 0));
    }
}

TEST_CASE("a part that meets no earlier one is a root, also one that a later part reaches") {
    const JointTree far = path({{0, 40, 0}, {0, 50, 0}}, 2), bridge = path({{0, 1, 0}, {0, 39, 0}}, 1);
    const Connection c = connect({torso, far, bridge}, {{}, {}, {}});
    CHECK(c.attachments[0].parent == -1);
    CHECK(c.attachments[1].parent == -1);
    CHECK(c.attachments[1].joint == -1);
    CHECK(c.attachments[2].parent >= 0);
    CHECK(trees_in(c.tree) == 2);
    const ModelSkeleton skeleton = rooted(c.tree);
    CHECK(std::count_if(skeleton.joints.begin(), skeleton.joints.end(),
                        [](const auto& j) { return j.parent < 0; }) == 2);
    const auto none = connect({}, {});
    CHECK(none.tree.joints.empty());
    CHECK(none.attachments.empty());
}

TEST_CASE("a part whose ends lie outside hangs where its balls and cylinders meet the other's") {
    // A sash across the torso: both ends are out, its middle cuts through.
    const JointTree sash = path({{0, -8, 0.5}, {0, 0, 0.5}, {0, 8, 0.5}}, 1);
    const Connection c = connect({torso, sash}, {{}, {}});
    CHECK(c.attachments[1].parent == 0);
    CHECK(trees_in(c.tree) == 1);
}

TEST_CASE("a named parent counts more than what is near") {
    const JointTree other = path({{-10, 30, 0}, {10, 30, 0}}, 3), leg = path({{2, 28, 0}, {2, 12, 0}}, 1);
    CHECK(connect({torso, other, leg}, {{}, {}, {}}).attachments[2].parent == 1);
    const Connection named = connect({torso, other, leg}, {{}, {}, {0, -1}});
    CHECK(named.attachments[2].parent == 0);
    CHECK(named.tree.joints[named.attachments[2].parent_joint].place == Vec3{2, 0, 0});
    CHECK(named.tree.joints[named.attachments[2].joint].place == Vec3{2, 12, 0});
}

TEST_CASE("a symmetric copy hangs on what the original hangs on, or on that part's copy") {
    const JointTree leg = path({{4, -2, 0}, {4, -10, 0}}, 1), foot = path({{4.5, -10.5, 0}, {7, -11, 0}}, 1);
    const JointTree leg2 = mirrored_in_x(leg), foot2 = mirrored_in_x(foot);
    const std::vector<JointTree> parts = {torso, leg, leg2, foot, foot2};
    for (const bool named : {false, true}) {
        const Connection c = connect(
            parts,
            {{}, {named ? 0 : -1, -1}, {named ? 0 : -1, 1}, {named ? 1 : -1, -1}, {named ? 1 : -1, 3}});
        CHECK(c.attachments[1].parent == 0);
        CHECK(c.attachments[2].parent == 0);
        CHECK(c.attachments[3].parent == 1);
        CHECK(c.attachments[4].parent == 2);
        CHECK(c.attachments[1].split == c.attachments[2].split);
        CHECK(trees_in(c.tree) == 1);
        for (const int original : {1, 3}) {
            const Joint &a = c.tree.joints[c.attachments[original].parent_joint],
                        &b = c.tree.joints[c.attachments[original + 1].parent_joint];
            CHECK(a.place == Vec3{-b.place.x, b.place.y, b.place.z});
        }
    }
    // A copy that would reach something else hangs where the original does all the same.
    const JointTree wall = path({{-4, -12, 0}, {-4, -14, 0}}, 6);
    const Connection c = connect({torso, wall, leg, leg2}, {{}, {}, {0, -1}, {0, 2}});
    CHECK(c.attachments[2].parent == 0);
    CHECK(c.attachments[3].parent == 0);
}

TEST_CASE("mirrored parts give mirrored connections, bit for bit") {
    Random random(62);
    for (int round = 0; round < 100; ++round) {
        std::vector<JointTree> parts, mirrored;
        std::vector<ParentWish> wishes;
        for (int p = random.integer(2, 7); p > 0; --p) {
            parts.push_back(random_tree(random, random.integer(1, 7),
                                        {random.uniform(-12, 12), random.uniform(-12, 12), 0}, 5));
            mirrored.push_back(mirrored_in_x(parts.back()));
            const int earlier = static_cast<int>(wishes.size());
            wishes.push_back({earlier > 0 && random.chance(0.3) ? random.integer(0, earlier - 1) : -1, -1});
        }
        const Connection one = connect(parts, wishes), two = connect(mirrored, wishes);
        REQUIRE(mirrored_in_x(two.tree) == one.tree);
        for (std::size_t p = 0; p < parts.size(); ++p) {
            CHECK(one.attachments[p].parent == two.attachments[p].parent);
            CHECK(one.attachments[p].joint == two.attachments[p].joint);
            CHECK(one.attachments[p].parent_joint == two.attachments[p].parent_joint);
            CHECK(one.attachments[p].split == two.attachments[p].split);
        }
        CHECK(trees_in(one.tree) == std::count_if(one.attachments.begin(), one.attachments.end(),
                                                  [](const Attachment& a) { return a.parent < 0; }));
    }
}

TEST_CASE("a symmetric model has a symmetric skeleton") {
    Model model;
    PartStroke body = test::part("body", test::capsule({0, -50}, {0, 50}, 25)),
               arm = test::part("arm", test::capsule({20, -40}, {90, -60}, 8));
    PartStroke hand = test::part("hand", test::disc({92, -60}, 12), "arm");
    arm.symmetry = hand.symmetry = Symmetry::x;
    model.add_part(body);
    model.add_part(arm);
    model.add_part(hand);
    REQUIRE(model.parts().size() == 5);
    CHECK(model.parts()[3].parent == 1);
    CHECK(model.parts()[4].parent == 2);
    const auto& joints = model.skeleton().joints;
    for (const auto& joint : joints) {
        if (joint.part == 0) continue;
        const int twin = joint.part % 2 ? joint.part + 1 : joint.part - 1;
        CHECK(std::count_if(joints.begin(), joints.end(), [&](const auto& other) {
                  return other.part == twin &&
                         other.place == Vec3{-joint.place.x, joint.place.y, joint.place.z} &&
                         other.radius == joint.radius;
              }) == 1);
    }
}
