// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "figures.hpp"
#include "image/label_map.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "rigging/cut.hpp"
#include "rigging/limbs.hpp"
#include "rigging/mesh_topology.hpp"
#include "rigging/ownership.hpp"
#include "rigging/skin_weights.hpp"
#include "rigging/thesis_weights.hpp"

using namespace pantin;
using namespace pantin::tests;

namespace {

double weight_of(const VertexWeights& w, int bone) {
    double sum = 0;
    for (int k = 0; k < 4; ++k)
        if (w.bones[k] == bone) sum += w.weights[k];
    return sum;
}

// Weight of all bones of the limb whose innermost bone is `bone`.
double limb_weight(const Rig& rig, const VertexWeights& w, int bone) {
    double sum = weight_of(w, bone);
    for (int b = bone + 1; b < static_cast<int>(rig.bones.size()) && rig.bones[b].segment > 0; ++b)
        sum += weight_of(w, b);
    return sum;
}

} // namespace

TEST_CASE("limbs begin where they leave the body and end at the end-effector") {
    const Character c = table();
    const Limbs limbs =
        find_limbs(c.graph, nearest_labels(c.labels), distance_transform(c.labels), c.reference, c.mapping);
    REQUIRE(limbs.limbs.size() == 6);
    CHECK(limbs.side_branches.empty());
    CHECK(limbs.root.y == 40);
    const Limb& leg = limbs.limbs[2];
    CHECK(leg.path.front() == Point2d{28, 50});
    CHECK(leg.path.back() == Point2d{28, 86});
    CHECK(leg.length() == 36);
    CHECK(leg.parent == -1);
    CHECK(leg.at(10) == Point2d{28, 60});
    CHECK(leg.at(-5) == leg.path.front());
    CHECK(leg.at(99) == leg.path.back());
    CHECK(leg.width == Approx(8).margin(2));
}

TEST_CASE("bones form chains with their parents first, named after the reference's joints") {
    const Rig rig = rig_of(table());
    REQUIRE(rig.bones.size() == 2 + 1 + 2 + 4 * 2); // hips and chest, head, tail, legs
    CHECK(rig.bones[0].name == "hips");
    CHECK(rig.bones[0].parent == -1);
    for (std::size_t b = 1; b < rig.bones.size(); ++b) CHECK(rig.bones[b].parent < static_cast<int>(b));
    const int leg = bone_named(rig, "leg_hind_left"), shin = bone_named(rig, "leg_hind_left.1");
    REQUIRE(leg > 0);
    REQUIRE(shin > 0);
    CHECK(rig.bones[leg].parent == 0);
    CHECK(rig.bones[bone_named(rig, "leg_front_left")].parent == bone_named(rig, "chest"));
    CHECK(rig.bones[bone_named(rig, "head")].parent == bone_named(rig, "chest"));
    CHECK(rig.bones[shin].parent == leg);
    CHECK(rig.bones[leg].tail == rig.bones[shin].head);
    CHECK(rig.bones[leg].head == Point2d{72, 50});
    CHECK(rig.bones[shin].tail == Point2d{72, 86});
}

TEST_CASE("smooth weights sum to exactly one, with at most four bones, and stay local") {
    const Rig rig = rig_of(table());
    REQUIRE(rig.weights.size() == rig.mesh.vertices.size());
    const int leg = bone_named(rig, "leg_front_left"), other = bone_named(rig, "leg_front_right");
    const int shin = bone_named(rig, "leg_front_left.1"), chest = bone_named(rig, "chest");
    REQUIRE(chest > 0);
    for (std::size_t v = 0; v < rig.weights.size(); ++v) {
        const VertexWeights& w = rig.weights[v];
        double sum = 0;
        float single = 0;
        for (int k = 0; k < 4; ++k) {
            CHECK(w.weights[k] >= 0);
            if (k > 0) CHECK(w.weights[k] <= w.weights[k - 1]);
            CHECK(w.weights[k] * 65536 == std::rint(w.weights[k] * 65536));
            sum += w.weights[k];
            single += static_cast<float>(w.weights[k]);
        }
        CHECK(sum == 1.0);
        CHECK(single == 1.0f);
        const Point2d p = rig.mesh.vertices[v];
        if (p.y > 80 && p.x < 34) CHECK(weight_of(w, shin) > 0.9);                                 // the foot
        if (p.y > 62 && p.x < 34) CHECK(limb_weight(rig, w, leg) > 0.95);                          // the leg
        if (p.y < 44 && p.x > 30 && p.x < 90) CHECK(weight_of(w, 0) + weight_of(w, chest) > 0.95); // the back
        if (p.y < 44 && p.x > 75 && p.x < 90) CHECK(weight_of(w, 0) > 0.9);
        if (p.y < 44 && p.x > 30 && p.x < 36) CHECK(weight_of(w, chest) > 0.9);
        if (p.y > 60 && p.x < 34) CHECK(limb_weight(rig, w, other) < 0.001);
    }
}

