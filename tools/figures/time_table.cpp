// SPDX-License-Identifier: MIT
// How long each step takes on single characters (thesis, table 5.1).
#include <algorithm>
#include <array>
#include <thread>

#include "bench/bench.hpp"
#include "figures/gallery.hpp"
#include "figures/results.hpp"
#include "figures/svg.hpp"
#include "pantin/image.hpp"

namespace pantin::figures {
namespace {

constexpr int rounds = 5;
#if defined(__x86_64__)
constexpr const char* processor = "x86-64";
#elif defined(__aarch64__)
constexpr const char* processor = "aarch64";
#else
constexpr const char* processor = "another processor";
#endif
constexpr const char* files[] = {"humanoid.png", "quadruped.png", "flying.png",
                                 "photo.jpg",    "dog.png",       "person.png"};

// Milliseconds of detection, segmentation, skeletonization, identification, rigging.
using Times = std::array<double, 5>;

Times times_of(Gallery& gallery, const std::string& file) {
    const RgbImage& page = gallery.page(file);
    const CharacterFinder& finder = gallery.networks().finder();
    const Segmenter& segmenter = gallery.networks().segmenter();
    const std::vector<ReferenceSkeleton>& references = gallery.references();
    Times times{};
    Detection detection;
    times[0] = bench::median_time([&] { detection = detect(page, {}, &finder); }, rounds);
    const DetectedCharacter& character = detection.characters.front();
    Segmentation segmentation;
    times[1] =
        bench::median_time([&] { segmentation = segmenter.segment(character.ink, character.mask); }, rounds);
    Skeletonization skeleton;
    times[2] = bench::median_time([&] { skeleton = skeletonize(segmentation.labels); }, rounds);
    Identification identification;
    times[3] = bench::median_time(
        [&] { identification = identify(skeleton.graph, segmentation.labels, references); }, rounds);
    times[4] = bench::median_time(
        [&] { rig(skeleton.graph, segmentation.labels, identification, references); }, rounds);
    return times;
}

std::string row(const std::string& name, const Times& times) {
    std::string text = "| " + name + " |";
    double sum = 0;
    for (const double t : times) {
        text += " " + shown(t, t < 10 ? 1 : 0) + " |";
        sum += t;
    }
    return text + " " + shown(sum, 0) + " |\n";
}

} // namespace

std::string time_table(const std::string& testdata) {
    Gallery gallery(testdata);
    std::string text =
        "Milliseconds, medians of " + std::to_string(rounds) + " runs, one thread (" +
        std::to_string(std::thread::hardware_concurrency()) + " vCPU " + processor + ", network kernel " +
        std::string(network::name_of(network::best_simd())) +
        ").\nThe segmenter takes one view of a drawing where its confidence suffices, else six. "
        "The thesis: Python and PyTorch on an Apple M2\n"
        "with eight cores, 640×480 pages, means over its 50 drawings.\n\n"
        "| drawing | detection | segmentation | skeletonization | identification | rigging | "
        "sum |\n|---|---|---|---|---|---|---|\n";
    Times mean{};
    for (const char* file : files) {
        const Times times = times_of(gallery, file);
        for (std::size_t step = 0; step < times.size(); ++step)
            mean[step] += times[step] / static_cast<double>(std::size(files));
        text += row("`" + std::string(file) + "`, " + std::to_string(gallery.page(file).width()) + "×" +
                        std::to_string(gallery.page(file).height()),
                    times);
    }
    return text + row("**mean**", mean) + row("thesis, table 5.1", {1532, 1020, 420, 911, 1510});
}

} // namespace pantin::figures
