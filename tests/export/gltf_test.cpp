// SPDX-License-Identifier: MIT
// GLB: structure, weights, and that its animation moves the mesh as skin() does.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "export/glb_file.hpp"
#include "export/rigs.hpp"
#include "pantin/export.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

using Matrix = std::array<double, 16>; // column-major

Matrix multiply(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k) c[4 * j + i] += a[4 * k + i] * b[4 * j + k];
    return c;
}

Matrix from_trs(const std::vector<double>& t, const std::vector<double>& q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    return {1 - 2 * (y * y + z * z),
            2 * (x * y + z * w),
            2 * (x * z - y * w),
            0,
            2 * (x * y - z * w),
            1 - 2 * (x * x + z * z),
            2 * (y * z + x * w),
            0,
            2 * (x * z + y * w),
            2 * (y * z - x * w),
            1 - 2 * (x * x + y * y),
            0,
            t[0],
            t[1],
            t[2],
            1};
}

// What a viewer does: skinned positions of all vertices at key pose `key` (−1: at rest).
std::vector<Vec3> play(const GlbFile& glb, int key) {
    const auto& nodes = glb.json.at("nodes");
    std::vector<std::vector<double>> translation(nodes.size(), {0, 0, 0}),
        rotation(nodes.size(), {0, 0, 0, 1});
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].contains("translation"))
            translation[n] = nodes[n]["translation"].get<std::vector<double>>();
        if (nodes[n].contains("rotation")) rotation[n] = nodes[n]["rotation"].get<std::vector<double>>();
    }
    if (key >= 0) {
        const auto& animation = glb.json.at("animations").at(0);
        for (const auto& channel : animation.at("channels")) {
            const std::size_t node = channel.at("target").at("node");
            const auto values =
                glb.read(animation.at("samplers").at(channel.at("sampler").get<std::size_t>()).at("output"));
            const bool turns = channel.at("target").at("path") == "rotation";
            const long size = turns ? 4 : 3;
            (turns ? rotation : translation)[node].assign(values.begin() + key * size,
                                                          values.begin() + (key + 1) * size);
        }
    }
    std::vector<Matrix> world(nodes.size());
    const auto visit = [&](auto&& self, std::size_t node, const Matrix& above) -> void {
        world[node] = multiply(above, from_trs(translation[node], rotation[node]));
        if (nodes[node].contains("children"))
            for (const std::size_t child : nodes[node]["children"]) self(self, child, world[node]);
    };
    for (const std::size_t root : glb.json["scenes"][0]["nodes"])
        visit(visit, root, from_trs({0, 0, 0}, {0, 0, 0, 1}));

    const auto& skin = glb.json.at("skins").at(0);
    const auto inverse = glb.read(skin.at("inverseBindMatrices"));
    const auto& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
    const auto p = glb.read(attributes.at("POSITION")), joints = glb.read(attributes.at("JOINTS_0")),
               weights = glb.read(attributes.at("WEIGHTS_0"));
    std::vector<Vec3> out(p.size() / 3);
    for (std::size_t v = 0; v < out.size(); ++v)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto joint = static_cast<std::size_t>(joints[4 * v + k]);
            Matrix bind;
            for (std::size_t i = 0; i < 16; ++i) bind[i] = inverse[16 * joint + i];
            const Matrix m = multiply(world[skin["joints"][joint].get<std::size_t>()], bind);
            const double w = weights[4 * v + k];
            out[v].x += w * (m[0] * p[3 * v] + m[4] * p[3 * v + 1] + m[8] * p[3 * v + 2] + m[12]);
            out[v].y += w * (m[1] * p[3 * v] + m[5] * p[3 * v + 1] + m[9] * p[3 * v + 2] + m[13]);
            out[v].z += w * (m[2] * p[3 * v] + m[6] * p[3 * v + 1] + m[10] * p[3 * v + 2] + m[14]);
        }
    return out;
}

GlbFile square_glb() {
    const RgbaImage texture(16, 16, Rgba8{10, 20, 30, 255});
    return GlbFile(to_glb(square_rig(), texture, {swing()}));
}

void check_near(Vec3 a, Vec3 b) {
    CHECK(a.x == Approx(b.x).margin(1e-6));
    CHECK(a.y == Approx(b.y).margin(1e-6));
    CHECK(a.z == Approx(b.z).margin(1e-6));
}

} // namespace

