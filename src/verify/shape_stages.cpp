// SPDX-License-Identifier: MIT
// Steps 1 to 3: page to skeleton graph. The sub-steps of skeletonization that are functions of their own
// (skeletonization.hpp) are stages of their own; borders and Voronoi diagram are taken from the whole step,
// and so is its result.
#include <algorithm>

#include "core/reference_scale.hpp"
#include "formats/contour_file.hpp"
#include "formats/file_names.hpp"
#include "formats/page_file.hpp"
#include "formats/pictures.hpp"
#include "formats/segmentation_file.hpp"
#include "formats/skeleton_file.hpp"
#include "formats/voronoi_file.hpp"
#include "pantin/image.hpp"
#include "pipeline/segmentation_options.hpp"
#include "verify/stage.hpp"
#include "verify/step_files.hpp"

namespace pantin {

namespace {

constexpr const char* page_file = "page.png";

Files find(const StageContext& c) {
    return {{"found.json", found_to_json(c.networks.finder().find(
                               c.picture(page_file), ink_darkness(c.picture(page_file)), c.threads))}};
}

Files detect_characters(const StageContext& c) {
    DetectionOptions options = c.options.detection;
    options.threads = c.threads;
    const CharacterFinder* finder = options.detector == Detector::mask_rcnn ? &c.networks.finder() : nullptr;
    const Detection detection = detect(c.picture(page_file), options, finder);
    Page page;
    page.source = page_file;
    page.width = detection.width;
    page.height = detection.height;
    page.detector = detector_names[static_cast<std::size_t>(options.detector)];
    for (const DetectedCharacter& d : detection.characters)
        page.characters.push_back(
            {"character-" + std::to_string(page.characters.size() + 1), d.box, d.scale, d.score});
    const DetectedCharacter& first = detection.characters.front();
    return {{file_names::page, page_to_json(page)},
            {"trace/ink.png", png(to_grey(detection.ink))},
            {character_path + file_names::drawing, png(first.drawing)},
            {character_path + file_names::ink, png(inverted(first.ink))},
            {character_path + file_names::mask, png(to_grey(first.mask))}};
}

Files segment(const StageContext& c) {
    SegmentationOptions options =
        segmentation_options(c.picture(character_path + file_names::drawing), c.options.segmentation);
    options.threads = c.threads;
    const Segmentation result =
        c.networks.segmenter().segment(inverted(c.grey(character_path + file_names::ink)),
                                       c.mask(character_path + file_names::mask), options);
    return {{character_path + file_names::segmentation, segmentation_to_json(result)},
            {character_path + file_names::labels, png(result.labels)},
            {trace_path + "probabilities.json",
             probabilities_to_json(result.probabilities, c.drawing.probability_step)}};
}

// --- skeletonization
// -------------------------------------------------------------------------------------------

double merge_distance(const LabelMap& labels, const StageContext& c) {
    return c.options.skeletonization.merge_distance * reference_scale(labels.width(), labels.height());
}

Skeletonization whole(const StageContext& c) {
    return skeletonize(c.grey(character_path + file_names::labels), c.options.skeletonization);
}

SkeletonGraph graph_of(const StageContext& c, const std::string& name) {
    return skeleton_from_json(c.text(name), name);
}

Files contour(const StageContext& c) {
    const Skeletonization s = whole(c);
    return {{trace_path + file_names::trace_silhouette, png(to_grey(s.mask))},
            {character_path + file_names::contour, contour_to_json(s.contour)}};
}

Files voronoi(const StageContext& c) {
    const Skeletonization s = whole(c);
    return {{trace_path + file_names::trace_voronoi, voronoi_to_json(s.voronoi, s.residuals)},
            {trace_path + file_names::trace_voronoi_picture, png(to_grey(s.voronoi_raster))}};
}

// The ridges are nearly thin already; the whole silhouette meets every neighbourhood.
Files thin(const StageContext& c) {
    const auto thinned = [&](const char* file) {
        return png(to_grey(zhang_suen(c.mask(trace_path + file), c.options.skeletonization.thinning_stop)));
    };
    return {{trace_path + file_names::trace_thinned, thinned(file_names::trace_voronoi_picture)},
            {trace_path + "thinned-silhouette.png", thinned(file_names::trace_silhouette)}};
}

Files reduce(const StageContext& c) {
    const auto reduced = [&](const char* file) {
        return png(to_grey(remove_redundant_pixels(c.mask(trace_path + file))));
    };
    return {{character_path + file_names::skeleton_picture, reduced(file_names::trace_thinned)},
            {trace_path + "reduced-silhouette.png", reduced("thinned-silhouette.png")}};
}

Files graph(const StageContext& c) {
    const SkeletonGraph raw = extract_graph(c.mask(character_path + file_names::skeleton_picture),
                                            c.grey(character_path + file_names::labels));
    return {{trace_path + file_names::trace_skeleton_raw, skeleton_to_json(raw)}};
}

Files h1(const StageContext& c) {
    return {{trace_path + file_names::trace_skeleton_h1,
             skeleton_to_json(apply_h1(graph_of(c, trace_path + file_names::trace_skeleton_raw)))}};
}

Files h2(const StageContext& c) {
    const double distance = merge_distance(c.grey(character_path + file_names::labels), c);
    return {{character_path + file_names::skeleton,
             skeleton_to_json(apply_h2(graph_of(c, trace_path + file_names::trace_skeleton_h1), distance,
                                       c.options.skeletonization.merge_weighting))}};
}

Files skeleton(const StageContext& c) {
    const Skeletonization s = whole(c);
    return {{trace_path + file_names::trace_thinned, png(to_grey(s.thinned))},
            {character_path + file_names::skeleton_picture, png(to_grey(s.skeleton))},
            {trace_path + file_names::trace_skeleton_raw, skeleton_to_json(s.raw)},
            {trace_path + file_names::trace_skeleton_h1, skeleton_to_json(s.after_h1)},
            {character_path + file_names::skeleton, skeleton_to_json(s.graph)}};
}

} // namespace

std::vector<Stage> shape_stages() {
    const std::string labels = character_path + file_names::labels;
    return {
        {"find", {page_file}, {"found.json"}, find, Stage::found_by_network},
        {"detect",
         {page_file},
         {file_names::page, "trace/ink.png", character_path + file_names::drawing,
          character_path + file_names::mask},
         detect_characters},
        {"segment",
         {character_path + file_names::drawing, character_path + file_names::mask},
         {trace_path + "probabilities.json", character_path + file_names::segmentation, labels},
         segment},
        {"contour",
         {labels},
         {trace_path + file_names::trace_silhouette, character_path + file_names::contour},
         contour},
        {"voronoi",
         {labels},
         {trace_path + file_names::trace_voronoi, trace_path + file_names::trace_voronoi_picture},
         voronoi},
        {"thin",
         {trace_path + file_names::trace_voronoi_picture, trace_path + file_names::trace_silhouette},
         {trace_path + file_names::trace_thinned, trace_path + "thinned-silhouette.png"},
         thin},
        {"reduce",
         {trace_path + file_names::trace_thinned, trace_path + "thinned-silhouette.png"},
         {character_path + file_names::skeleton_picture, trace_path + "reduced-silhouette.png"},
         reduce},
        {"graph",
         {character_path + file_names::skeleton_picture, labels},
         {trace_path + file_names::trace_skeleton_raw},
         graph},
        {"h1",
         {trace_path + file_names::trace_skeleton_raw},
         {trace_path + file_names::trace_skeleton_h1},
         h1},
        {"h2",
         {trace_path + file_names::trace_skeleton_h1, labels},
         {character_path + file_names::skeleton},
         h2},
        {"skeletonize",
         {labels},
         {trace_path + file_names::trace_thinned, character_path + file_names::skeleton_picture,
          trace_path + file_names::trace_skeleton_raw, trace_path + file_names::trace_skeleton_h1,
          character_path + file_names::skeleton},
         skeleton},
    };
}

} // namespace pantin
