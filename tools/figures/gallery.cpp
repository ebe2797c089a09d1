// SPDX-License-Identifier: MIT
// Names of pictures in testdata/ in, what each step makes of them out, once each.
#include "figures/gallery.hpp"

#include <algorithm>

#include "pantin/image.hpp"
#include "pipeline/segmentation_options.hpp"

namespace pantin::figures {

namespace {

Options options_of(const std::string& preset) {
    Options options = make_preset(preset);
    options.identification.solver = GgdSolver::branch_and_bound; // builds without GLPK draw the same
    return options;
}

// The steps from skeletonization on. `seen`: what the network says of the type.
void finish(Run& run, const Options& options, const std::vector<ReferenceSkeleton>& references,
            const TypeProbabilities& seen) {
    run.skeleton = skeletonize(run.labels(), options.skeletonization);
    run.identification = identify(run.skeleton.graph, run.labels(), references, options.identification, seen);
    run.rig = rig(run.skeleton.graph, run.labels(), run.identification, references, options.rigging);
    run.reference = &find_reference(references, run.identification.reference);
}

} // namespace

const Candidate& Run::candidate() const {
    return *std::find_if(identification.candidates.begin(), identification.candidates.end(),
                         [this](const Candidate& c) { return c.reference == identification.reference; });
}

const ReferenceSkeleton& Gallery::reference(const std::string& name) const {
    return *std::find_if(references_.begin(), references_.end(),
                         [&](const ReferenceSkeleton& r) { return r.name == name; });
}

const RgbImage& Gallery::page(const std::string& file) {
    const auto [it, is_new] = pages_.try_emplace(file);
    if (is_new) it->second = load_image(folder_ + "/" + file);
    return it->second;
}

LabelMap Gallery::labels(const std::string& file) const { return load_grey(folder_ + "/" + file); }

const Detection& Gallery::detection(const std::string& file) {
    const auto [it, is_new] = detections_.try_emplace(file);
    if (is_new) it->second = detect(page(file), {}, &networks_.finder());
    return it->second;
}

const Run& Gallery::segmented(const std::string& file, std::size_t index) {
    const auto [it, is_new] = segmented_.try_emplace(file + " " + std::to_string(index));
    Run& run = it->second;
    if (is_new) {
        run.detected = detection(file).characters.at(index);
        run.segmentation = networks_.segmenter().segment(run.detected.ink, run.detected.mask);
    }
    return run;
}

const Run& Gallery::run(const std::string& file, std::size_t index, const std::string& preset) {
    const auto [it, is_new] = runs_.try_emplace(file + " " + std::to_string(index) + " " + preset);
    Run& run = it->second;
    if (is_new) {
        run = segmented(file, index);
        finish(run, options_of(preset), references_, {});
    }
    return run;
}

const std::vector<ReferenceSkeleton>& Gallery::references_of(const std::string& preset) const {
    return preset == "thesis" ? thesis_references_ : references_;
}

Run Gallery::whole_run(const RgbImage& picture, const std::string& preset) {
    const Options options = options_of(preset);
    Run run;
    const auto size = [](const DetectedCharacter& c) { return std::max(c.box.width, c.box.height); };
    std::vector<DetectedCharacter> found = detect(picture, options.detection, &networks_.finder()).characters;
    run.detected = std::move(*std::max_element(
        found.begin(), found.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); }));
    run.segmentation =
        networks_.segmenter().segment(run.detected.ink, run.detected.mask,
                                      segmentation_options(run.detected.drawing, options.segmentation));
    finish(run, options, references_of(preset), run.segmentation.type);
    return run;
}

Run Gallery::with_labels(Run run, const LabelMap& labels, const std::string& preset) const {
    run.segmentation.labels = labels;
    finish(run, options_of(preset), references_of(preset), run.segmentation.type);
    return run;
}

} // namespace pantin::figures
