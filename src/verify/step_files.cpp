// SPDX-License-Identifier: MIT
// Products of the steps to JSON and back, every double to the bit (own; docs/formats.md, "Reference
// vectors").
#include "verify/step_files.hpp"
#include "formats/file_names.hpp"

#include "core/digest.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "formats/weights_file.hpp"

namespace pantin {

namespace {

constexpr double huge = 1e15;
constexpr long most = 1'000'000;
constexpr std::size_t most_found = 3;

Json to_array(Point2d p) { return {p.x, p.y}; }
Json to_array(Vec3 p) { return {p.x, p.y, p.z}; }
Json to_array(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }
template <class T, std::size_t n> Json to_array(const std::array<T, n>& values) { return Json(values); }
Json to_array(const std::vector<int>& values) { return Json(values); }
template <class T> Json to_list(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(to_array(value));
    return list;
}

double real(const JsonReader& reader) { return reader.number(-huge, huge); }
int whole(const JsonReader& reader, long low = -1) { return static_cast<int>(reader.integer(low, most)); }
std::vector<double> reals(const JsonReader& reader, std::size_t count) {
    std::vector<double> values;
    for (const JsonReader& value : reader.elements(count, count)) values.push_back(real(value));
    return values;
}
Point2d point(const JsonReader& reader) {
    const std::vector<double> xy = reals(reader, 2);
    return {xy[0], xy[1]};
}
Vec3 place(const JsonReader& reader) {
    const std::vector<double> xyz = reals(reader, 3);
    return {xyz[0], xyz[1], xyz[2]};
}
Quaternion quaternion(const JsonReader& reader) {
    const std::vector<double> q = reals(reader, 4);
    return {q[0], q[1], q[2], q[3]};
}
int index(const JsonReader& reader) { return whole(reader, 0); }
template <class T> std::vector<T> list_of(const JsonReader& reader, T (*read)(const JsonReader&)) {
    std::vector<T> values;
    for (const JsonReader& value : reader.elements(0, most)) values.push_back(read(value));
    return values;
}
std::vector<int> indices(const JsonReader& reader) { return list_of(reader, index); }

Bone bone(const JsonReader& reader) {
    Bone bone;
    bone.name = reader.at("name").text();
    bone.parent = whole(reader.at("parent"));
    bone.head = point(reader.at("head"));
    bone.tail = point(reader.at("tail"));
    bone.label = label_from_name(reader.at("label").text());
    bone.reference_joint = whole(reader.at("reference_joint"));
    bone.segment = whole(reader.at("segment"));
    bone.mirrored = reader.at("mirrored").boolean();
    bone.phase_shift = real(reader.at("phase_shift"));
    bone.freedom = real(reader.at("freedom"));
    return bone;
}

std::vector<Quaternion> quaternions(const JsonReader& reader) { return list_of(reader, quaternion); }

BoneAnimation animation(const JsonReader& reader) {
    BoneAnimation animation;
    animation.name = reader.at("name").text();
    animation.duration = real(reader.at("duration"));
    animation.ground_speed = real(reader.at("ground_speed"));
    animation.times = list_of(reader.at("times"), real);
    animation.rotations = list_of(reader.at("rotations"), quaternions);
    animation.root_translation = list_of(reader.at("root_translation"), place);
    return animation;
}

} // namespace

// --- detection and segmentation
// ------------------------------------------------------------------------------

std::string found_to_json(const std::vector<CharacterFinder::Found>& found) {
    Json json;
    json["found"] = Json::array();
    for (const CharacterFinder::Found& f : found) {
        if (json["found"].size() == most_found) break;
        Json item;
        item["score"] = f.score;
        item["box"] = {f.left, f.top, f.right, f.bottom};
        item["mask"] = Json::array();
        for (int y = 0; y < f.mask.height(); ++y)
            item["mask"].push_back(std::vector<float>(f.mask.row(y), f.mask.row(y) + f.mask.width()));
        json["found"].push_back(item);
    }
    return to_json_text(json);
}

std::string probabilities_to_json(const std::vector<Grid<float>>& probabilities, int step) {
    Json json;
    json["width"] = probabilities.front().width();
    json["height"] = probabilities.front().height();
    json["step"] = step;
    Digest digest;
    for (std::size_t label = 0; label < probabilities.size(); ++label) {
        const Grid<float>& plane = probabilities[label];
        digest.add(plane);
        Json rows = Json::array();
        for (int y = 0; y < plane.height(); y += step) {
            Json row = Json::array();
            for (int x = 0; x < plane.width(); x += step) row.push_back(plane(x, y));
            rows.push_back(row);
        }
        json[std::string(label_names[label])] = rows;
    }
    json["digest"] = digest.text(); // last, so that a value that differs is reported before it
    return to_json_text(json);
}

// --- rigs
// ------------------------------------------------------------------------------------------------------

std::string mesh_to_json(const Rig& rig) {
    Json json;
    json["width"] = rig.width;
    json["height"] = rig.height;
    json["vertices"] = to_list(rig.mesh.vertices);
    json["faces"] = to_list(rig.mesh.faces);
    json["texture"] = to_list(rig.texture);
    return to_json_text(json);
}

std::string bones_to_json(const Rig& rig) {
    Json json;
    json["bones"] = Json::array();
    for (const Bone& bone : rig.bones) {
        Json item;
        item["name"] = bone.name;
        item["parent"] = bone.parent;
        item["head"] = to_array(bone.head);
        item["tail"] = to_array(bone.tail);
        item["label"] = name_of(bone.label);
        item["reference_joint"] = bone.reference_joint;
        item["segment"] = bone.segment;
        item["mirrored"] = bone.mirrored;
        item["phase_shift"] = bone.phase_shift;
        item["freedom"] = bone.freedom;
        json["bones"].push_back(item);
    }
    return to_json_text(json);
}

std::string depths_to_json(const Rig& rig) {
    Json json;
    json["depths"] = rig.depth;
    return to_json_text(json);
}

Rig rig_from_files(const std::string& mesh, const std::string& bones, const std::string& weights,
                   const std::string& depths) {
    Rig rig;
    const Json mesh_json = parse_json(mesh, "mesh.json"), bones_json = parse_json(bones, "bones.json"),
               depths_json = parse_json(depths, "depths.json");
    const JsonReader reader(mesh_json, "mesh.json");
    rig.width = whole(reader.at("width"), 1);
    rig.height = whole(reader.at("height"), 1);
    rig.mesh.vertices = list_of(reader.at("vertices"), point);
    rig.mesh.faces = list_of(reader.at("faces"), indices);
    rig.texture = list_of(reader.at("texture"), point);
    rig.bones = list_of(JsonReader(bones_json, "bones.json").at("bones"), bone);
    rig.weights = weights_from_text(weights, file_names::weights, rig);
    rig.depth = list_of(JsonReader(depths_json, "depths.json").at("depths"), real);
    return rig;
}

// --- animation
// -------------------------------------------------------------------------------------------------

std::string animations_to_json(const std::vector<BoneAnimation>& animations) {
    Json json;
    json["animations"] = Json::array();
    for (const BoneAnimation& animation : animations) {
        Json item;
        item["name"] = animation.name;
        item["duration"] = animation.duration;
        item["ground_speed"] = animation.ground_speed;
        item["times"] = animation.times;
        item["rotations"] = Json::array();
        for (const std::vector<Quaternion>& bone : animation.rotations)
            item["rotations"].push_back(to_list(bone));
        item["root_translation"] = to_list(animation.root_translation);
        json["animations"].push_back(item);
    }
    return to_json_text(json);
}

std::vector<BoneAnimation> animations_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    return list_of(JsonReader(json, file).at("animations"), animation);
}

