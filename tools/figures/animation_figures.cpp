// SPDX-License-Identifier: MIT
// Skin weights and the animated model (thesis 4.6, Algorithm 4.4 and Fig. 4.19).
#include <algorithm>
#include <cmath>

#include "figures/figures.hpp"
#include "figures/palette.hpp"
#include "figures/panel.hpp"
#include "figures/rendering.hpp"
#include "pantin/image.hpp"
#include "rigging/mesh_topology.hpp"

namespace pantin::figures {
namespace {

constexpr const char* files[] = {"dog.png", "humanoid.png", "flying.png"};

// Weight of all bones of the limb of that name.
double limb_weight(const Rig& rig, const VertexWeights& w, const std::string& limb) {
    double sum = 0;
    for (int k = 0; k < 4; ++k)
        if (rig.bones[w.bones[k]].name.substr(0, limb.size()) == limb) sum += w.weights[k];
    return sum;
}

// Faces by the mean weight of their corners, in nine shades.
void draw_weights(Sheet& sheet, int index, const Rig& rig, const std::string& limb,
                  const std::string& caption) {
    constexpr int shades = 8;
    Panel panel(sheet.svg(), sheet[index], rig.width, rig.height);
    std::vector<Mesh> shade(shades + 1, Mesh{rig.mesh.vertices, {}});
    for (const std::vector<int>& face : rig.mesh.faces) {
        double mean = 0;
        for (const int v : face)
            mean += limb_weight(rig, rig.weights[v], limb) / static_cast<double>(face.size());
        shade[static_cast<std::size_t>(std::rint(shades * mean))].faces.push_back(face);
    }
    for (int s = 0; s <= shades; ++s)
        if (!shade[s].faces.empty())
            panel.mesh(shade[s],
                       outlined(mixed({238, 240, 244}, {20, 120, 60}, static_cast<double>(s) / shades),
                                {150, 154, 162}, 0.35));
    std::vector<std::pair<Point2d, Point2d>> bones;
    for (const Bone& bone : rig.bones)
        if (bone.name.substr(0, limb.size()) == limb) bones.push_back({bone.head, bone.tail});
    panel.segments(bones, {.stroke = css(accent), .width = 3, .cap = "round"});
    for (const auto& [head, tail] : bones) sheet.svg().circle(panel.at(head), 4, filled(accent));
    panel.caption(caption);
}

// Of the limb that leaves the body farthest to the left.
std::string leftmost_limb(const Rig& rig) {
    const auto first = [](const Bone& bone) { return bone.label == Label::limb && bone.segment == 0; };
    const Bone* best = nullptr;
    for (const Bone& bone : rig.bones)
        if (first(bone) && (!best || bone.tail.x < best->tail.x)) best = &bone;
    return best->name;
}

Figure weights_figure(Gallery& gallery) {
    const Run &thesis = gallery.run("dog.png", 0, "thesis"), &ours = gallery.run("dog.png");
    Sheet sheet(2, 1, 440, 290, 24);
    std::vector<std::pair<std::string, Rgb8>> entries;
    for (const int share : {0, 25, 50, 75, 100})
        entries.emplace_back(std::to_string(share) + " %",
                             mixed({238, 240, 244}, {20, 120, 60}, share / 100.0));
    entries.emplace_back("the bones of this leg", accent);
    legend(sheet.svg(), {margin, 24}, entries);
    draw_weights(sheet, 0, thesis.rig, leftmost_limb(thesis.rig),
                 "(a) Algorithm 4.4: one bone, one weight σ");
    draw_weights(sheet, 1, ours.rig, leftmost_limb(ours.rig),
                 "(b) default: two bones, smooth weights, mesh cut between legs");
    return {"alg-4.4-weights.svg",
            sheet.svg().document("The weight of one leg's bones at every vertex of the mesh")};
}

// The drawing with the mesh on it.
void draw_model(Sheet& sheet, Rectangle place, const Run& run) {
    const Rig& rig = run.rig;
    Panel panel(sheet.svg(), place, rig.width, rig.height);
    panel.picture(run.detected.drawing, rig.width, rig.height);
    std::vector<std::pair<Point2d, Point2d>> edges;
    for (const auto& [u, v] : edges_of(rig.mesh))
        edges.emplace_back(rig.mesh.vertices[u], rig.mesh.vertices[v]);
    panel.segments(edges, stroked(second, 0.3));
}

Figure animation_figure(Gallery& gallery) {
    Sheet sheet(4, 3, 220, 190);
    for (int row = 0; row < 3; ++row) {
        const Run& run = gallery.run(files[row]);
        const std::string clip = run.reference->clips.front().name;
        draw_model(sheet, sheet.place(0, row), run);
        Rectangle film = sheet.place(1, row);
        caption(sheet.svg(), sheet.place(0, row),
                "(a) model: " + std::to_string(run.rig.mesh.faces.size()) + " faces, " +
                    std::to_string(run.rig.bones.size()) + " bones");
        film.width = 3 * 220 + 2 * margin;
        draw_film(sheet.svg(), film, run, clip, 3, 0.1);
        caption(sheet.svg(), film,
                "(b) " + run.identification.reference + ", clip “" + clip + "”: three of its poses");
    }
    return {"fig-4.19-animation.svg", sheet.svg().document("Models of three drawings, and their animation")};
}

} // namespace

std::vector<Figure> animation_figures(Gallery& gallery) {
    return {weights_figure(gallery), animation_figure(gallery)};
}

} // namespace pantin::figures
