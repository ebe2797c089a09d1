// SPDX-License-Identifier: MIT
// How long each step takes on single characters with both presets (thesis, table 5.1).
#include <algorithm>
#include <array>
#include <thread>

#include "bench/bench.hpp"
#include "figures/gallery.hpp"
#include "figures/results.hpp"
#include "figures/svg.hpp"
#include "pantin/image.hpp"
#include "pipeline/segmentation_options.hpp"

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
struct Timed {
    Times times{};
    bool proven = true; // each distance that identification compares; false: a search was cut off
};

Timed times_of(Gallery& gallery, const std::string& file, const Options& options) {
    const RgbImage& page = gallery.page(file);
    const CharacterFinder& finder = gallery.networks().finder();
    const Segmenter& segmenter = gallery.networks().segmenter();
    const std::vector<ReferenceSkeleton>& references = gallery.references();
    Timed timed;
    Times& times = timed.times;
    Detection detection;
    times[0] = bench::median_time([&] { detection = detect(page, options.detection, &finder); }, rounds);
    const DetectedCharacter& character = detection.characters.front();
    Segmentation segmentation;
    times[1] = bench::median_time(
        [&] {
            segmentation = segmenter.segment(character.ink, character.mask,
                                             segmentation_options(character.drawing, options.segmentation));
        },
        rounds);
    const LabelMap& labels = segmentation.labels;
    Skeletonization skeleton;
    times[2] = bench::median_time([&] { skeleton = skeletonize(labels, options.skeletonization); }, rounds);
    Identification identification;
    times[3] = bench::median_time(
        [&] {
            identification =
                identify(skeleton.graph, labels, references, options.identification, segmentation.type);
        },
        rounds);
    times[4] = bench::median_time(
        [&] { rig(skeleton.graph, labels, identification, references, options.rigging); }, rounds);
    for (const Candidate& candidate : identification.candidates) timed.proven &= candidate.optimal;
    return timed;
}

std::string row(const std::string& name, const Timed& timed) {
    std::string text = "| " + name + " |";
    double sum = 0;
    for (std::size_t step = 0; step < timed.times.size(); ++step) {
        const double t = timed.times[step];
        text += " " + shown(t, t < 10 ? 1 : 0) + (step == 3 && !timed.proven ? " *" : "") + " |";
        sum += t;
    }
    return text + " " + shown(sum, 0) + " |\n";
}

std::string table_of(Gallery& gallery, const std::string& preset) {
    std::string text = "\nWith `" + preset +
                       "`:\n\n| drawing | detection | segmentation | skeletonization | identification | "
                       "rigging | sum |\n|---|---|---|---|---|---|---|\n";
    Timed mean;
    for (const char* file : files) {
        const Timed timed = times_of(gallery, file, make_preset(preset));
        for (std::size_t step = 0; step < timed.times.size(); ++step)
            mean.times[step] += timed.times[step] / static_cast<double>(std::size(files));
        text += row("`" + std::string(file) + "`, " + std::to_string(gallery.page(file).width()) + "×" +
                        std::to_string(gallery.page(file).height()),
                    timed);
    }
    return text + row("**mean**", mean) + row("thesis, table 5.1", {{1532, 1020, 420, 911, 1510}});
}

} // namespace

std::string time_table(const std::string& testdata) {
    Gallery gallery(testdata);
    const std::string solver =
        ilp_available() ? "is the integer program of Eq. 4.3 to 4.7 as printed, once for each of the three "
                          "references, solved by GLPK\nwith chapter 5's limits (an asterisk: its 10,000 "
                          "subproblems ended before a distance was proven)."
                        : "is branch and bound: this program was built without GLPK, which solves the "
                          "integer program.";
    return "Milliseconds, medians of " + std::to_string(rounds) + " runs, one thread (" +
           std::to_string(std::thread::hardware_concurrency()) + " vCPU " + processor + ", network kernel " +
           std::string(network::name_of(network::best_simd())) +
           ").\nThe segmenter takes one view of a drawing where its confidence suffices, else six; with "
           "`thesis` always one. Identification with `default`\nis our branch and bound, with `thesis` it " +
           solver +
           " The thesis: Python and\nPyTorch on an Apple M2 with eight cores, 640×480 pages, means over its "
           "50 drawings.\n" +
           table_of(gallery, "default") + table_of(gallery, "thesis");
}

} // namespace pantin::figures
