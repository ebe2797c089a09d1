// SPDX-License-Identifier: MIT
// The rasteriser, textures and views on small hand-made rigs.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "../rigging/figures.hpp"
#include "core/random.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::tests;

namespace {

// A rig of one rigid bone over a width × height crop with the given mesh.
Rig board(int width, int height, Mesh mesh) {
    Rig rig;
    rig.width = width, rig.height = height;
    rig.mesh = std::move(mesh);
    rig.bones.resize(1);
    for (const Point2d& p : rig.mesh.vertices) {
        VertexWeights w;
        w.weights[0] = 1;
        rig.weights.push_back(w);
        rig.texture.push_back({(p.x + 0.5) / width, (p.y + 0.5) / height});
        rig.depth.push_back(0);
    }
    return rig;
}

std::vector<Vec3> at_rest(const Rig& rig) {
    std::vector<Vec3> vertices;
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        vertices.push_back(to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]));
    return vertices;
}

View whole(const Rig& rig) {
    const double aspect = static_cast<double>(rig.width) / rig.height;
    return {-aspect / 2, 0, aspect, 1};
}

RgbaImage random_texture(int width, int height, std::uint64_t seed) {
    Random random(seed);
    RgbaImage image(width, height);
    for (Rgba8& p : image) {
        const auto byte = [&] { return static_cast<std::uint8_t>(random.integer(0, 255)); };
        const std::uint8_t r = byte(), g = byte(), b = byte();
        p = {r, g, b, 255};
    }
    return image;
}

Mesh one_quad(int width, int height) {
    return {{{-0.5, -0.5}, {width - 0.5, -0.5}, {width - 0.5, height - 0.5}, {-0.5, height - 0.5}},
            {{0, 1, 2, 3}}};
}

RenderOptions options_with(int size, int supersampling = 1) {
    RenderOptions options;
    options.size = size;
    options.supersampling = supersampling;
    return options;
}

} // namespace

TEST_CASE("a board at rest shows its texture pixel for pixel") {
    const RgbaImage texture = random_texture(24, 16, 1);
    const Rig rig = board(24, 16, one_quad(24, 16));
    CHECK(render_frame(rig, at_rest(rig), texture, whole(rig), options_with(24)) == texture);
}

TEST_CASE("abutting triangles cover every sample exactly once") {
    // A jittered grid over the whole board, all of one colour but translucent in the counting sense: every
    // triangle is drawn alone, and the number of triangles that cover a pixel is counted.
    Random random(11);
    Mesh mesh;
    const int n = 6, side = 48;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const bool inner = i > 0 && j > 0 && i < n && j < n;
            // A third of the inner vertices lies exactly on samples: ties are what the top-left rule is for.
            const double dx = inner ? (random.chance(0.3) ? 0.5 : random.uniform(-3, 3)) : 0;
            const double dy = inner ? (random.chance(0.3) ? 0.5 : random.uniform(-3, 3)) : 0;
            mesh.vertices.push_back({i * 8 - 0.5 + dx, j * 8 - 0.5 + dy});
        }
    Grid<int> covered(side, side);
    const RgbaImage white(4, 4, {255, 255, 255, 255});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            const std::vector<std::vector<int>> split =
                (i + j) % 2 ? std::vector<std::vector<int>>{{a, b, c}, {a, c, d}}
                            : std::vector<std::vector<int>>{{b, c, d}, {b, d, a}};
            for (const auto& triangle : split) {
                const Rig rig = board(side, side, {mesh.vertices, {triangle}});
                const RgbaImage frame =
                    render_frame(rig, at_rest(rig), white, whole(rig), options_with(side));
                for (std::size_t p = 0; p < frame.size(); ++p) covered.data()[p] += frame.data()[p].a == 255;
            }
        }
    for (int count : covered) CHECK(count == 1);
}

