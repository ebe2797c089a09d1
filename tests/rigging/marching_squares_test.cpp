// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "pantin/image.hpp"
#include "pantin/rigging.hpp"
#include "rigging/mesh_checks.hpp"
#include "rigging/mesh_topology.hpp"

using namespace pantin;
using namespace pantin::test;

namespace {

MeshOptions options_with(int cell, bool interpolate = true, double margin = 0) {
    MeshOptions options;
    options.cell = cell;
    options.interpolate_distance = interpolate;
    options.margin = margin;
    return options;
}

// In degrees, over the fans of all faces.
double sharpest_corner(const Mesh& mesh) {
    double sharpest = 180;
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const Point2d p[3] = {mesh.vertices[face[0]], mesh.vertices[face[i]], mesh.vertices[face[i + 1]]};
            for (int k = 0; k < 3; ++k) {
                const Point2d u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
                sharpest = std::min(sharpest, std::atan2(std::abs(cross(u, v)), dot(u, v)) * 180 /
                                                  3.14159265358979323846);
            }
        }
    return sharpest;
}

} // namespace

TEST_CASE("a pixel alone becomes a diamond of four triangles") {
    Mask mask(5, 5);
    mask(2, 2) = 1;
    const Mesh mesh = marching_squares(mask, options_with(1));
    CHECK(mesh.vertices.size() == 5);
    CHECK(mesh.faces.size() == 4);
    CHECK(area_of(mesh) == 0.5); // half a pixel to each side
}

TEST_CASE("a square is meshed by quads, with interpolated distances to the pixel's edge") {
    Mask mask(32, 32);
    for (int y = 8; y <= 23; ++y)
        for (int x = 8; x <= 23; ++x) mask(x, y) = 1;
    const Mesh mesh = marching_squares(mask, options_with(8, false));
    // Corners inside: 8 and 16, so the midpoint lies at 4 and 20.
    double left = 1e9, right = -1e9;
    for (const Point2d& p : mesh.vertices) left = std::min(left, p.x), right = std::max(right, p.x);
    CHECK(left == 4);
    CHECK(right == 20);
    const Mesh finer = marching_squares(mask, options_with(8, true));
    left = 1e9, right = -1e9;
    for (const Point2d& p : finer.vertices) left = std::min(left, p.x), right = std::max(right, p.x);
    CHECK(left == Approx(8 - 8.0 / 9)); // 1 inside, 8 outside
    CHECK(right == Approx(16 + 8 * 8.0 / 9));
}

TEST_CASE("corners that the border passes closely are moved onto it: no slivers, the same shape") {
    double with = 180, without = 180;
    for (int step = 0; step < 60; ++step) {
        Mask mask(120, 120);
        const double cx = 60 + 0.21 * step, cy = 60 - 0.13 * step, a = 25 + 0.4 * step, b = 48 - 0.3 * step;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 120; ++x)
                mask(x, y) = (x - cx) * (x - cx) / (a * a) + (y - cy) * (y - cy) / (b * b) < 1;
        MeshOptions options = options_with(8);
        const Mesh snapped = marching_squares(mask, options);
        options.snap = 0;
        const Mesh plain = marching_squares(mask, options);
        check_is_proper(snapped);
        with = std::min(with, sharpest_corner(snapped));
        without = std::min(without, sharpest_corner(plain));
        CHECK(area_of(snapped) == Approx(area_of(plain)).epsilon(0.01));
        CHECK(border_area(snapped) == Approx(area_of(snapped)));
        CHECK(topology_of(snapped) == topology_of(plain));
    }
    CHECK(with > 10);
    CHECK(without < 6);
}

TEST_CASE("in the ambiguous case the value inside the voxel decides") {
    Mask apart(16, 16), joined;
    apart(4, 4) = apart(8, 8) = 1;
    joined = apart;
    joined(6, 6) = 1;
    CHECK(topology_of(marching_squares(apart, options_with(4))).pieces == 2);
    CHECK(topology_of(marching_squares(joined, options_with(4))).pieces == 1);
}