TEST_CASE("neighbouring vertices have similar weights, so that nothing creases") {
    const Rig rig = rig_of(table());
    const int bones = static_cast<int>(rig.bones.size());
    for (const auto& [u, v] : edges_of(rig.mesh)) {
        double difference = 0;
        for (int b = 0; b < bones; ++b)
            difference += std::abs(weight_of(rig.weights[u], b) - weight_of(rig.weights[v], b));
        CHECK(difference / 2 < 0.45);
    }
}

TEST_CASE("weights are rounded by largest remainder and keep the four largest") {
    const VertexWeights w = quantised({0.1, 0, 0.3, 0.05, 0.25, 0.3});
    CHECK(w.bones == std::array<int, 4>{2, 5, 4, 0});
    CHECK(w.weights[0] + w.weights[1] + w.weights[2] + w.weights[3] == 1.0);
    CHECK(w.weights[0] == Approx(0.3 / 0.95).margin(1e-4));
    const VertexWeights third = quantised({1, 1, 1});
    CHECK(third.weights[0] == 21846.0 / 65536);
    CHECK(third.weights[2] == 21845.0 / 65536);
    Random random(5);
    for (int round = 0; round < 1000; ++round) {
        std::vector<double> per_bone(6);
        for (double& x : per_bone) x = random.uniform();
        const VertexWeights q = quantised(per_bone);
        CHECK(q.weights[0] + q.weights[1] + q.weights[2] + q.weights[3] == 1.0);
    }
}

TEST_CASE("Algorithm 4.4 floods the label of each end-effector and leaves the rest to the body") {
    const Character c = table();
    RigOptions options;
    options.thesis_weights = true;
    options.mesh.cell = 4;
    options.mesh.margin = 0;
    const Rig rig = rig_of(c, options);
    REQUIRE(rig.bones.size() == 7);
    const int foot = bone_named(rig, "leg_front_left");
    const double sigma = bone_ratio(c.graph, 2, c.reference, c.mapping.pairs[2].reference_end);
    CHECK(sigma > 0);
    CHECK(sigma <= 1);
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v) {
        const Point2d p = rig.mesh.vertices[v];
        if (p.y > 54 && p.x < 34) {
            CHECK(weight_of(rig.weights[v], foot) == Approx(sigma).margin(1e-4));
            CHECK(weight_of(rig.weights[v], 0) == Approx(1 - sigma).margin(1e-4));
        }
        if (p.y < 46 && p.x > 24 && p.x < 96) CHECK(weight_of(rig.weights[v], 0) == 1);
    }
}

