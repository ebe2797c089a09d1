// SPDX-License-Identifier: MIT
// Step 5, second half: the mesh by marching squares, bones and skin weights.
#include <algorithm>

#include "core/json.hpp"
#include "explain/chapters.hpp"
#include "explain/palette.hpp"
#include "explain/svg.hpp"

namespace pantin {

namespace {

constexpr double border_width = 0.25; // of faces, in thin lines

std::vector<Point2d> corners(const Mesh& mesh, const std::vector<int>& face) {
    std::vector<Point2d> points;
    for (const int v : face) points.push_back(mesh.vertices[v]);
    return points;
}

Rgb8 case_colour(int number) {
    return number == 15 ? Rgb8{205, 213, 225} : category(static_cast<std::size_t>(number));
}

// A voxel with its inside corners marked, as it stands in the legend.
std::string case_icon(int number) {
    Svg icon(20, 20, "case " + std::to_string(number), 4);
    icon.raw("<rect x=\"0\" y=\"0\" width=\"20\" height=\"20\" fill=\"" + css(case_colour(number)) + "\"/>");
    constexpr Point2d places[] = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    for (int i = 0; i < 4; ++i)
        icon.raw("<circle cx=\"" + decimal(places[i].x) + "\" cy=\"" + decimal(places[i].y) +
                 "\" r=\"3.5\" stroke=\"#111\" fill=\"" + (number >> i & 1 ? "#111" : "#fff") + "\"/>");
    return icon.str("icon");
}

std::string legend(const Mesh& mesh) {
    std::string text;
    for (int number = 1; number <= 15; ++number) {
        const auto count = std::count(mesh.cases.begin(), mesh.cases.end(), number);
        if (count > 0)
            text += "<li>" + case_icon(number) + "<span>case " + std::to_string(number) + ": " +
                    std::to_string(count) + "</span></li>";
    }
    return text;
}

void draw_bones(Svg& svg, const std::vector<Bone>& bones, double scale) {
    for (std::size_t b = 0; b < bones.size(); ++b) {
        svg.line(bones[b].head, bones[b].tail, "#fff", 4 * scale)
            .line(bones[b].head, bones[b].tail, css(category(b)), 2.4 * scale);
        svg.disc(bones[b].head, 3 * scale, css(category(b)));
    }
}

// Colours of the bones, mixed by the weights of a face's corners.
Rgb8 mixed(const Rig& rig, const std::vector<int>& face) {
    double r = 0, g = 0, b = 0;
    for (const int v : face)
        for (int k = 0; k < 4; ++k) {
            const Rgb8 c = category(static_cast<std::size_t>(rig.weights[v].bones[k]));
            const double w = rig.weights[v].weights[k] / static_cast<double>(face.size());
            r += w * c.r, g += w * c.g, b += w * c.b;
        }
    const auto byte = [](double v) {
        return static_cast<std::uint8_t>(std::rint(std::clamp(v, 0.0, 255.0)));
    };
    return {byte(r), byte(g), byte(b)};
}

Json weights_data(const Rig& rig) {
    Json faces = Json::array(); // corners of each face, in the order of the picture's paths
    for (const auto& face : rig.mesh.faces) faces.push_back(face);
    Json weights = Json::array(); // per vertex: bone, weight in thousandths, …
    for (const VertexWeights& w : rig.weights) {
        Json entry = Json::array();
        for (int k = 0; k < 4; ++k)
            if (w.weights[k] > 0)
                entry.push_back(w.bones[k]), entry.push_back(std::lrint(1000 * w.weights[k]));
        weights.push_back(std::move(entry));
    }
    return {{"faces", std::move(faces)}, {"weights", std::move(weights)}};
}

} // namespace

Values mesh_chapter(const ChapterInput& input) {
    const Rig& rig = input.character.rig;
    const double thin = border_width * input.line();
    Svg picture(rig.width, rig.height, "The mesh, every face in the colour of its marching squares case",
                ink_margin(rig.width, rig.height));
    picture.underlay(input.drawing(), 0.5).raw("<g fill-opacity=\".72\">");
    for (std::size_t f = 0; f < rig.mesh.faces.size(); ++f)
        picture.polygon(corners(rig.mesh, rig.mesh.faces[f]),
                        css(case_colour(f < rig.mesh.cases.size() ? rig.mesh.cases[f] : 15)), "#333", thin);
    picture.raw("</g>");
    const auto cut =
        std::count_if(rig.mesh.cases.begin(), rig.mesh.cases.end(), [](int c) { return c != 15; });
    return {{"picture", picture.str()},
            {"legend", legend(rig.mesh)},
            {"faces", std::to_string(rig.mesh.faces.size())},
            {"vertices", std::to_string(rig.mesh.vertices.size())},
            {"cut", std::to_string(cut)}};
}

Values weights_chapter(const ChapterInput& input) {
    const Rig& rig = input.character.rig;
    Svg picture(rig.width, rig.height,
                "The mesh in the mixed colours of the bones that move it, and the bones",
                ink_margin(rig.width, rig.height));
    picture.underlay(input.drawing(), 0.4).raw("<g class=\"faces\" fill-opacity=\".7\">");
    for (const auto& face : rig.mesh.faces)
        picture.polygon(corners(rig.mesh, face), css(mixed(rig, face)), "none", 0);
    picture.raw("</g>");
    draw_bones(picture, rig.bones, input.line());
    std::string options, list;
    for (std::size_t b = 0; b < rig.bones.size(); ++b) {
        const std::string name = escaped(rig.bones[b].name);
        options += "<option value=\"" + std::to_string(b) + "\">" + name + "</option>";
        list += "<li><span class=\"swatch\" style=\"background:" + css(category(b)) + "\"></span>" + name +
                (rig.bones[b].parent < 0 ? " (root)"
                                         : " — hangs on " + escaped(rig.bones[rig.bones[b].parent].name)) +
                "</li>";
    }
    return {{"picture", picture.str("weights")},
            {"data", script_json(weights_data(rig))},
            {"options", options},
            {"bones", list},
            {"count", std::to_string(rig.bones.size())}};
}

} // namespace pantin
