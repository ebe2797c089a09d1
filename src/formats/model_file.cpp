// SPDX-License-Identifier: MIT
// A model with the view of its pictures to the text of model.json; a model's folder to the solid it describes
// (RealSkel).
#include "formats/model_file.hpp"

#include "core/file.hpp"
#include "formats/file_names.hpp"
#include "formats/json_values.hpp"

namespace pantin {
namespace {

Json part_to_json(const Model& model, std::size_t index) {
    const ModelPart& part = model.parts()[index];
    const Attachment& attachment = model.connection().attachments[index];
    Json json;
    json["name"] = part.name();
    json["label"] = name_of(label_of(part));
    if (part.parent < 0) {
        json["event"] = "root";
    } else {
        json["parent"] = model.parts()[part.parent].name();
        json["event"] = attachment.split ? "bone split" : "joint connect";
    }
    json["branches"] = part.flat.branches.size();
    return json;
}

} // namespace

std::string model_to_json(const Model& model, const ModelView& view, bool projected) {
    Json json;
    json["view"] = {{"width", view.width},
                    {"height", view.height},
                    {"scale", view.scale},
                    {"offset", {view.offset.x, view.offset.y}},
                    {"shear", {view.shear.x, view.shear.y}}};
    json["texture"] = projected ? "drawing" : "parts";
    json["parts"] = Json::array();
    for (std::size_t p = 0; p < model.parts().size(); ++p) json["parts"].push_back(part_to_json(model, p));
    json["joints"] = Json::array();
    for (const ModelSkeleton::Joint& joint : model.skeleton().joints) {
        Json j;
        j["place"] = {joint.place.x, joint.place.y, joint.place.z};
        j["radius"] = joint.radius;
        j["part"] = model.parts()[joint.part].name();
        if (joint.parent >= 0) j["parent"] = joint.parent;
        json["joints"].push_back(j);
    }
    json["repairs"] = model.repairs();
    return to_json_text(json);
}

SeenFrom view_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader = JsonReader(json, file).at("view");
    ModelView view;
    view.width = read_int(reader.at("width"), 1, max_side);
    view.height = read_int(reader.at("height"), 1, max_side);
    view.scale = reader.at("scale").number(1e-12, huge);
    const auto pair = [&](const char* key) {
        const std::vector<JsonReader> xy = reader.at(key).elements(2, 2);
        return Point2d{xy[0].number(-huge, huge), xy[1].number(-huge, huge)};
    };
    view.offset = pair("offset");
    view.shear = pair("shear");
    const JsonReader texture = JsonReader(json, file).at("texture");
    if (texture.text() != "drawing" && texture.text() != "parts") texture.fail("must be drawing or parts");
    return {view, texture.text() == "drawing"};
}

bool is_model_folder(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::exists(folder / file_names::strokes, ignored);
}

Solid read_solid(const std::filesystem::path& folder, const ModelOptions& options) {
    const std::filesystem::path strokes = folder / file_names::strokes, file = folder / file_names::model;
    Model model(strokes_from_json(read_text(strokes), strokes.string()), options);
    SolidMesh mesh = model.united();
    const SeenFrom seen = view_from_json(read_text(file), file.string());
    std::vector<Rgb8> colours;
    if (!seen.projected) colours = part_colours(model, mesh);
    return {std::move(model), std::move(mesh), seen.view, std::move(colours)};
}

} // namespace pantin
