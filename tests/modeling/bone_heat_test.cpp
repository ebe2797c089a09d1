// SPDX-License-Identifier: MIT
// Skin weights of solids: sums, symmetry, smoothness, hand-worked cases.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "modeling/solids.hpp"
#include "pantin/model.hpp"

using namespace pantin;

namespace {

std::vector<double> dense(const VertexWeights& weights, std::size_t bones) {
    std::vector<double> all(bones, 0.0);
    for (int k = 0; k < 4; ++k)
        if (weights.weights[k] > 0) all[weights.bones[k]] += weights.weights[k];
    return all;
}

void check_weights(const std::vector<VertexWeights>& weights, std::size_t vertices, int bones) {
    REQUIRE(weights.size() == vertices);
    int wrong = 0;
    for (const VertexWeights& w : weights) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            wrong += w.weights[k] < 0 || w.bones[k] < 0 || w.bones[k] >= bones;
            wrong += k > 0 && w.weights[k] > w.weights[k - 1];
            wrong += w.weights[k] * 65536 != std::floor(w.weights[k] * 65536);
            sum += w.weights[k];
        }
        wrong += sum != 1;
    }
    CHECK(wrong == 0);
}

SolidMesh solid_capsule(double half, double radius) {
    const Inflation bar = inflate(test::capsule({-half, 0}, {half, 0}, radius));
    return unite({{&bar, 1, {}}});
}

const BoneSegment left{{-80, 0, 0}, {0, 0, 0}, 15}, right{{0, 0, 0}, {80, 0, 0}, 15};

std::vector<BoneSegment> bones_of(const Model& model) {
    std::vector<BoneSegment> bones;
    const auto& joints = model.skeleton().joints;
    for (const auto& joint : joints)
        if (joint.parent >= 0)
            bones.push_back({joints[joint.parent].place, joint.place,
                             0.5 * (joint.radius + joints[joint.parent].radius)});
    return bones;
}

} // namespace

TEST_CASE("two bones share a capsule evenly: the nearest one far from the joint, both at it") {
    const SolidMesh mesh = solid_capsule(80, 15);
    const std::vector<VertexWeights> weights = bone_heat(mesh, {left, right});
    check_weights(weights, mesh.vertices.size(), 2);
    for (std::size_t v = 0; v < weights.size(); ++v) {
        const double x = mesh.vertices[v].x, w = dense(weights[v], 2)[1];
        if (x > 45) CHECK(w > 0.9);
        if (x < -45) CHECK(w < 0.1);
        if (std::abs(x) < 2) CHECK(w == Approx(0.5).margin(0.15));
    }
}

TEST_CASE("what is symmetric gets symmetric weights") {
    // A part's own surface and its mirror image, so that every vertex has a twin.
    const Inflation bar = inflate(test::capsule({-80, 0}, {80, 0}, 15));
    SolidMesh mesh = part_surface(bar, 1, {}),
              mirrored = part_surface(bar, 1, {{}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}});
    const std::vector<VertexWeights> one = bone_heat(mesh, {left, right}),
                                     two = bone_heat(mirrored, {right, left});
    double worst = 0;
    for (std::size_t v = 0; v < one.size(); ++v) {
        REQUIRE(mirrored.vertices[v].x == -mesh.vertices[v].x);
        worst = std::max(worst, std::abs(dense(one[v], 2)[0] - dense(two[v], 2)[0]));
    }
    CHECK(worst <= 2.0 / 65536);
    // Along one capsule: at x as much of the one bone as at −x of the other, up to the triangles, which are
    // not symmetric.
    const SolidMesh capsule = solid_capsule(80, 15);
    const std::vector<VertexWeights> weights = bone_heat(capsule, {left, right});
    std::map<int, std::pair<double, int>> at; // mean weight of the right bone, by slices
    for (std::size_t v = 0; v < weights.size(); ++v) {
        auto& [sum, count] = at[static_cast<int>(std::floor(capsule.vertices[v].x / 10))];
        sum += dense(weights[v], 2)[1];
        ++count;
    }
    for (const auto& [slice, mean] : at)
        if (const auto twin = at.find(-1 - slice); twin != at.end())
            CHECK(mean.first / mean.second + twin->second.first / twin->second.second ==
                  Approx(1).margin(0.05));
}

