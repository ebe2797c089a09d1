// SPDX-License-Identifier: MIT
// Names of pictures in testdata/ in, what each step makes of them out, once each.
#include "figures/gallery.hpp"

#include <algorithm>

#include "pantin/image.hpp"

namespace pantin::figures {

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
        Options options = make_preset(preset);
        options.identification.solver = GgdSolver::branch_and_bound; // builds without GLPK draw the same
        run = segmented(file, index);
        run.skeleton = skeletonize(run.labels(), options.skeletonization);
        run.identification = identify(run.skeleton.graph, run.labels(), references_, options.identification);
        run.rig = rig(run.skeleton.graph, run.labels(), run.identification, references_, options.rigging);
        run.reference = &reference(run.identification.reference);
    }
    return run;
}

} // namespace pantin::figures
