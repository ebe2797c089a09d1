// SPDX-License-Identifier: MIT
// The rasteriser against one that shades every sample by itself, on faces that nobody would draw.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "../rigging/figures.hpp"
#include "animation/fragments.hpp"
#include "animation/screen_face.hpp"
#include "bench/sample_renderer.hpp"
#include "core/random.hpp"
#include "pantin/image.hpp"

using namespace pantin;
using namespace pantin::tests;

namespace {

struct Scene {
    Rig rig;
    std::vector<Vec3> vertices;
    RgbaImage texture;
    View view{0, 0, 1, 0.8};
};

// Colours that go over into each other slowly: what a pixel shows does not depend on how it is filtered.
RgbaImage soft_texture(int width, int height) {
    RgbaImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image(x, y) = {static_cast<std::uint8_t>(40 + 160 * x / width),
                           static_cast<std::uint8_t>(220 - 160 * y / height),
                           static_cast<std::uint8_t>(60 + 60 * (x + y) / (width + height)), 255};
    return image;
}

// Triangles and quadrangles of all sizes: most in the frame, some far beyond it, some without area.
Scene random_scene(std::uint64_t seed, int faces) {
    Random random(seed);
    Scene scene;
    scene.texture = soft_texture(64, 48);
    scene.rig.width = 64, scene.rig.height = 48;
    for (int f = 0; f < faces; ++f) {
        const double size = std::pow(10.0, random.uniform(-3, random.chance(0.1) ? 4 : 0));
        const double x = random.uniform(-0.2, 1.2), y = random.uniform(-0.2, 1),
                     z = random.uniform(-0.2, 0.2);
        const int corners = random.chance(0.5) ? 4 : 3;
        std::vector<int> face;
        for (int i = 0; i < corners; ++i) {
            if (i > 0 && random.chance(0.05)) { // a corner twice
                face.push_back(face.back());
                continue;
            }
            // A square turned a little for the quadrangles, so that some are convex.
            const double u = corners == 4 ? (i == 1 || i == 2) : random.uniform(0, 1),
                         v = corners == 4 ? i / 2 : random.uniform(0, 1);
            const double shake = random.chance(0.5) ? 0 : 0.3;
            face.push_back(static_cast<int>(scene.vertices.size()));
            scene.vertices.push_back({x + size * (u + random.uniform(-shake, shake)),
                                      y + size * (v + random.uniform(-shake, shake)),
                                      z + 0.02 * random.uniform(-1, 1)});
            scene.rig.texture.push_back({0.1 + 0.8 * u, 0.1 + 0.8 * v});
        }
        scene.rig.mesh.faces.push_back(face);
    }
    scene.rig.mesh.vertices.resize(scene.vertices.size());
    return scene;
}

struct Difference {
    int covered = 0, largest = 0; // pixels whose alpha differs; of the colours of the others
    double mean = 0;
};

Difference between(const RgbaImage& a, const RgbaImage& b) {
    Difference d;
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Rgba8 p = a.data()[i], q = b.data()[i];
        if (p.a != q.a) ++d.covered;
        if (p.a != q.a || p.a == 0) continue;
        const int most = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
        d.largest = std::max(d.largest, most), d.mean += most, ++count;
    }
    d.mean /= std::max(count, 1);
    return d;
}

} // namespace

TEST_CASE("a walk along an edge finds the samples that its function says are inside") {
    Random random(3);
    for (int round = 0; round < 300; ++round) {
        const auto vertex = [&] {
            ScreenVertex v;
            const double reach = random.chance(0.2) ? 2e8 : 5000;
            v.x = static_cast<std::int64_t>(random.uniform(-reach, reach));
            v.y = random.chance(0.2) ? 128 : static_cast<std::int64_t>(random.uniform(-reach, reach));
            return v;
        };
        const ScreenEdge edge(vertex(), vertex());
        if (edge.dy == 0) continue;
        EdgeWalk walk(edge, -3);
        for (int row = -3; row < 12; ++row, walk.next_row())
            for (int x = -20; x < 20; ++x) {
                const bool inside = edge.at_row(row) - x * sample_units * std::int64_t{edge.dy} >= 0;
                CHECK(inside == (edge.dy < 0 ? x >= walk.sample() : x < walk.sample()));
            }
    }
}