TEST_CASE(
    "edges are antialiased: alpha is the covered share, the colour is not darkened by what lies behind") {
    const Rig rig = board(16, 16, {{{-0.5, -0.5}, {7.0, -0.5}, {7.0, 15.5}, {-0.5, 15.5}}, {{0, 1, 2, 3}}});
    const RgbaImage red(2, 2, {200, 0, 0, 255});
    const RgbaImage frame = render_frame(rig, at_rest(rig), red, whole(rig), options_with(16, 4));
    for (int y = 0; y < 16; ++y) {
        CHECK(frame(6, y) == Rgba8{200, 0, 0, 255});
        CHECK(frame(7, y) == Rgba8{200, 0, 0, 128}); // half of the pixel
        CHECK(frame(8, y) == Rgba8{0, 0, 0, 0});
    }
    RenderOptions on_white = options_with(16, 4);
    on_white.background = {255, 255, 255, 255};
    const RgbaImage over = render_frame(rig, at_rest(rig), red, whole(rig), on_white);
    CHECK(over(7, 3) == Rgba8{228, 128, 128, 255});
    CHECK(over(9, 3) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("the nearer of two overlapping faces is seen, in whatever order they are drawn") {
    Mesh mesh = one_quad(8, 8);
    const std::vector<Point2d> first = mesh.vertices;
    mesh.vertices.insert(mesh.vertices.end(), first.begin(), first.end());
    mesh.faces.push_back({4, 5, 6, 7});
    Rig rig = board(8, 8, mesh);
    RgbaImage texture(2, 1);
    texture(0, 0) = {10, 0, 0, 255};
    texture(1, 0) = {0, 0, 90, 255};
    for (int v = 0; v < 4; ++v) rig.texture[v] = {0.25, 0.5}, rig.texture[v + 4] = {0.75, 0.5};
    for (const double z : {0.1, -0.1}) {
        for (int v = 4; v < 8; ++v) rig.depth[v] = z;
        const RgbaImage frame = render_frame(rig, at_rest(rig), texture, whole(rig), options_with(8));
        for (const Rgba8& p : frame) CHECK(p == (z > 0 ? texture(1, 0) : texture(0, 0)));
    }
}

TEST_CASE("transparent texels neither show nor hide") {
    const Rig rig = board(8, 8, one_quad(8, 8));
    RgbaImage texture(8, 8, {50, 60, 70, 255});
    texture(3, 4).a = 0;
    const RgbaImage frame = render_frame(rig, at_rest(rig), texture, whole(rig), options_with(8));
    CHECK(frame(3, 4) == Rgba8{0, 0, 0, 0});
    CHECK(frame(4, 4) == Rgba8{50, 60, 70, 255});
}

TEST_CASE("a large texture is reduced, not aliased") {
    RgbaImage checks(256, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const std::uint8_t v = (x + y) % 2 ? 255 : 0;
            checks(x, y) = {v, v, v, 255};
        }
    const Rig rig = board(256, 256, one_quad(256, 256));
    const RgbaImage frame = render_frame(rig, at_rest(rig), checks, whole(rig), options_with(32));
    for (const Rgba8& p : frame) CHECK(std::abs(p.r - 128) <= 2);
}

TEST_CASE("perspective enlarges what is nearer and leaves the drawing's plane alone") {
    Rig rig = board(32, 32, {{{7.5, 7.5}, {23.5, 7.5}, {23.5, 23.5}, {7.5, 23.5}}, {{0, 1, 2, 3}}});
    const RgbaImage white(2, 2, {255, 255, 255, 255});
    RenderOptions options = options_with(32);
    options.perspective = true;
    const auto covered = [&] {
        const RgbaImage frame = render_frame(rig, at_rest(rig), white, whole(rig), options);
        return std::count_if(frame.begin(), frame.end(), [](const Rgba8& p) { return p.a != 0; });
    };
    CHECK(covered() == 16 * 16);
    rig.depth.assign(4, 0.5); // of a camera 2.5 away: 1.25 times as large
    CHECK(covered() == 20 * 20);
    rig.depth.assign(4, 100); // behind the camera: nothing breaks
    CHECK(covered() >= 0);
}

TEST_CASE("vertices far outside the view are clipped by the frame") {
    const Rig rig = board(16, 16, {{{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}}, {{0, 1, 2, 3}}});
    const RgbaImage white(2, 2, {255, 255, 255, 255});
    const RgbaImage frame = render_frame(rig, at_rest(rig), white, whole(rig), options_with(16));
    for (const Rgba8& p : frame) CHECK(p.a == 255);
}

TEST_CASE(
    "the texture is opaque inside, takes the outline's outer half along and loses the paper around the ink") {
    RgbImage drawing(100, 100, {250, 248, 240});
    LabelMap labels(100, 100);
    fill(labels, 20, 20, 80, 80, Label::body);
    const auto ink = [&](int x0, int y0, int x1, int y1) {
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) drawing(x, y) = {20, 20, 30};
    };
    ink(19, 19, 21, 81), ink(19, 19, 81, 21), ink(19, 79, 81, 81); // centred on the border
    ink(76, 18, 79, 82); // inside it: a pixel of paper remains beyond
    ink(90, 40, 94, 60); // another mark
    const RgbaImage texture = make_texture(drawing, ink_of_crop(ink_darkness(drawing)), labels);
    CHECK(texture(50, 50) == Rgba8{250, 248, 240, 255});
    CHECK(texture(20, 50).a == 255);
    CHECK(texture(19, 50).a == 255);
    CHECK(texture(18, 50).a == 0);
    CHECK(texture(77, 50).a == 255);
    CHECK(texture(79, 50).a == 0);
    CHECK(texture(92, 50).a == 0);
    CHECK(texture(16, 50).r == 20); // transparent pixels carry the ink's colour: no halo
}

TEST_CASE("a walking character keeps its area and is the same in every run") {
    const Character c = table();
    const Rig rig = rig_of(c);
    RgbImage drawing(128, 100, {255, 255, 255});
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 128; ++x)
            if (c.labels(x, y)) drawing(x, y) = {static_cast<std::uint8_t>(40 * c.labels(x, y)), 90, 60};
    const RgbaImage texture = make_texture(drawing, ink_of_crop(ink_darkness(drawing)), c.labels);
    const BoneAnimation walk = retarget(rig, c.reference, c.reference.clips[0]);
    const View view = view_of(rig, {walk});
    const auto frames = render(rig, walk, texture, view, 5, options_with(128, 2));
    REQUIRE(frames.size() == 6);
    CHECK(frames == render(rig, walk, texture, view, 5, options_with(128, 2)));
    const auto area = [](const RgbaImage& frame) {
        double sum = 0;
        for (const Rgba8& p : frame) sum += p.a / 255.0;
        return sum;
    };
    const auto at_rest_area = area(render_frame(rig, at_rest(rig), texture, view, options_with(128, 2)));
    for (const RgbaImage& frame : frames) {
        CHECK(area(frame) > 0.85 * at_rest_area);
        CHECK(area(frame) < 1.05 * at_rest_area);
        Mask opaque(frame.width(), frame.height());
        for (std::size_t i = 0; i < frame.size(); ++i) opaque.data()[i] = frame.data()[i].a > 127;
        CHECK(connected_components(opaque).list.size() == 1); // nothing tears off
    }
}
