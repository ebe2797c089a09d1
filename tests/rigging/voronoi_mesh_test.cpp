// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"
#include "pantin/rigging.hpp"
#include "rigging/figures.hpp"
#include "rigging/mesh_checks.hpp"
#include "rigging/mesh_topology.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

bool face_holds(const Mesh& mesh, const std::vector<int>& face, Point2d p) {
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Point2d a = mesh.vertices[face[i]], b = mesh.vertices[face[(i + 1) % face.size()]];
        if (cross(b - a, p - a) < -1e-9) return false;
    }
    return true;
}

// The pixels whose centres the mesh covers, border included.
Mask covered(const Mesh& mesh, int width, int height) {
    Mask mask(width, height);
    for (const std::vector<int>& face : mesh.faces) {
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (const int v : face) {
            left = std::min(left, mesh.vertices[v].x), right = std::max(right, mesh.vertices[v].x);
            top = std::min(top, mesh.vertices[v].y), bottom = std::max(bottom, mesh.vertices[v].y);
        }
        for (int y = std::max(0, static_cast<int>(std::floor(top))); y <= std::min(height - 1.0, bottom); ++y)
            for (int x = std::max(0, static_cast<int>(std::floor(left))); x <= std::min(width - 1.0, right);
                 ++x)
                if (face_holds(mesh, face, to_double(Point2i{x, y}))) mask(x, y) = 1;
    }
    return mask;
}

void check_mesh_of(const Mask& mask) {
    const Mesh mesh = voronoi_mesh(mask);
    check_is_proper(mesh);
    CHECK(topology_of(mesh) == topology_of(mask));
    CHECK(area_of(mesh) == Approx(border_area(mesh)));
    CHECK(covered(mesh, mask.width(), mask.height()) == mask);
}

// Longest side over the height on it.
double slimness(const Mesh& mesh, const std::vector<int>& face) {
    const Point2d a = mesh.vertices[face[0]], b = mesh.vertices[face[1]], c = mesh.vertices[face[2]];
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    return longest * longest / cross(b - a, c - a);
}

} // namespace

TEST_CASE("the Voronoi regions of a single pixel are four quarters of a square of half a pixel",
          "[voronoi_mesh]") {
    Mask mask(16, 16);
    mask(5, 7) = 1;
    const Mesh mesh = voronoi_mesh(mask);
    check_is_proper(mesh);
    CHECK(mesh.faces.size() == 8);
    CHECK(mesh.vertices.size() == 9);
    CHECK(area_of(mesh) == Approx(0.25));
    CHECK(std::count(mesh.vertices.begin(), mesh.vertices.end(), Point2d{5, 7}) == 1);
    CHECK(std::count(mesh.vertices.begin(), mesh.vertices.end(), Point2d{4.75, 6.75}) == 1);
}

TEST_CASE("meshes of Voronoi regions are proper, have the mask's pieces and holes, and cover the mask and "
          "nothing else",
          "[voronoi_mesh]") {
    Random random(18);
    for (int i = 0; i < 10; ++i) check_mesh_of(random_blobs(random, 40, 3 + 3 * i));
    // Noise: pixels that touch at corners, holes of one pixel, necks.
    for (const double share : {0.2, 0.5, 0.8}) {
        Mask noise(18, 18);
        for (std::uint8_t& pixel : noise) pixel = random.uniform(0, 1) < share;
        check_mesh_of(noise);
    }
    Mask board(9, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) board(x, y) = (x + y) % 2 == 0;
    check_mesh_of(board);
}

TEST_CASE("a margin grows the mesh of Voronoi regions, an empty mask has none", "[voronoi_mesh]") {
    Mask mask(30, 30);
    for (int y = 10; y < 20; ++y)
        for (int x = 10; x < 20; ++x) mask(x, y) = 1;
    CHECK(area_of(voronoi_mesh(mask)) == Approx(9.5 * 9.5));
    const Mesh grown = voronoi_mesh(mask, 3);
    const auto [left, right] = std::minmax_element(grown.vertices.begin(), grown.vertices.end(),
                                                   [](Point2d a, Point2d b) { return a.x < b.x; });
    CHECK(left->x == Approx(6.75));
    CHECK(right->x == Approx(22.25));
    CHECK(voronoi_mesh(Mask(20, 20)).faces.empty());
}

TEST_CASE("faces of Voronoi regions are long and thin where those of marching squares are not",
          "[voronoi_mesh]") {
    Mask disc(80, 80);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) disc(x, y) = (x - 40) * (x - 40) + (y - 40) * (y - 40) <= 35 * 35;
    const auto slimmest = [](const Mesh& mesh) {
        double most = 0;
        for (const std::vector<int>& face : mesh.faces) most = std::max(most, slimness(mesh, face));
        return most;
    };
    MeshOptions options;
    options.cell = 4;
    CHECK(slimmest(make_mesh(disc, options)) < 20);
    options.method = MeshMethod::voronoi_regions;
    CHECK(slimmest(make_mesh(disc, options)) > 50);
}

TEST_CASE("a character can be rigged on a mesh of Voronoi regions", "[voronoi_mesh]") {
    RigOptions options;
    options.mesh.method = MeshMethod::voronoi_regions;
    const Rig rig = tests::rig_of(tests::table(), options);
    CHECK(rig.mesh.vertices.size() > 1000);
    REQUIRE(rig.weights.size() == rig.mesh.vertices.size());
    for (const VertexWeights& w : rig.weights)
        CHECK(w.weights[0] + w.weights[1] + w.weights[2] + w.weights[3] == 1);
    const int foot = tests::bone_named(rig, "leg_front_left.1");
    REQUIRE(foot > 0);
    const auto moves = [foot](const VertexWeights& w) { return w.bones[0] == foot && w.weights[0] > 0.5; };
    CHECK(std::any_of(rig.weights.begin(), rig.weights.end(), moves));
}
