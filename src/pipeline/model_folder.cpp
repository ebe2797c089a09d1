// SPDX-License-Identifier: MIT
// pantin model: strokes, or the parts of a scanned drawing, to a model's folder.
#include <algorithm>

#include "core/file.hpp"
#include "formats/file_names.hpp"
#include "formats/model_file.hpp"
#include "formats/pictures.hpp"
#include "formats/skeleton_file.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/pipeline.hpp"
#include "pipeline/context.hpp"
#include "pipeline/drawing_look.hpp"
#include "pipeline/looked_at.hpp"
#include "pipeline/model_sheet.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// What is known before the model is built.
struct Source {
    Strokes strokes;
    std::optional<ModelPicture> picture; // of a scanned drawing, with the view that shows it as it is
    bool painted = false;                // the strokes' painting is what the model is coloured with
};

Source from_character(const fs::path& folder) {
    const LabelMap labels = read_labels(folder, read_mask(folder));
    return {strokes_from_labels(labels), ModelPicture{read_drawing(folder), labels}, false};
}

Strokes from_file(const fs::path& file) {
    const std::string text = read_text(file);
    if (text.starts_with("\x1f\x8b"))
        throw Error(ErrorKind::input,
                    file.string() + ": is compressed (gzip); gunzip makes an .svg file of it");
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (ending == ".svg") return strokes_from_svg(text, file.string());
    if (ending == ".json") return strokes_from_json(text, file.string());
    throw Error(ErrorKind::input,
                file.string() + ": must be a .json or .svg file of strokes, or a character's folder");
}

Source source_of(const fs::path& input) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored)) return from_character(input);
    return {from_file(input), std::nullopt, false};
}

// The painting as the view shows it, twice as large as the view.
RgbImage painted(const Strokes& strokes, const ModelView& view, const LabelMap& labels) {
    constexpr int finer = 2;
    CanvasView canvas;
    canvas.scale = finer * view.scale;
    canvas.offset =
        finer * (view.offset - view.scale * strokes.origin + Point2d{0.5, 0.5}) - Point2d{0.5, 0.5};
    const RgbaImage figure = paint(strokes.painting, canvas, finer * view.width, finer * view.height);
    RgbImage drawing(figure.width(), figure.height(), Rgb8{255, 255, 255});
    for (std::size_t i = 0; i < drawing.size(); ++i)
        if (const Rgba8 p = figure.data()[i]; is_opaque(p)) drawing.data()[i] = {p.r, p.g, p.b};
    return without_paper(std::move(drawing), opaque_pixels(figure), labels);
}

Model build(const Strokes& strokes, const std::string& name, const ModelOptions& options) {
    try {
        Model model(strokes, options);
        if (model.parts().empty())
            throw Error(ErrorKind::input, "no part is left, there is nothing to model");
        return model;
    } catch (const Error& error) {
        throw Error(error.kind(), name + ": " + error.what());
    }
}

// What names leave open the part network tells. Strokes without a painting are checked as a model first, so
// that what is wrong with a stroke is said of it.
void look_at_parts(Source& source, const fs::path& input, const Settings& settings) {
    if (source.picture) return;
    if (!needs_a_look(source.strokes)) {
        if (std::optional<LabelledStrokes> drawn = with_decoration(source.strokes))
            source = {std::move(drawn->strokes), std::nullopt, true};
        return;
    }
    std::vector<std::string> repairs;
    if (source.strokes.painting.empty())
        repairs = build(source.strokes, input.string(), settings.options.modeling).repairs();
    Context context(settings);
    LabelledStrokes labelled = labelled_by_look(source.strokes, input.string(), context);
    source = {std::move(labelled.strokes), std::move(labelled.picture), labelled.painted};
    std::vector<std::string>& lines = source.strokes.repairs;
    if (source.picture) lines.insert(lines.end(), repairs.begin(), repairs.end());
}

} // namespace

void model_folder(const fs::path& input, const fs::path& out, const fs::path& calls,
                  const Settings& settings) {
    const auto progress = [&](const char* what, double share) {
        if (settings.progress) settings.progress(what, share);
    };
    progress("strokes", 0);
    Source source = source_of(input);
    if (!calls.empty())
        source.strokes = with_calls(std::move(source.strokes), read_text(calls), calls.string());
    look_at_parts(source, input, settings);
    progress("model", 0.1);
    Model model = build(source.strokes, input.string(), settings.options.modeling);
    progress("union", 0.3);
    const SolidMesh mesh = model.united();
    ModelView view;
    const bool projected = source.picture.has_value() || source.painted;
    if (source.picture) {
        view.width = source.picture->labels.width();
        view.height = source.picture->labels.height();
    } else {
        view = view_of(model, mesh);
        source.picture = draw(model, view);
        if (source.painted) source.picture->drawing = painted(source.strokes, view, source.picture->labels);
    }
    progress("weights", 0.6);
    const Rig rig = model_rig(model, mesh, view, projected ? std::vector<Rgb8>{} : part_colours(model, mesh));
    const RgbaImage texture = make_solid_texture(source.picture->drawing, source.picture->labels);
    if (settings.notice) {
        for (const std::string& repair : source.strokes.repairs)
            settings.notice(input.string() + ": " + repair);
        for (const std::string& repair : model.repairs()) settings.notice(input.string() + ": " + repair);
        for (const std::string& line : oddities_of(model, mesh))
            settings.notice(input.string() + ": " + line);
    }
    progress("files", 0.9);
    create_folder(out);
    write_file(out / file_names::strokes, strokes_to_json(source.strokes));
    write_file(out / file_names::model, model_to_json(model, view, projected));
    write_file(out / file_names::model_mesh, to_obj(rig, file_names::model_material));
    write_file(out / file_names::model_material, to_mtl(file_names::drawing));
    write_file(out / file_names::model_glb, to_glb(rig, texture, {}));
    save_png(out / file_names::model_views, model_sheet(rig, texture, model, view));
    save_png(out / file_names::drawing, source.picture->drawing);
    save_png(out / file_names::labels, source.picture->labels);
    save_png(out / file_names::mask, to_grey(foreground(source.picture->labels)));
    write_file(out / file_names::skeleton, skeleton_to_json(project_skeleton(model, view)));
}

} // namespace pantin
