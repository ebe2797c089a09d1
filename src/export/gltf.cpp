// SPDX-License-Identifier: MIT
// glTF 2.0 binary (Khronos Group 2021) with what importers need (docs/formats.md, "character.glb"): one
// skinned mesh at the scene root without transform, all joints below one root, end joints at the leaves, at
// most four influences that sum to one, an unlit double-sided material with the drawing embedded (of a solid:
// a lit one, and normals), one named animation per clip.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/json.hpp"
#include "core/math.hpp"
#include "export/glb_buffer.hpp"
#include "export/joints.hpp"
#include "pantin/export.hpp"
#include "pantin/image.hpp"
#include "pantin/version.hpp"

namespace pantin {

namespace {

// Negative zeros would only make files differ that mean the same.
float to_float(double value) { return static_cast<float>(value) + 0.0f; }
Json rounded(std::initializer_list<double> values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(static_cast<double>(to_float(value)));
    return list;
}
void append(std::vector<float>& to, std::initializer_list<double> values) {
    for (const double value : values) to.push_back(to_float(value));
}

// IEC 61966-2-1: sRGB to linear light, which vertex colours are given in.
double linear(std::uint8_t value) {
    const double x = value / 255.0;
    return x <= 0.04045 ? x / 12.92 : math::pow((x + 0.055) / 1.055, 2.4);
}

struct Influences {
    std::vector<std::array<std::uint16_t, 4>> joints;
    std::vector<float> weights; // 4 per vertex
};

// Largest weight first; the largest is what the others leave over of 1, so that the floats sum to 1.
void append_influences(const VertexWeights& vertex, Influences& out) {
    std::array<std::pair<float, int>, 4> four{};
    for (std::size_t k = 0; k < 4; ++k) {
        const float weight = to_float(vertex.weights[k]);
        if (weight <= 0) continue;
        const auto same = std::find_if(four.begin(), four.begin() + k, [&](auto& f) {
            return f.first > 0 && f.second == vertex.bones[k] + 1;
        });
        if (same != four.begin() + k)
            same->first += weight;
        else
            four[k] = {weight, vertex.bones[k] + 1};
    }
    std::stable_sort(four.begin(), four.end(), [](auto& a, auto& b) { return a.first > b.first; });
    const double others = static_cast<double>(four[1].first) + four[2].first + four[3].first;
    four[0].first = to_float(1 - others);
    std::array<std::uint16_t, 4> joints{};
    for (std::size_t k = 0; k < 4; ++k) {
        joints[k] = static_cast<std::uint16_t>(four[k].second);
        out.weights.push_back(four[k].first);
    }
    out.joints.push_back(joints);
}

// Fans, counter-clockwise seen from +z (faces of the rig run clockwise on the screen).
std::vector<std::uint32_t> triangulate(const Mesh& mesh) {
    std::vector<std::uint32_t> indices;
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 2; i < face.size(); ++i)
            for (const int corner : {face[0], face[i], face[i - 1]})
                indices.push_back(static_cast<std::uint32_t>(corner));
    return indices;
}

Json make_primitive(const Rig& rig, GlbBuffer& buffer) {
    std::vector<float> positions, texture, directions;
    std::vector<Vec3> places;
    Influences influences;
    for (std::size_t i = 0; i < rig.mesh.vertices.size(); ++i) {
        const double depth = i < rig.depth.size() ? rig.depth[i] : 0;
        const Vec3 v = to_world(rig.mesh.vertices[i], rig.width, rig.height, depth);
        places.push_back(v);
        append(positions, {v.x, v.y, v.z});
        append(texture, {rig.texture[i].x, rig.texture[i].y});
        append_influences(rig.weights[i], influences);
    }
    Json attributes;
    attributes["POSITION"] = buffer.add_floats(positions, "VEC3", gltf_array_buffer, true);
    if (rig.solid) {
        for (const Vec3& n : vertex_normals(rig.mesh, places)) append(directions, {n.x, n.y, n.z});
        attributes["NORMAL"] = buffer.add_floats(directions, "VEC3", gltf_array_buffer);
    }
    if (rig.colours.empty()) {
        attributes["TEXCOORD_0"] = buffer.add_floats(texture, "VEC2", gltf_array_buffer);
    } else {
        std::vector<float> colours;
        for (const Rgb8& c : rig.colours) append(colours, {linear(c.r), linear(c.g), linear(c.b)});
        attributes["COLOR_0"] = buffer.add_floats(colours, "VEC3", gltf_array_buffer);
    }
    attributes["JOINTS_0"] = buffer.add_joints(influences.joints);
    attributes["WEIGHTS_0"] = buffer.add_floats(influences.weights, "VEC4", gltf_array_buffer);
    const int indices = buffer.add_indices(triangulate(rig.mesh));
    return {{"attributes", attributes}, {"indices", indices}, {"material", 0}};
}

Json make_nodes(const std::vector<Joint>& joints) {
    // Node 0 is the mesh, node j + 1 joint j.
    Json nodes = Json::array({{{"name", "character"}, {"mesh", 0}, {"skin", 0}}});
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const Vec3 t = joints[j].translation;
        const Quaternion q = joints[j].rotation;
        Json node = {{"name", joints[j].name}};
        Json children = Json::array();
        for (std::size_t c = 0; c < joints.size(); ++c)
            if (joints[c].parent == static_cast<int>(j)) children.push_back(c + 1);
        if (!children.empty()) node["children"] = children;
        node["translation"] = rounded({t.x, t.y, t.z});
        node["rotation"] = rounded({q.x, q.y, q.z, q.w});
        nodes.push_back(node);
    }
    return nodes;
}

