// A model's folder: the model and how its pictures were taken.
#pragma once

#include <filesystem>

#include "pantin/model_view.hpp"

namespace pantin {

struct Solid {
    Model model;
    SolidMesh mesh;
    ModelView view;
};
// From strokes.json and the view of model.json. Error(input).
Solid read_solid(const std::filesystem::path& folder, const ModelOptions& options);

std::string model_to_json(const Model& model, const ModelView& view);
ModelView view_from_json(const std::string& text, const std::string& file);

} // namespace pantin