TEST_CASE("meshes of random masks are proper and have the area that their border encloses") {
    Random random(7);
    for (int round = 0; round < 30; ++round) {
        const Mask mask = random_blobs(random, 40, 9);
        for (const int cell : {1, 2, 3, 5, 8}) {
            const Mesh mesh = marching_squares(mask, options_with(cell, round % 2 == 0));
            CAPTURE(round, cell);
            check_is_proper(mesh);
            check_is_proper(marching_squares(mask, options_with(cell, true, 2)));
            CHECK(area_of(mesh) == Approx(border_area(mesh)).margin(1e-9));
        }
    }
}

TEST_CASE("at one pixel per voxel the mesh has the pieces and holes of the mask") {
    Random random(3);
    for (int round = 0; round < 40; ++round) {
        Mask mask = random_blobs(random, 24, 7);
        for (int k = 0; k < 30; ++k) mask(random.integer(0, 23), random.integer(0, 23)) ^= 1;
        CAPTURE(round);
        CHECK(topology_of(marching_squares(mask, options_with(1))) == topology_of(mask));
    }
}

TEST_CASE("a thin limb stays in one piece and a ring stays open when the cell is chosen automatically") {
    Mask mask(300, 300);
    for (int y = 20; y < 280; ++y)
        for (int x = 0; x < 300; ++x) {
            const double r = std::sqrt((x - 150.0) * (x - 150.0) + (y - 90.0) * (y - 90.0));
            mask(x, y) = (r < 60 && r > 50) || (y > 140 && std::abs(x - 100 - y / 3) < 2);
        }
    mask = largest_component(mask);
    MeshOptions options;
    options.margin = 0;
    const Mesh mesh = marching_squares(mask, options);
    CHECK(topology_of(mesh) == topology_of(mask));
    CHECK(topology_of(mesh) == Topology{1, 1});
    options.margin = ink_margin(300, 300);
    CHECK(topology_of(marching_squares(mask, options)) == Topology{1, 1});
}

TEST_CASE("the margin grows the mesh over the stroke's outer half") {
    Mask mask(64, 64);
    for (int y = 20; y < 44; ++y)
        for (int x = 20; x < 44; ++x) mask(x, y) = 1;
    const double plain = area_of(marching_squares(mask, options_with(4)));
    const double grown = area_of(marching_squares(mask, options_with(4, true, 4)));
    CHECK(plain == Approx(24 * 24).epsilon(0.05));
    CHECK(grown == Approx(31 * 31 - (4 - 3.14159) * 16).epsilon(0.03)); // rounded at the corners
}

TEST_CASE("an empty mask has an empty mesh, a full one covers the image and the margin around it") {
    CHECK(marching_squares(Mask(20, 20), options_with(4)).faces.empty());
    const Mesh mesh = marching_squares(Mask(20, 12, 1), options_with(4));
    CHECK(area_of(mesh) == Approx(20 * 12).epsilon(0.1));
}

TEST_CASE("every face knows which corners of its voxel lie inside") {
    Random random(5);
    for (int round = 0; round < 20; ++round) {
        const Mask mask = random_blobs(random, 48, 6);
        const int cell = random.integer(2, 6);
        const Mesh mesh = marching_squares(mask, options_with(cell, false));
        REQUIRE(mesh.cases.size() == mesh.faces.size());
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            Point2d middle;
            for (const int v : mesh.faces[f])
                middle = middle + 1.0 / static_cast<double>(mesh.faces[f].size()) * mesh.vertices[v];
            const int x = static_cast<int>(std::floor(middle.x / cell)) * cell,
                      y = static_cast<int>(std::floor(middle.y / cell)) * cell;
            const int expected = mask.value_or(x, y, 0) | mask.value_or(x + cell, y, 0) << 1 |
                                 mask.value_or(x + cell, y + cell, 0) << 2 |
                                 mask.value_or(x, y + cell, 0) << 3;
            REQUIRE(int(mesh.cases[f]) == expected);
        }
    }
}