TEST_CASE("an end without a partner keeps its vertices for the body when EF is the set of all ends") {
    Character c = table();
    fill(c.labels, 32, 50, 44, 90, Label::limb); // the front legs become one block
    const Point2d unmapped = position_of(c.graph.vertices[c.mapping.pairs[3].end]);
    c.mapping.pairs.erase(c.mapping.pairs.begin() + 3); // leg_front_right has no partner
    RigOptions options;
    options.thesis_weights = true;
    options.mesh.cell = 4;
    options.mesh.margin = 0;
    const Rig mapped = rig_of(c, options);
    options.weight_ends = WeightEnds::all;
    const Rig all = rig_of(c, options);
    REQUIRE(all.bones.size() == mapped.bones.size());
    const Point2d own = position_of(c.graph.vertices[c.mapping.pairs[2].end]);
    const int foot = bone_named(mapped, "leg_front_left");
    int taken = 0, kept = 0;
    for (std::size_t v = 0; v < all.mesh.vertices.size(); ++v) {
        const Point2d p = all.mesh.vertices[v];
        const bool nearer = distance(p, unmapped) < distance(p, own);
        if (weight_of(mapped.weights[v], foot) > 0 && nearer) {
            CHECK(weight_of(all.weights[v], 0) == 1);
            ++taken;
        } else {
            CHECK(weight_of(all.weights[v], foot) == weight_of(mapped.weights[v], foot));
            kept += weight_of(all.weights[v], foot) > 0;
        }
    }
    CHECK(taken > 10);
    CHECK(kept > 10);
}

TEST_CASE("without a mapped end the body is the only bone of Algorithm 4.4, and the default has no rig") {
    Character c = table();
    c.mapping.pairs.clear();
    RigOptions options;
    CHECK_THROWS_AS(rig_of(c, options), CharacterRejected);
    options.thesis_weights = true;
    const Rig rig = rig_of(c, options);
    REQUIRE(rig.bones.size() == 1);
    for (const VertexWeights& w : rig.weights) CHECK(weight_of(w, 0) == 1);
}

TEST_CASE("floods stop halfway between two end-effectors of one label") {
    LabelMap labels(60, 20);
    fill(labels, 4, 4, 56, 16, Label::limb);
    MeshOptions options;
    options.cell = 4;
    options.margin = 0;
    const Mesh mesh = marching_squares(labels, options);
    const auto floods =
        flood_weights(mesh, nearest_labels(labels), {{{6, 10}, Label::limb}, {{54, 10}, Label::limb}});
    for (int v : floods[0].reached) CHECK(mesh.vertices[v].x <= 30);
    for (int v : floods[1].reached) CHECK(mesh.vertices[v].x >= 30);
    const std::size_t on_the_middle =
        std::count_if(mesh.vertices.begin(), mesh.vertices.end(), [](Point2d p) { return p.x == 30; });
    CHECK(floods[0].reached.size() + floods[1].reached.size() == mesh.vertices.size() + on_the_middle);
}

