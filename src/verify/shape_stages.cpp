// SPDX-License-Identifier: MIT
// Steps 1 to 3: page to skeleton graph. The sub-steps of skeletonization that are functions of their own
// (skeletonization.hpp) are stages of their own; borders and Voronoi diagram are taken from the whole step,
// and so is its result.
#include <algorithm>

#include "core/reference_scale.hpp"
#include "pantin/image.hpp"
#include "pipeline/character.hpp"
#include "pipeline/json_files.hpp"
#include "verify/stage.hpp"
#include "verify/step_files.hpp"

namespace pantin {

namespace {

constexpr const char* page_file = "page.png";

Files find(const StageContext& c) {
    return {{"found.json", found_to_json(c.networks.finder().find(c.picture(page_file), c.threads))}};
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
    return {{"page.json", page_to_json(page)},
            {"trace/ink.png", png(to_grey(detection.ink))},
            {character_path + "drawing.png", png(first.drawing)},
            {character_path + "mask.png", png(to_grey(first.mask))}};
}

Files segment(const StageContext& c) {
    SegmentationOptions options = c.options.segmentation;
    options.threads = c.threads;
    const Segmentation result = c.networks.segmenter().segment(c.picture(character_path + "drawing.png"),
                                                               c.mask(character_path + "mask.png"), options);
    return {{character_path + "segmentation.json", segmentation_to_json(result)},
            {character_path + "labels.png", png(result.labels)},
            {trace_path + "probabilities.json", probabilities_to_json(result.probabilities)}};
}

// --- skeletonization
// -------------------------------------------------------------------------------------------

double merge_distance(const LabelMap& labels, const StageContext& c) {
    return c.options.skeletonization.merge_distance * reference_scale(labels.width(), labels.height());
}

Skeletonization whole(const StageContext& c) {
    return skeletonize(c.grey(character_path + "labels.png"), c.options.skeletonization);
}

SkeletonGraph graph_of(const StageContext& c, const std::string& name) {
    return skeleton_from_json(c.text(name), name);
}

Files contour(const StageContext& c) {
    const Skeletonization s = whole(c);
    return {{trace_path + "silhouette.png", png(to_grey(s.mask))},
            {character_path + "contour.json", contour_to_json(s.contour)}};
}

Files voronoi(const StageContext& c) {
    const Skeletonization s = whole(c);
    return {{trace_path + "voronoi.json", voronoi_to_json(s.voronoi, s.residuals)},
            {trace_path + "voronoi.png", png(to_grey(s.voronoi_raster))}};
}

// The ridges are nearly thin already; the whole silhouette meets every neighbourhood.
Files thin(const StageContext& c) {
    const auto thinned = [&](const char* file) {
        return png(to_grey(zhang_suen(c.mask(trace_path + file))));
    };
    return {{trace_path + "thinned.png", thinned("voronoi.png")},
            {trace_path + "thinned-silhouette.png", thinned("silhouette.png")}};
}

Files reduce(const StageContext& c) {
    const auto reduced = [&](const char* file) {
        return png(to_grey(remove_redundant_pixels(c.mask(trace_path + file))));
    };
    return {{character_path + "skeleton.png", reduced("thinned.png")},
            {trace_path + "reduced-silhouette.png", reduced("thinned-silhouette.png")}};
}

Files graph(const StageContext& c) {
    const SkeletonGraph raw =
        extract_graph(c.mask(character_path + "skeleton.png"), c.grey(character_path + "labels.png"));
    return {{trace_path + "skeleton-raw.json", skeleton_to_json(raw)}};
}

Files h1(const StageContext& c) {
    return {{trace_path + "skeleton-h1.json",
             skeleton_to_json(apply_h1(graph_of(c, trace_path + "skeleton-raw.json")))}};
}

Files h2(const StageContext& c) {
    const double distance = merge_distance(c.grey(character_path + "labels.png"), c);
    return {{character_path + "skeleton.json",
             skeleton_to_json(apply_h2(graph_of(c, trace_path + "skeleton-h1.json"), distance))}};
}

Files skeleton(const StageContext& c) {
    const Skeletonization s = whole(c);
    return {{trace_path + "thinned.png", png(to_grey(s.thinned))},
            {character_path + "skeleton.png", png(to_grey(s.skeleton))},
            {trace_path + "skeleton-raw.json", skeleton_to_json(s.raw)},
            {trace_path + "skeleton-h1.json", skeleton_to_json(s.after_h1)},
            {character_path + "skeleton.json", skeleton_to_json(s.graph)}};
}

} // namespace

std::vector<Stage> shape_stages() {
    const std::string labels = character_path + "labels.png";
    return {
        {"find", {page_file}, {"found.json"}, find, Stage::found_by_network},
        {"detect",
         {page_file},
         {"page.json", "trace/ink.png", character_path + "drawing.png", character_path + "mask.png"},
         detect_characters},
        {"segment",
         {character_path + "drawing.png", character_path + "mask.png"},
         {trace_path + "probabilities.json", character_path + "segmentation.json", labels},
         segment},
        {"contour", {labels}, {trace_path + "silhouette.png", character_path + "contour.json"}, contour},
        {"voronoi", {labels}, {trace_path + "voronoi.json", trace_path + "voronoi.png"}, voronoi},
        {"thin",
         {trace_path + "voronoi.png", trace_path + "silhouette.png"},
         {trace_path + "thinned.png", trace_path + "thinned-silhouette.png"},
         thin},
        {"reduce",
         {trace_path + "thinned.png", trace_path + "thinned-silhouette.png"},
         {character_path + "skeleton.png", trace_path + "reduced-silhouette.png"},
         reduce},
        {"graph", {character_path + "skeleton.png", labels}, {trace_path + "skeleton-raw.json"}, graph},
        {"h1", {trace_path + "skeleton-raw.json"}, {trace_path + "skeleton-h1.json"}, h1},
        {"h2", {trace_path + "skeleton-h1.json", labels}, {character_path + "skeleton.json"}, h2},
        {"skeletonize",
         {labels},
         {trace_path + "thinned.png", character_path + "skeleton.png", trace_path + "skeleton-raw.json",
          trace_path + "skeleton-h1.json", character_path + "skeleton.json"},
         skeleton},
    };
}

} // namespace pantin
