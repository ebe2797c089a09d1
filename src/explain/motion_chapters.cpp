// SPDX-License-Identifier: MIT
// Step 6, and beyond the plane: the clips on the character, flat and inflated.
#include <algorithm>

#include "core/json.hpp"
#include "core/plural.hpp"
#include "explain/chapters.hpp"
#include "explain/picture_size.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pipeline/film.hpp"

namespace pantin {

namespace {

constexpr int film_side = 280;
constexpr double film_fps = 12.5;

std::string glb_uri(const Rig& rig, const RgbaImage& texture, const std::vector<BoneAnimation>& animations) {
    return data_uri("model/gltf-binary", to_glb(rig, texture, animations));
}

// The first clip as a small film that needs no script; nothing when this program writes no such films.
std::string film_uri(const Rig& rig, const RgbaImage& texture, const std::vector<BoneAnimation>& animations,
                     const ChapterInput& input) {
    Settings settings = input.context.settings();
    settings.render.fps = film_fps;
    settings.render.picture = {};
    settings.render.picture.size = film_side;
    settings.render.picture.background = {255, 255, 255, 255};
    std::vector<BoneAnimation> filmed;
    std::transform(animations.begin(), animations.end(), std::back_inserter(filmed), as_filmed);
    const Film film = render_film(rig, filmed.front(), texture, view_of(rig, filmed), settings);
    if (webp_available())
        return data_uri("image/webp", encode_webp(film.frames, film.fps, {}, settings.threads));
    return data_uri("image/apng", encode_apng(film.frames, film.fps, settings.threads));
}

std::string clip_options(const std::vector<BoneAnimation>& animations) {
    std::string text;
    for (const BoneAnimation& a : animations) text += "<option>" + escaped(a.name) + "</option>";
    return text;
}

std::string film_element(const std::string& uri, const std::string& name) {
    return "<img class=\"film\" alt=\"The character playing its clip " + escaped(name) + "\" src=\"" + uri +
           "\">";
}

Json viewer_data(const std::string& glb, const Rig& rig) {
    Json data;
    data["glb"] = glb;
    data["width"] = rig.width;
    data["height"] = rig.height;
    return data;
}

} // namespace

Values motion_chapter(const ChapterInput& input) {
    const Character& character = input.character;
    const Rig& rig = character.rig;
    const std::vector<BoneAnimation>& animations = character.animations;
    if (animations.empty())
        return {
            {"film", "<p>The reference has no clips.</p>"}, {"clips", ""}, {"data", "null"}, {"facts", ""}};
    const RgbaImage texture =
        make_texture(small_drawing(character), small_ink(character), character.segmentation.labels);
    std::string facts;
    for (const BoneAnimation& a : animations)
        facts += "<tr><td>" + escaped(a.name) + "</td><td>" + decimal(a.duration, 2) + "</td><td>" +
                 decimal(a.ground_speed, 2) + "</td></tr>";
    return {{"film", film_element(film_uri(rig, texture, animations, input), animations.front().name)},
            {"clips", clip_options(animations)},
            {"data", script_json(viewer_data(glb_uri(rig, texture, animations), rig))},
            {"facts", facts}};
}

Values solid_chapter(const ChapterInput& input) {
    const Character& character = input.character;
    const LabelMap& labels = character.segmentation.labels;
    Model model(strokes_from_labels(labels), input.context.options().modeling);
    const SolidMesh mesh = model.united();
    ModelView view;
    view.width = labels.width();
    view.height = labels.height();
    const Rig rig = lifted(character.rig, model, mesh, view);
    // Feet keep the ground by the lifted bones, so clips are carried over to them anew.
    const std::vector<BoneAnimation> animations = make_animations(rig, character.reference, input.context);
    const RgbaImage texture = make_solid_texture(small_drawing(character), labels);
    Values values = {{"clips", clip_options(animations)},
                     {"parts", count_of(static_cast<long>(model.parts().size()), "part")},
                     {"triangles", std::to_string(mesh.triangles.size())},
                     {"vertices", std::to_string(mesh.vertices.size())},
                     {"data", script_json(viewer_data(glb_uri(rig, texture, animations), rig))}};
    values["film"] = animations.empty()
                         ? ""
                         : film_element(film_uri(rig, texture, animations, input), animations.front().name);
    return values;
}

} // namespace pantin