std::string places_to_json(const std::vector<Vec3>& vertices) {
    Json json;
    json["vertices"] = to_list(vertices);
    return to_json_text(json);
}

std::vector<Vec3> places_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    return list_of(JsonReader(json, file).at("vertices"), place);
}

// --- models
// ----------------------------------------------------------------------------------------------------

std::string inflation_to_json(const Inflation& inflation) {
    Json json;
    json["half_width"] = inflation.half_width;
    json["points"] = to_list(inflation.points);
    json["triangles"] = to_list(inflation.triangles);
    json["squared"] = inflation.squared;
    return to_json_text(json);
}

std::string solid_to_json(const SolidMesh& mesh) {
    Json json;
    json["vertices"] = to_list(mesh.vertices);
    json["triangles"] = to_list(mesh.triangles);
    json["parts"] = mesh.parts;
    return to_json_text(json);
}

SolidMesh solid_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const JsonReader reader(json, file);
    SolidMesh mesh;
    mesh.vertices = list_of(reader.at("vertices"), place);
    for (const JsonReader& triangle : reader.at("triangles").elements(0, most)) {
        const std::vector<JsonReader> corners = triangle.elements(3, 3);
        mesh.triangles.push_back({index(corners[0]), index(corners[1]), index(corners[2])});
    }
    mesh.parts = list_of(reader.at("parts"), index);
    return mesh;
}

std::vector<BoneSegment> segments_from_json(const std::string& text, const std::string& file) {
    const Json json = parse_json(text, file);
    const std::vector<JsonReader> joints = JsonReader(json, file).at("joints").elements(0, most);
    std::vector<BoneSegment> segments;
    for (const JsonReader& joint : joints) {
        const bool root = !joint.has("parent");
        if (root && !segments.empty())
            continue; // as in model_rig(): a tree of its own has no bone of its root
        const JsonReader& parent = root ? joint
                                        : joints[static_cast<std::size_t>(joint.at("parent").integer(
                                              0, static_cast<long>(joints.size()) - 1))];
        segments.push_back({place(parent.at("place")), place(joint.at("place")),
                            0.5 * (real(parent.at("radius")) + real(joint.at("radius")))});
    }
    return segments;
}

} // namespace pantin