TEST_CASE("weights are smooth along the surface") {
    const SolidMesh mesh = solid_capsule(80, 15);
    const std::vector<VertexWeights> weights = bone_heat(mesh, {left, right});
    double steepest = 0;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            steepest = std::max(steepest, std::abs(dense(weights[a], 2)[0] - dense(weights[b], 2)[0]) /
                                              distance(mesh.vertices[a], mesh.vertices[b]));
        }
    CHECK(steepest < 1.2 / 15); // they change over about the radius
    CHECK(steepest > 0.1 / 15);
}

TEST_CASE("the bones' order does not matter, nor does the model's size") {
    Random random(81);
    Model model(test::model_strokes("cat"));
    const SolidMesh mesh = model.united();
    const std::vector<BoneSegment> bones = bones_of(model);
    const std::vector<VertexWeights> weights = bone_heat(mesh, bones);
    check_weights(weights, mesh.vertices.size(), static_cast<int>(bones.size()));
    std::vector<int> order;
    for (int b = 0; b < std::ssize(bones); ++b) order.push_back(b);
    random.shuffle(order);
    std::vector<BoneSegment> shuffled;
    for (const int b : order) shuffled.push_back(bones[b]);
    const std::vector<VertexWeights> other = bone_heat(mesh, shuffled);
    int different = 0;
    for (std::size_t v = 0; v < weights.size(); ++v) {
        const std::vector<double> a = dense(weights[v], bones.size()), b = dense(other[v], bones.size());
        double worst = 0;
        for (std::size_t k = 0; k < order.size(); ++k) worst = std::max(worst, std::abs(a[order[k]] - b[k]));
        different += worst > 2.0 / 65536;
    }
    CHECK(different == 0);
    SolidMesh large = mesh;
    for (Vec3& p : large.vertices) p = 16 * p;
    for (BoneSegment& b : shuffled) b = {16 * b.head, 16 * b.tail, 16 * b.radius};
    const std::vector<VertexWeights> scaled = bone_heat(large, shuffled);
    for (std::size_t v = 0; v < other.size(); ++v)
        different += scaled[v].weights != other[v].weights || scaled[v].bones != other[v].bones;
    CHECK(different == 0);
}

TEST_CASE("limbs of a model follow their own bones") {
    Model model(test::model_strokes("cat"));
    const SolidMesh mesh = model.united();
    const std::vector<BoneSegment> bones = bones_of(model);
    const std::vector<VertexWeights> weights = bone_heat(mesh, bones);
    std::vector<int> part_of;
    for (const auto& joint : model.skeleton().joints)
        if (joint.parent >= 0) part_of.push_back(joint.part);
    // Of what only one part's surface is near, most weight lies with bones of that part or of one that it
    // touches.
    int tails = 0;
    for (std::size_t v = 0; v < weights.size(); ++v) {
        if (mesh.vertices[v].y < 60 || mesh.vertices[v].x < 110) continue; // the upper end of the tail
        ++tails;
        double own = 0;
        for (int k = 0; k < 4; ++k)
            if (weights[v].weights[k] > 0 &&
                model.parts()[part_of[weights[v].bones[k]]].stroke.name == "tail")
                own += weights[v].weights[k];
        CHECK(own > 0.99);
    }
    CHECK(tails > 20);
}

TEST_CASE("one bone gets all, no bone leaves the default, and bones without length are points") {
    const SolidMesh mesh = solid_capsule(40, 15);
    for (const VertexWeights& w : bone_heat(mesh, {left})) CHECK((w.bones[0] == 0 && w.weights[0] == 1));
    CHECK(bone_heat(mesh, {}).size() == mesh.vertices.size());
    CHECK(bone_heat({}, {left}).empty());
    const std::vector<VertexWeights> points =
        bone_heat(mesh, {{{-40, 0, 0}, {-40, 0, 0}, 15}, {{40, 0, 0}, {40, 0, 0}, 15}});
    check_weights(points, mesh.vertices.size(), 2);
    for (std::size_t v = 0; v < points.size(); ++v)
        if (mesh.vertices[v].x < -35) CHECK(dense(points[v], 2)[0] > 0.8);
}
