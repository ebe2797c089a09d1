// SPDX-License-Identifier: MIT
// The drawings of testdata/ and what each step made of them, computed once when it is first asked for.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pantin/pipeline.hpp"

namespace pantin::figures {

// One character through all steps.
struct Run {
    DetectedCharacter detected;
    Segmentation segmentation;
    Skeletonization skeleton;
    Identification identification;
    Rig rig;
    const ReferenceSkeleton* reference = nullptr; // that identification chose

    const LabelMap& labels() const { return segmentation.labels; }
    const Candidate& candidate() const; // of that reference
};

class Gallery {
public:
    explicit Gallery(std::string folder)
        : folder_(std::move(folder)), references_(load_references()),
          thesis_references_(load_references({}, ClipSet::thesis)) {}

    Networks& networks() { return networks_; }
    const std::vector<ReferenceSkeleton>& references() const { return references_; }
    const ReferenceSkeleton& reference(const std::string& name) const;

    // A picture of the folder.
    const RgbImage& page(const std::string& file);
    // Its characters, detected by the network.
    const Detection& detection(const std::string& file);
    // Number `index` of them through all steps of the preset "default" or "thesis". Both share detection and
    // segmentation of the default preset, at its working size.
    const Run& run(const std::string& file, std::size_t index = 0, const std::string& preset = "default");
    // A label map of the folder.
    LabelMap labels(const std::string& file) const;

    // The largest character of a picture through all steps of the preset, detection and segmentation too, as
    // `pantin animate --preset` takes them; clips are the preset's.
    Run whole_run(const RgbImage& picture, const std::string& preset);
    // The steps after segmentation anew, for parts that were corrected by hand.
    Run with_labels(Run run, const LabelMap& labels, const std::string& preset) const;

private:
    const Run& segmented(const std::string& file, std::size_t index);
    const std::vector<ReferenceSkeleton>& references_of(const std::string& preset) const;

    std::string folder_;
    Networks networks_;
    std::vector<ReferenceSkeleton> references_, thesis_references_; // these with the clips of thesis 6.1
    std::map<std::string, RgbImage> pages_;
    std::map<std::string, Detection> detections_;
    std::map<std::string, Run> segmented_, runs_;
};

} // namespace pantin::figures
