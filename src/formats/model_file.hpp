// SPDX-License-Identifier: MIT
// model.json and strokes.json of a model's folder: the model and the view that its pictures show
// (docs/formats.md).
#pragma once

#include <filesystem>

#include "pantin/model_view.hpp"

namespace pantin {

struct Solid {
    Model model;
    SolidMesh mesh;
    ModelView view;
    std::vector<Rgb8> colours; // none: the drawing is projected on (a scanned character)
};
bool is_model_folder(const std::filesystem::path& folder); // has a strokes.json
// From strokes.json and the view of model.json. Error(input) names the file, the place and the fact.
Solid read_solid(const std::filesystem::path& folder, const ModelOptions& options);

std::string model_to_json(const Model& model, const ModelView& view, bool projected);
struct SeenFrom {
    ModelView view;
    bool projected = false; // the drawing is the texture
};
SeenFrom view_from_json(const std::string& text, const std::string& file);

} // namespace pantin
