// SPDX-License-Identifier: MIT
// Each step on the characters of a page, one thread; the sum of a character beside the 5.4 s of the thesis
// (Table 5.1).
#include <cstdio>

#include "bench.hpp"
#include "core/resources.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/pipeline.hpp"

namespace pantin::bench {

namespace {

struct Row {
    const char* name;
    std::vector<double> times; // per character, or one for the page
};

void print_rows(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        std::printf("  %-24s", row.name);
        for (const double time : row.times) std::printf(" %9.1f", time);
        std::printf("\n");
    }
}

// Times of segment, skeletonize, identify, rig, GLB, frames, WebP, GIF of one character.
void add_character(const DetectedCharacter& character, const Segmenter& segmenter,
                   const std::vector<ReferenceSkeleton>& references, int rounds, std::vector<Row>& rows) {
    std::size_t next = 0;
    const auto time = [&](const std::function<void()>& work) {
        rows[next++].times.push_back(median_time(work, rounds));
    };
    Segmentation segmentation;
    time([&] { segmentation = segmenter.segment(character.ink, character.mask); });
    Skeletonization skeleton;
    time([&] { skeleton = skeletonize(segmentation.labels); });
    Identification identification;
    time([&] { identification = identify(skeleton.graph, segmentation.labels, references); });
    Rig rigged;
    time([&] { rigged = rig(skeleton.graph, segmentation.labels, identification, references); });
    const ReferenceSkeleton* reference = &references.front();
    for (const ReferenceSkeleton& r : references)
        if (r.name == identification.reference) reference = &r;
    RgbaImage texture;
    std::vector<BoneAnimation> clips;
    time([&] {
        clips.clear();
        for (const ReferenceClip& clip : reference->clips)
            clips.push_back(retarget(rigged, *reference, clip));
        texture = make_texture(character.drawing, character.ink, segmentation.labels);
        to_glb(rigged, texture, clips);
    });
    std::vector<RgbaImage> frames;
    time([&] { frames = render(rigged, clips.front(), texture, view_of(rigged, clips), 25); });
    if (webp_available()) time([&] { encode_webp(frames, 25); });
    if (gif_available()) time([&] { encode_gif(frames, 25); });
}

} // namespace

void bench_steps(const std::string& file, int rounds) {
    RgbImage page;
    Detection detection;
    const double load = median_time([&] { page = load_image(file); }, rounds);
    const double find = median_time([&] { detection = detect(page); }, rounds);
    const std::vector<ReferenceSkeleton> references = load_references();
    const auto weights = find_resource("weights/segmenter.safetensors");
    const Segmenter segmenter(weights, "weights/segmenter.safetensors");

    std::printf("%s, %dx%d, one thread, medians of %d, ms\n", file.c_str(), page.width(), page.height(),
                rounds);
    print_rows({{"load", {load}}, {"detect", {find}}});
    std::vector<Row> rows = {{"segment", {}}, {"skeletonize", {}}, {"identify", {}},
                             {"rig", {}},     {"GLB", {}},         {"frames of a clip", {}}};
    if (webp_available()) rows.push_back({"WebP", {}});
    if (gif_available()) rows.push_back({"GIF", {}});
    std::size_t skipped = 0;
    for (const DetectedCharacter& character : detection.characters) {
        try {
            std::vector<Row> one = rows;
            add_character(character, segmenter, references, rounds, one);
            rows = one;
        } catch (const CharacterRejected&) {
            ++skipped;
        }
    }
    Row total{"page + character to GLB", {}};
    for (std::size_t c = 0; c < rows[0].times.size(); ++c) {
        double sum = load + find;
        for (std::size_t step = 0; step < 5; ++step) sum += rows[step].times[c];
        total.times.push_back(sum);
    }
    rows.insert(rows.begin() + 5, total);
    print_rows(rows);
    if (skipped > 0) std::printf("  (%zu characters cannot be animated)\n", skipped);
}

} // namespace pantin::bench
