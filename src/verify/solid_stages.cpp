// SPDX-License-Identifier: MIT
// The stages of the module `modeling`: the parts of a drawing to strokes, a skeleton in space, an inflated
// part, one closed surface and its weights.
#include "formats/file_names.hpp"
#include "formats/model_file.hpp"
#include "pantin/export.hpp"
#include "pantin/model_view.hpp"
#include "verify/stage.hpp"
#include "verify/step_files.hpp"

namespace pantin {

namespace {

const std::string labels_file = character_path + file_names::labels,
                  strokes_file = model_path + file_names::strokes,
                  model_file = model_path + file_names::model, solid_file = model_path + "solid.json";

Strokes strokes_of(const StageContext& c) { return strokes_from_json(c.text(strokes_file), strokes_file); }

Files strokes(const StageContext& c) {
    return {{strokes_file, strokes_to_json(strokes_from_labels(c.grey(labels_file)))}};
}

Files model_skeleton(const StageContext& c) {
    const LabelMap labels = c.grey(labels_file);
    ModelView view;
    view.width = labels.width();
    view.height = labels.height();
    return {{model_file, model_to_json(Model(strokes_of(c), c.options.modeling), view, true)}};
}

// Of the first part, the body.
Files inflation(const StageContext& c) {
    const PartStroke body = std::get<PartStroke>(strokes_of(c).calls.at(0));
    return {{model_path + "inflation.json",
             inflation_to_json(inflate(body.stroke, c.options.modeling.inflation))}};
}

Files united(const StageContext& c) {
    return {{solid_file, solid_to_json(Model(strokes_of(c), c.options.modeling).united())}};
}

Files heat(const StageContext& c) {
    const std::vector<BoneSegment> segments = segments_from_json(c.text(model_file), model_file);
    Rig rig;
    for (std::size_t b = 0; b < segments.size(); ++b) {
        rig.bones.emplace_back();
        rig.bones.back().name = "bone-" + std::to_string(b);
    }
    rig.weights = bone_heat(solid_from_json(c.text(solid_file), solid_file), segments);
    return {{model_path + "bone-heat.txt", to_weights_text(rig)}};
}

} // namespace

std::vector<Stage> solid_stages() {
    return {
        {"strokes", {labels_file}, {strokes_file}, strokes, Stage::solid},
        {"model", {strokes_file, labels_file}, {model_file}, model_skeleton, Stage::solid},
        {"inflate", {strokes_file}, {model_path + "inflation.json"}, inflation, Stage::solid},
        {"unite", {strokes_file}, {solid_file}, united, Stage::solid},
        {"bone heat", {model_file, solid_file}, {model_path + "bone-heat.txt"}, heat, Stage::solid},
    };
}

} // namespace pantin
