// SPDX-License-Identifier: MIT
// Frames a second of the rasteriser and of the one that shades every sample, on the same frames of the same
// clips; how far the pixels at the outline are from those of 8 x 8 samples; both in one picture, enlarged.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "bench.hpp"
#include "bench/sample_renderer.hpp"
#include "core/resources.hpp"
#include "pantin/image.hpp"
#include "pantin/pipeline.hpp"

namespace pantin::bench {

namespace {

// Least processor time of a call, in milliseconds: other work on the machine counts less than in time on the
// wall.
double processor_time(const std::function<void()>& work, int rounds) {
    double least = 1e9;
    for (int i = 0; i < rounds; ++i) {
        const std::clock_t start = std::clock();
        work();
        least = std::min(least, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

struct Filmed {
    Rig rig;
    RgbaImage texture;
    std::vector<BoneAnimation> clips;
};

// The first character of a page.
Filmed filmed(const std::string& page) {
    const Detection detection = detect(load_image(page));
    const DetectedCharacter& character = detection.characters.at(0);
    const std::vector<ReferenceSkeleton> references = load_references();
    const std::string weights = "weights/segmenter.safetensors";
    const Segmentation segmentation =
        Segmenter(find_resource(weights), weights).segment(character.ink, character.mask);
    const SkeletonGraph graph = skeletonize(segmentation.labels).graph;
    const Identification identification = identify(graph, segmentation.labels, references);
    Filmed result{rig(graph, segmentation.labels, identification, references),
                  make_texture(character.drawing, character.ink, segmentation.labels),
                  {}};
    for (const ReferenceSkeleton& reference : references)
        if (reference.name == identification.reference)
            for (const ReferenceClip& clip : reference.clips)
                result.clips.push_back(as_filmed(retarget(result.rig, reference, clip)));
    return result;
}

// Differences of the pixels that 8 x 8 samples see partly covered, of 255: alpha, and the colour times alpha.
struct EdgeError {
    double alpha = 0, colour = 0;
    long count = 0;

    void add(const RgbaImage& frame, const RgbaImage& exact) {
        const auto difference = [](int a, int alpha_a, int b, int alpha_b) {
            return std::abs(a * alpha_a - b * alpha_b) / 255.0;
        };
        for (std::size_t i = 0; i < frame.size(); ++i) {
            const Rgba8 p = frame.data()[i], q = exact.data()[i];
            if (q.a == 0 || q.a == 255) continue;
            alpha += std::abs(p.a - q.a);
            colour += (difference(p.r, p.a, q.r, q.a) + difference(p.g, p.a, q.g, q.a) +
                       difference(p.b, p.a, q.b, q.a)) /
                      3;
            ++count;
        }
    }
};

// The part of a frame around the topmost pixel that is drawn, each pixel `scale` times as large, on white.
void put_enlarged(RgbImage& sheet, const RgbaImage& frame, int left, int side, int scale) {
    const auto first = std::find_if(frame.begin(), frame.end(), [](const Rgba8& p) { return p.a != 0; });
    const int at = static_cast<int>(first - frame.begin());
    const int x0 = std::clamp(at % frame.width() - side / 2, 0, std::max(frame.width() - side, 0)),
              y0 = std::clamp(at / frame.width() - 4, 0, std::max(frame.height() - side, 0));
    for (int y = 0; y < side * scale; ++y)
        for (int x = 0; x < side * scale; ++x) {
            const Rgba8 p = frame.contains(x0 + x / scale, y0 + y / scale)
                                ? frame(x0 + x / scale, y0 + y / scale)
                                : Rgba8{};
            const auto on_white = [&p](int value) {
                return static_cast<std::uint8_t>((value * p.a + 255 * (255 - p.a) + 127) / 255);
            };
            sheet(left + x, y) = {on_white(p.r), on_white(p.g), on_white(p.b)};
        }
}

RgbImage sheet_of(const std::vector<RgbaImage>& frames) {
    constexpr int side = 96, scale = 4, gap = 8;
    RgbImage sheet(static_cast<int>(frames.size()) * (side * scale + gap) - gap, side * scale, {90, 90, 90});
    for (std::size_t i = 0; i < frames.size(); ++i)
        put_enlarged(sheet, frames[i], static_cast<int>(i) * (side * scale + gap), side, scale);
    return sheet;
}

void bench_character(const std::string& name, const std::string& folder, int rounds) {
    const Filmed character = filmed("testdata/" + name + ".png");
    const View view = view_of(character.rig, character.clips);
    const RenderOptions options;
    RenderOptions nine = options, exact = options;
    nine.supersampling = 3, exact.supersampling = 8;
    const FrameRenderer present(character.rig, character.texture, view, options);
    const SampleRenderer former(character.rig, character.texture, view, nine),
        reference(character.rig, character.texture, view, exact);
    const BoneAnimation& clip = character.clips.front();
    constexpr int frames = 12;
    std::vector<std::vector<Vec3>> poses;
    for (int i = 0; i < frames; ++i) poses.push_back(skin(character.rig, clip, clip.duration * i / frames));
    double present_time = 1e9, former_time = 1e9;
    for (int round = 0; round < rounds; ++round) {
        present_time = std::min(present_time, processor_time(
                                                  [&] {
                                                      for (const auto& pose : poses) present(pose);
                                                  },
                                                  5));
        former_time = std::min(former_time, processor_time(
                                                [&] {
                                                    for (const auto& pose : poses) former(pose);
                                                },
                                                1));
    }
    const double skinning = processor_time(
                                [&] {
                                    for (int i = 0; i < frames; ++i)
                                        skin(character.rig, clip, 0.3 * clip.duration);
                                },
                                20) /
                            frames;
    EdgeError now, before;
    for (int i = 0; i < frames; i += 4) {
        const RgbaImage wanted = reference(poses[i]);
        now.add(present(poses[i]), wanted);
        before.add(former(poses[i]), wanted);
    }
    std::printf(
        "  %-10s %5zu faces %8.0f frames/s, every sample %6.1f, x %.1f; skinning %.3f ms; error at the "
        "outline: alpha %.1f, every sample %.1f; colour %.1f, %.1f\n",
        name.c_str(), character.rig.mesh.faces.size(), 1000 * frames / present_time,
        1000 * frames / former_time, former_time / present_time, skinning, now.alpha / now.count,
        before.alpha / before.count, now.colour / now.count, before.colour / before.count);
    if (!folder.empty())
        save_png(folder + "/" + name + ".png",
                 sheet_of({former(poses[2]), present(poses[2]), reference(poses[2])}));
}

} // namespace

void bench_rasteriser(const std::string& folder, int rounds) {
    std::printf("\nframes of 512 pixels, one thread\n");
    for (const char* name : {"humanoid", "quadruped", "flying"}) bench_character(name, folder, rounds);
}

} // namespace pantin::bench
