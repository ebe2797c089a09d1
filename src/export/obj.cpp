// SPDX-License-Identifier: MIT
// Wavefront OBJ and MTL, and the weights as text: what the thesis hands to Blender (ch. 5).
//
// The mesh is in world units (include/pantin/animation.hpp); z is the small offset that gives the draw order
// of the parts. Faces of the rig run clockwise on the screen; here they run counter-clockwise, so that they
// face +z.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/decimal.hpp"
#include "pantin/export.hpp"

namespace pantin {

namespace {

std::string vertex_line(const Rig& rig, std::size_t i) {
    const double depth = i < rig.depth.size() ? rig.depth[i] : 0;
    const Vec3 v = to_world(rig.mesh.vertices[i], rig.width, rig.height, depth);
    std::string line = "v " + to_decimal(v.x) + " " + to_decimal(v.y) + " " + to_decimal(v.z);
    if (!rig.colours.empty()) // of the vertex, sRGB, as MeshLab and Blender read it
        for (const std::uint8_t c : {rig.colours[i].r, rig.colours[i].g, rig.colours[i].b})
            line += " " + to_decimal(std::rint(c / 255.0 * 1000) / 1000);
    return line + "\n";
}

std::string face_line(const std::vector<int>& face) {
    std::string line = "f";
    for (auto corner = face.rbegin(); corner != face.rend(); ++corner) {
        const std::string index = std::to_string(*corner + 1);
        line += " " + index + "/" + index;
    }
    return line + "\n";
}

} // namespace

std::string to_obj(const Rig& rig, const std::string& mtl_file) {
    std::string text = "# pantin mesh 1\nmtllib " + mtl_file + "\no character\n";
    for (std::size_t i = 0; i < rig.mesh.vertices.size(); ++i) text += vertex_line(rig, i);
    // v runs up in OBJ.
    for (const Point2d t : rig.texture) text += "vt " + to_decimal(t.x) + " " + to_decimal(1 - t.y) + "\n";
    text += "usemtl drawing\n";
    for (const std::vector<int>& face : rig.mesh.faces) text += face_line(face);
    return text;
}

std::string to_mtl(const std::string& texture_file) {
    return "# pantin material 1\nnewmtl drawing\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 0\nmap_Kd " +
           texture_file + "\n";
}

std::string to_weights_text(const Rig& rig) {
    std::string text = "# pantin weights 1\n";
    for (std::size_t b = 0; b < rig.bones.size(); ++b)
        text += "bone " + std::to_string(b) + " " + rig.bones[b].name + "\n";
    for (std::size_t v = 0; v < rig.weights.size(); ++v) {
        text += "v " + std::to_string(v + 1);
        for (std::size_t k = 0; k < 4; ++k)
            if (rig.weights[v].weights[k] > 0)
                text += " " + std::to_string(rig.weights[v].bones[k]) + " " +
                        to_decimal(rig.weights[v].weights[k]);
        text += "\n";
    }
    return text;
}

} // namespace pantin