Json make_skin(const std::vector<Joint>& joints, GlbBuffer& buffer) {
    std::vector<float> matrices;
    Json indices = Json::array();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const auto matrix = inverse_bind_matrix(joints[j]);
        for (const float value : matrix) matrices.push_back(value + 0.0f);
        indices.push_back(j + 1);
    }
    const int accessor = buffer.add_floats(matrices, "MAT4", 0);
    return {{"name", "skeleton"}, {"inverseBindMatrices", accessor}, {"skeleton", 1}, {"joints", indices}};
}

// Key poses of one joint; the sign is chosen so that neighbours lie on one side and interpolation goes the
// short way.
std::vector<float> rotation_keys(const std::vector<Joint>& joints, std::size_t joint,
                                 const std::vector<Quaternion>& turns) {
    std::vector<float> keys;
    Quaternion last = joints[joint].rotation;
    for (const Quaternion& turn : turns) {
        Quaternion q = node_rotation(joints, joint, turn);
        if (q.x * last.x + q.y * last.y + q.z * last.z + q.w * last.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
        append(keys, {q.x, q.y, q.z, q.w});
        last = q;
    }
    return keys;
}

// The node's place when its bone is moved towards the viewer; empty where that is never so. Bones that have
// depths turn in the picture's plane only, so the viewer is in the same direction for all of them.
std::vector<float> depth_keys(const std::vector<Joint>& joints, std::size_t joint,
                              const BoneAnimation& animation) {
    if (animation.depths.empty()) return {};
    const std::vector<double>& own = animation.depths[joint - 1];
    const int parent = joints[joint].parent; // 0: the root on the ground
    const std::vector<double> none(own.size(), 0.0);
    const std::vector<double>& carried =
        parent > 0 ? animation.depths[static_cast<std::size_t>(parent) - 1] : none;
    if (own == carried) return {};
    std::vector<float> keys;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const Vec3 t = joints[joint].translation + Vec3{0, 0, own[i] - carried[i]};
        append(keys, {t.x, t.y, t.z});
    }
    return keys;
}

Json make_animation(const BoneAnimation& animation, const std::vector<Joint>& joints, GlbBuffer& buffer) {
    Json samplers = Json::array(), channels = Json::array();
    std::vector<float> times;
    for (const double time : animation.times) times.push_back(to_float(time));
    const int input = buffer.add_floats(times, "SCALAR", 0, true);
    const auto add = [&](std::size_t joint, const char* path, int output) {
        channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", joint + 1}, {"path", path}}}});
        samplers.push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
    };
    std::vector<float> translation;
    for (const Vec3& t : animation.root_translation) append(translation, {t.x, t.y, t.z});
    if (!translation.empty()) add(0, "translation", buffer.add_floats(translation, "VEC3", 0));
    for (std::size_t b = 0; b < animation.rotations.size(); ++b) {
        add(b + 1, "rotation",
            buffer.add_floats(rotation_keys(joints, b + 1, animation.rotations[b]), "VEC4", 0));
        if (const std::vector<float> keys = depth_keys(joints, b + 1, animation); !keys.empty())
            add(b + 1, "translation", buffer.add_floats(keys, "VEC3", 0));
    }
    return {{"name", animation.name}, {"samplers", samplers}, {"channels", channels}};
}

Json make_material(const Rig& rig) {
    if (!rig.colours.empty())
        return {{"name", "colours"},
                {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}};
    if (rig.solid)
        return {{"name", "drawing"},
                {"pbrMetallicRoughness",
                 {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}}};
    // MASK, not BLEND: overlapping limbs are sorted by depth in every viewer.
    return {{"name", "drawing"},
            {"pbrMetallicRoughness",
             {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
            {"alphaMode", "MASK"},
            {"alphaCutoff", 0.5},
            {"doubleSided", true},
            {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
}

} // namespace

std::vector<unsigned char> to_glb(const Rig& rig, const RgbaImage& texture,
                                  const std::vector<BoneAnimation>& animations) {
    GlbBuffer buffer;
    const std::vector<Joint> joints = make_joints(rig);
    const Json primitive = make_primitive(rig, buffer);
    const Json skin = make_skin(joints, buffer);
    Json clips = Json::array();
    for (const BoneAnimation& animation : animations)
        clips.push_back(make_animation(animation, joints, buffer));
    const bool textured = rig.colours.empty();
    const int image =
        textured ? buffer.add_bytes(encode_png(texture)) : -1; // last: its length is the encoder's

    Json gltf;
    gltf["asset"] = {{"version", "2.0"}, {"generator", "pantin " PANTIN_VERSION}};
    if (!rig.solid) gltf["extensionsUsed"] = Json::array({"KHR_materials_unlit"});
    gltf["scene"] = 0;
    gltf["scenes"] = Json::array({{{"name", "scene"}, {"nodes", {0, 1}}}});
    gltf["nodes"] = make_nodes(joints);
    gltf["meshes"] = Json::array({{{"name", "character"}, {"primitives", Json::array({primitive})}}});
    gltf["skins"] = Json::array({skin});
    if (!clips.empty()) gltf["animations"] = clips;
    gltf["materials"] = Json::array({make_material(rig)});
    if (textured) {
        gltf["textures"] = Json::array({{{"sampler", 0}, {"source", 0}}});
        gltf["images"] =
            Json::array({{{"name", "drawing"}, {"mimeType", "image/png"}, {"bufferView", image}}});
        // Linear with mipmaps, clamped to the edge.
        gltf["samplers"] =
            Json::array({{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}});
    }
    gltf["accessors"] = buffer.accessors();
    gltf["bufferViews"] = buffer.views();
    gltf["buffers"] = Json::array({{{"byteLength", buffer.bytes().size()}}});
    return pack_glb(to_compact_json_text(gltf), buffer.bytes());
}

} // namespace pantin