TEST_CASE("random faces cover what single samples cover, in about the same colours") {
    for (const bool perspective : {false, true})
        for (const bool solid : {false, true})
            for (std::uint64_t seed = 1; seed <= 12; ++seed) {
                Scene scene = random_scene(seed, 40);
                scene.rig.solid = solid;
                if (solid && seed % 2 == 0)
                    for (std::size_t v = 0; v < scene.vertices.size(); ++v)
                        scene.rig.colours.push_back({static_cast<std::uint8_t>(v * 37), 90, 200});
                RenderOptions options;
                options.size = 97;
                options.perspective = perspective;
                options.supersampling = 1 + static_cast<int>(seed % 5);
                CAPTURE(perspective, solid, seed);
                const RgbaImage frame =
                    render_frame(scene.rig, scene.vertices, scene.texture, scene.view, options);
                const Difference d =
                    between(frame, bench::SampleRenderer(scene.rig, scene.texture, scene.view,
                                                         options)(scene.vertices));
                CHECK(d.covered == 0);
                CHECK(d.mean < 1.5);
                CHECK(d.largest < 32);
            }
}

TEST_CASE("a frame is the same for any number of threads") {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene scene = random_scene(seed, 60);
        RenderOptions options;
        options.size = 150;
        const FrameRenderer renderer(scene.rig, scene.texture, scene.view, options);
        const RgbaImage frame = renderer(scene.vertices);
        for (const int threads : {2, 4, 40}) CHECK(renderer(scene.vertices, threads) == frame);
    }
}

TEST_CASE("fragments of a pixel share no sample, and together have all that were put") {
    Random random(5);
    FragmentBuffer buffer(1, 1);
    Fragment& pixel = buffer.row(0)[0];
    std::array<int, 16> shown{};
    pixel = {1, 0};
    for (int face = 1; face < 200; ++face) {
        const auto samples = static_cast<SampleMask>(random.integer(1, 0xfffe));
        buffer.put(pixel, {samples, face});
        for (int i = 0; i < 16; ++i)
            if (samples >> i & 1) shown[i] = face;
        SampleMask all = 0;
        for (const Fragment* f = &pixel; f; f = buffer.next(*f)) {
            CHECK((all & f->samples) == 0);
            all |= f->samples;
            for (int i = 0; i < 16; ++i)
                if (f->samples >> i & 1) CHECK(shown[i] == f->face);
        }
    }
}

TEST_CASE("a black hole that a painting program left in the texture does not darken the edge") {
    Scene scene;
    scene.texture = RgbaImage(40, 40, {200, 180, 160, 255});
    for (int y = 0; y < 40; ++y)
        for (int x = 20; x < 40; ++x) scene.texture(x, y) = {0, 0, 0, 0};
    scene.rig.texture = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    scene.vertices = {{0, 0, 0}, {0.8, 0, 0}, {0.8, 0.8, 0}, {0, 0.8, 0}};
    scene.rig.mesh = {std::vector<Point2d>(4), {{0, 1, 2, 3}}};
    RenderOptions options;
    options.size = 17;
    const RgbaImage frame = render_frame(scene.rig, scene.vertices, scene.texture, scene.view, options);
    for (const Rgba8& p : frame)
        if (p.a != 0) CHECK(p.r >= 190);
}

TEST_CASE("the outline of a moving character is nearer to many samples than nine were") {
    const Character c = table();
    const Rig rig = rig_of(c);
    RgbImage drawing(128, 100, {230, 200, 120});
    const RgbaImage texture = make_texture(drawing, {}, c.labels);
    const BoneAnimation walk = retarget(rig, c.reference, c.reference.clips[0]);
    const View view = view_of(rig, {walk});
    RenderOptions options, nine, many;
    options.size = nine.size = many.size = 200;
    nine.supersampling = 3, many.supersampling = 8;
    double now = 0, before = 0;
    for (const double time : {0.1, 0.4, 0.7}) {
        const std::vector<Vec3> pose = skin(rig, walk, time);
        const RgbaImage wanted = bench::SampleRenderer(rig, texture, view, many)(pose);
        const auto error = [&wanted](const RgbaImage& frame) {
            double sum = 0;
            for (std::size_t i = 0; i < frame.size(); ++i)
                sum += std::abs(frame.data()[i].a - wanted.data()[i].a);
            return sum;
        };
        now += error(render_frame(rig, pose, texture, view, options));
        before += error(bench::SampleRenderer(rig, texture, view, nine)(pose));
    }
    CHECK(now < 0.8 * before);
}