TEST_CASE("A viewer that plays the GLB sees what our own skinning computes", "[export]") {
    const Rig rig = square_rig();
    const BoneAnimation animation = swing();
    const GlbFile glb = square_glb();
    for (int key = 0; key < 3; ++key) {
        const std::vector<Vec3> seen = play(glb, key);
        const std::vector<Vec3> ours = skin(rig, animation, animation.times[static_cast<std::size_t>(key)]);
        REQUIRE(seen.size() == ours.size());
        for (std::size_t v = 0; v < seen.size(); ++v) check_near(seen[v], ours[v]);
    }
}

TEST_CASE("At rest the skinned GLB mesh is the mesh itself", "[export]") {
    const Rig rig = square_rig();
    const std::vector<Vec3> seen = play(square_glb(), -1);
    for (std::size_t v = 0; v < seen.size(); ++v)
        check_near(seen[v], to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]));
}

TEST_CASE("GLB weights sum to one, at most four joints, none twice, joint 0 where the weight is 0",
          "[export]") {
    const GlbFile glb = square_glb();
    const auto& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
    const auto joints = glb.read(attributes["JOINTS_0"]), weights = glb.read(attributes["WEIGHTS_0"]);
    for (std::size_t v = 0; v + 3 < weights.size(); v += 4) {
        CHECK(std::abs(weights[v] + weights[v + 1] + weights[v + 2] + weights[v + 3] - 1) < 1e-7);
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(weights[v + k] >= 0);
            if (weights[v + k] == 0) CHECK(joints[v + k] == 0);
            for (std::size_t l = 0; l < k; ++l)
                if (weights[v + k] > 0) CHECK(joints[v + k] != joints[v + l]);
        }
    }
}

TEST_CASE("A bone that moves a vertex twice is merged", "[export]") {
    Rig rig = square_rig();
    rig.weights[0] = {{1, 1, 0, 0}, {0.25, 0.25, 0.5, 0}};
    const GlbFile glb(to_glb(rig, RgbaImage(4, 4), {}));
    const auto& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
    const auto weights = glb.read(attributes["WEIGHTS_0"]);
    CHECK(weights[0] == 0.5);
    CHECK(weights[1] == 0.5);
    CHECK(weights[2] == 0);
    CHECK_FALSE(glb.json.contains("animations"));
}

TEST_CASE("Every joint points its +Y at the end of its bone and leaves have end joints", "[export]") {
    const GlbFile glb = square_glb();
    const auto& nodes = glb.json["nodes"];
    // mesh, root, hips, leg, leg.1, leg.1.end: hips is no leaf.
    REQUIRE(nodes.size() == 6);
    CHECK(nodes[5]["name"] == "leg.1.end");
    CHECK(nodes[0].contains("skin"));
    CHECK_FALSE(nodes[0].contains("translation"));
    CHECK(glb.json["scenes"][0]["nodes"] == nlohmann::json::array({0, 1}));
    // leg ends where leg.1 begins, so the child's translation is along +Y of the leg.
    const std::vector<double> along = nodes[4]["translation"];
    CHECK(along[0] == Approx(0).margin(1e-7));
    CHECK(along[1] == Approx(std::sqrt(2.0) / 8));
    const std::vector<double> end = nodes[5]["translation"];
    CHECK(end[0] == Approx(0).margin(1e-7));
    CHECK(end[1] == Approx(1.5 / 8));
}

TEST_CASE("GLB triangles face +z", "[export]") {
    const GlbFile glb = square_glb();
    const auto& primitive = glb.json["meshes"][0]["primitives"][0];
    const auto p = glb.read(primitive["attributes"]["POSITION"]), index = glb.read(primitive["indices"]);
    REQUIRE(index.size() == 24); // four quads, two triangles each
    for (std::size_t i = 0; i < index.size(); i += 3) {
        const auto x = [&](std::size_t k) { return p[3 * static_cast<std::size_t>(index[i + k])]; };
        const auto y = [&](std::size_t k) { return p[3 * static_cast<std::size_t>(index[i + k]) + 1]; };
        CHECK((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0)) > 0);
    }
}

TEST_CASE("Neighbouring rotation keys lie on one side, so that players turn the short way", "[export]") {
    BoneAnimation animation = swing();
    animation.rotations[1][1] = {0, 0, -0.6, -0.8}; // the same turn with the other sign
    const GlbFile glb(to_glb(square_rig(), RgbaImage(4, 4), {animation}));
    for (const auto& channel : glb.json["animations"][0]["channels"]) {
        if (channel["target"]["path"] != "rotation") continue;
        const auto q =
            glb.read(glb.json["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
        for (std::size_t k = 4; k < q.size(); k += 4)
            CHECK(q[k] * q[k - 4] + q[k + 1] * q[k - 3] + q[k + 2] * q[k - 2] + q[k + 3] * q[k - 1] > 0);
    }
}
