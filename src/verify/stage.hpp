// SPDX-License-Identifier: MIT
// The stages of the pipeline as rows of the verification: each one a call of public step functions, files in
// and files out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pantin/verify.hpp"

namespace pantin {

// The drawings, columns of the table. What the network costs is most of the time, so the features are shared
// out: of `default` one drawing is seen in several views, two are found by the network and one by the
// contour-based detector, one becomes a solid. Those of `thesis` are what its steps can stumble on: a
// silhouette with a hole, an end-effector without a partner, legs that cross.
struct VerifiedDrawing {
    std::string name;
    std::string folder; // of its files
    Detector detector = Detector::mask_rcnn;
    bool several_views = false;
    bool solid = false;
    int probability_step = 8; // of the stored probabilities
};
// Error(usage) when the preset has none.
const std::vector<VerifiedDrawing>& verified_drawings(std::string_view preset);

// What a stage works with.
struct StageContext {
    const VerifiedDrawing& drawing;
    const Options& options; // with the drawing's detector and views
    int threads;
    Networks& networks;
    const std::vector<ReferenceSkeleton>& references;
    const Files& files; // the input

    // The file of the drawing's folder. Error(input) when it is missing.
    const std::string& text(const std::string& name) const;
    RgbImage picture(const std::string& name) const;
    GreyImage grey(const std::string& name) const;
    Mask mask(const std::string& name) const; // 1 where the file is not 0
};

struct Stage {
    std::string name;                 // row of the table
    std::vector<std::string> inputs;  // files of the drawing's folder that it reads …
    std::vector<std::string> outputs; // … and makes
    Files (*run)(const StageContext& context);
    enum { every, found_by_network, solid } drawings = every;

    bool is_for(const VerifiedDrawing& drawing) const {
        return drawings == every ||
               (drawings == solid ? drawing.solid : drawing.detector == Detector::mask_rcnn);
    }
};
// In the order of the flow.
const std::vector<Stage>& verified_stages();
std::vector<Stage> shape_stages();  // page to skeleton graph
std::vector<Stage> motion_stages(); // skeleton graph to files for other programs
std::vector<Stage> solid_stages();  // labels to a rigged solid

// Names in a drawing's folder, which is laid out as the output of `pantin animate --trace`.
inline const std::string character_path = "character-1/";
inline const std::string trace_path = character_path + "trace/";
inline const std::string model_path = character_path + "model/";

std::string png(const GreyImage& image);
std::string png(const RgbImage& image);
std::string png(const RgbaImage& image);

} // namespace pantin