TEST_CASE("limbs that touch are cut apart below their roots and no influence crosses the cut") {
    Character c = table();
    fill(c.labels, 32, 50, 44, 90, Label::limb); // the front legs become one block, x 24…52
    const Rig rig = rig_of(c);
    const int left = bone_named(rig, "leg_front_left"), right = bone_named(rig, "leg_front_right");
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        if (rig.mesh.vertices[v].y > 84 && rig.mesh.vertices[v].x < 60) {
            const double l = limb_weight(rig, rig.weights[v], left),
                         r = limb_weight(rig, rig.weights[v], right);
            CHECK(std::max(l, r) > 0.95);
        }
    RigOptions whole;
    whole.mesh.cut_touching_parts = false;
    const Rig uncut = rig_of(c, whole);
    CHECK(rig.mesh.faces.size() == uncut.mesh.faces.size()); // at rest nothing is missing
    CHECK(rig.mesh.vertices.size() > uncut.mesh.vertices.size());
    std::vector<Point2d> places;
    for (const auto& p : rig.mesh.vertices) places.push_back(p);
    const auto less = [](Point2d a, Point2d b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(places.begin(), places.end(), less);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    CHECK(places.size() == uncut.mesh.vertices.size());
}

TEST_CASE("an unmatched end-effector moves: as a side branch, on a free joint, or behind its neighbour") {
    Character c = table();
    c.mapping.pairs.erase(c.mapping.pairs.begin() + 3); // leg_front_right is left out by the mapping
    CHECK(bone_named(rig_of(c), "leg_front_right") > 0);

    Character six = table(); // two more legs than the reference has
    for (int x : {34, 78}) {
        fill(six.labels, x, 50, x + 6, 90, Label::limb);
        six.graph.vertices.push_back({x + 3.0, 86, Label::limb, true});
    }
    const int j = static_cast<int>(six.graph.vertices.size());
    six.graph.vertices.push_back({37, 40, Label::body, false});
    six.graph.vertices.push_back({81, 40, Label::body, false});
    six.graph.edges.clear();
    for (const auto& [u, v] : {std::pair{0, 6},
                               {6, j},
                               {7, j},
                               {7, 8},
                               {8, j + 1},
                               {9, j + 1},
                               {1, 9},
                               {2, 6},
                               {3, 7},
                               {4, 8},
                               {5, 9},
                               {10, j},
                               {11, j + 1}})
        six.graph.edges.push_back(straight_edge(six.graph, std::min(u, v), std::max(u, v)));
    const Rig rig = rig_of(six);
    const auto followers = std::count_if(rig.bones.begin(), rig.bones.end(), [](const Bone& b) {
        return b.phase_shift == 0.5 && b.segment == 0;
    });
    CHECK(followers == 2);
}

TEST_CASE("a short unmatched branch becomes part of its limb") {
    Character c = table();
    c.graph.vertices[2] = {28, 86, Label::limb, true};
    fill(c.labels, 16, 82, 24, 90, Label::limb);              // toes
    c.graph.vertices.push_back({18, 85, Label::limb, true});  // 10
    c.graph.vertices.push_back({28, 80, Label::limb, false}); // 11
    c.graph.edges.erase(c.graph.edges.begin() + 5);
    c.graph.edges.push_back(straight_edge(c.graph, 2, 11));
    c.graph.edges.push_back(straight_edge(c.graph, 6, 11));
    c.graph.edges.push_back(straight_edge(c.graph, 10, 11));
    const Limbs limbs =
        find_limbs(c.graph, nearest_labels(c.labels), distance_transform(c.labels), c.reference, c.mapping);
    CHECK(limbs.limbs.size() == 6);
    REQUIRE(limbs.side_branches.size() == 1);
    CHECK(limbs.side_branches[0].limb == 2);
    CHECK(limbs.side_branches[0].position == 30);
}

TEST_CASE("a part without an end-effector in the skeleton still gets a bone") {
    Character c = table();
    c.graph.edges.erase(c.graph.edges.begin() + 4); // the tail's branch was pruned
    c.graph.vertices[1].end = false;
    c.mapping.pairs.erase(c.mapping.pairs.begin() + 1);
    c.graph.vertices[1] = {97, 40, Label::body, false};
    c.graph.edges.push_back(straight_edge(c.graph, 1, 9));
    const Rig rig = rig_of(c);
    const int tail = bone_named(rig, "tail");
    REQUIRE(tail > 0);
    CHECK(rig.bones[tail].head.x == Approx(100).margin(2));
}

TEST_CASE("pixels are owned along paths inside the silhouette, not across gaps") {
    const Character c = table();
    const LabelMap filled = nearest_labels(c.labels);
    const Limbs limbs = find_limbs(c.graph, filled, distance_transform(c.labels), c.reference, c.mapping);
    const Grid<Owner> owners = pixel_owners(limbs, skeleton_points(c.graph), c.labels, filled);
    CHECK(owners(60, 40).limb == -1);
    CHECK(owners(28, 70).limb == 2);
    CHECK(owners(28, 70).position == 20);
    CHECK(owners(25, 70).limb == 2);
    CHECK(owners(30, 48).limb == -1); // body, though the leg's root is nearer than the body's axis
    CHECK(far_apart(owners(28, 80), owners(48, 80), limbs, 4));
    CHECK_FALSE(far_apart(owners(28, 52), owners(40, 48), limbs, 4));
}

TEST_CASE("texture coordinates are the pixel centres over the crop's size, depths are small") {
    const Rig rig = rig_of(table());
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v) {
        CHECK(rig.texture[v].x == (rig.mesh.vertices[v].x + 0.5) / 128);
        CHECK(rig.texture[v].y == (rig.mesh.vertices[v].y + 0.5) / 100);
        CHECK(std::abs(rig.depth[v]) <= 0.01);
    }
}

TEST_CASE("without any mapped end-effector the character is rejected") {
    Character c = table();
    c.mapping.pairs.clear();
    CHECK_THROWS_AS(rig_of(c), CharacterRejected);
}
