// SPDX-License-Identifier: MIT
// The reference skeletons: JSON to structs (format: docs/formats.md, "reference.json"; thesis 4.5,
// Fig. 4.13).
//
// Nodes, edges, joints and tracks refer to each other by name in the file and by index in memory. The reader
// is strict: a missing key, an unknown key, a value of the wrong type or out of range, a name that nothing
// bears is an Error(input) of one line that names the file, the place and the fact.
#include <algorithm>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/json_reader.hpp"
#include "core/resources.hpp"
#include "core/suggestion.hpp"
#include "pantin/error.hpp"
#include "pantin/reference.hpp"
#include "reference/named.hpp"
#include "reference/quantities.hpp"
#include "reference/tracks.hpp"

namespace pantin {
namespace {

constexpr int max_nodes = 40; // the search of the graph distance is exact up to here
constexpr int max_joints = 64;
constexpr int max_clips = 32;
constexpr int max_tracks = 256;
constexpr std::size_t max_file_bytes = 1 << 20;

void expect_keys(const JsonReader& reader, std::initializer_list<std::string_view> known) {
    for (const auto& entry : reader.entries())
        if (std::find(known.begin(), known.end(), entry.first) == known.end())
            reader.fail("unknown key " + to_compact_json_text(entry.first));
}

std::string read_name(const JsonReader& reader) {
    const std::string text = reader.text();
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    if (text.empty() || text.size() > 40 || !std::all_of(text.begin(), text.end(), allowed))
        reader.fail("a name is 1 to 40 letters, digits, '_' and '-'");
    return text;
}

int read_integer(const JsonReader& reader, int low, int high) {
    return static_cast<int>(reader.integer(low, high));
}

template <class T> int find_named(const JsonReader& reader, const std::vector<T>& list, const char* kind) {
    const int index = index_of(list, read_name(reader));
    if (index < 0) reader.fail("there is no " + std::string(kind) + " '" + read_name(reader) + "'");
    return index;
}
template <class T> std::string new_name(const JsonReader& reader, const std::vector<T>& list) {
    const std::string name = read_name(reader.at("name"));
    if (index_of(list, name) >= 0) reader.fail("the name '" + name + "' occurs twice");
    return name;
}

ReferenceNode read_node(const JsonReader& reader, const std::vector<ReferenceNode>& before) {
    expect_keys(reader, {"name", "label", "x", "y", "r"});
    ReferenceNode node;
    node.name = new_name(reader, before);
    node.label = label_from_name(read_name(reader.at("label")));
    if (node.label == Label::background) reader.at("label").fail("must be " + listed_parts());
    node.x = reader.at("x").number(0, 1);
    node.y = reader.at("y").number(0, 1);
    node.r = reader.at("r").number(0.001, 0.5);
    return node;
}

std::pair<int, int> read_edge(const JsonReader& reader, const ReferenceSkeleton& skeleton) {
    const std::vector<JsonReader> ends = reader.elements(2, 2);
    if (ends.size() != 2) reader.fail("an edge is a pair of node names");
    int u = find_named(ends[0], skeleton.nodes, "node"), v = find_named(ends[1], skeleton.nodes, "node");
    if (u > v) std::swap(u, v);
    if (u == v) reader.fail("an edge joins two different nodes");
    if (std::count(skeleton.edges.begin(), skeleton.edges.end(), std::pair{u, v}))
        reader.fail("the edge occurs twice");
    return {u, v};
}

ReferenceJoint read_joint(const JsonReader& reader, const ReferenceSkeleton& skeleton) {
    expect_keys(reader, {"name", "parent", "node"});
    ReferenceJoint joint;
    joint.name = new_name(reader, skeleton.joints);
    const JsonReader parent = reader.at("parent");
    if (parent.value().is_null() != skeleton.joints.empty())
        parent.fail("the first joint, and no other, has the parent null");
    // Only the joints read so far are known, so parents come first.
    joint.parent = parent.value().is_null() ? -1 : find_named(parent, skeleton.joints, "earlier joint");
    joint.node = find_named(reader.at("node"), skeleton.nodes, "node");
    return joint;
}

TrackKind read_kind(const JsonReader& reader) {
    const auto found = std::find(track_kind_names.begin(), track_kind_names.end(), read_name(reader));
    if (found == track_kind_names.end())
        reader.fail("must be x, y, z, lift, flap, twist, tx, ty, step or plant");
    return static_cast<TrackKind>(found - track_kind_names.begin());
}

ReferenceTrack read_track(const JsonReader& reader, const ReferenceSkeleton& skeleton) {
    expect_keys(reader, {"joint", "axis", "segment", "amplitude", "phase", "offset", "cycles", "lift", "duty",
                         "bend"});
    ReferenceTrack track;
    track.joint = find_named(reader.at("joint"), skeleton.joints, "joint");
    track.kind = read_kind(reader.at("axis"));
    const bool steps = track.kind == TrackKind::step, grounded = on_ground(track.kind);
    for (const char* key : {"lift", "duty"})
        if (reader.has(key) && !steps) reader.at(key).fail("belongs to the axis step");
    if (reader.has("bend") && !grounded) reader.at("bend").fail("belongs to the axes step and plant");
    for (const char* key : {"segment", "offset", "cycles"})
        if (reader.has(key) && grounded) reader.at(key).fail("does not belong to the axes step and plant");
    if (reader.has("segment")) track.segment = read_integer(reader.at("segment"), 0, 8);
    if (steps || !grounded)
        track.amplitude = reader.at("amplitude").number(steps ? 0 : -360, steps ? 1 : 360);
    if (reader.has("lift")) track.lift = reader.at("lift").number(0, 0.8);
    if (reader.has("duty")) track.duty = reader.at("duty").number(0.1, 0.95);
    if (reader.has("bend")) track.bend = read_integer(reader.at("bend"), -1, 1) < 0 ? -1 : 1;
    if (reader.has("phase")) track.phase = reader.at("phase").number(-1, 1);
    if (reader.has("offset")) track.offset = reader.at("offset").number(-360, 360);
    if (reader.has("cycles")) track.cycles = read_integer(reader.at("cycles"), 0, 64);
    return track;
}

ReferenceClip read_clip(const JsonReader& reader, const ReferenceSkeleton& skeleton) {
    expect_keys(reader, {"name", "duration", "tracks"});
    ReferenceClip clip;
    clip.name = new_name(reader, skeleton.clips);
    clip.duration = reader.at("duration").number(0.05, 60);
    for (const JsonReader& track : reader.at("tracks").elements(0, max_tracks))
        clip.tracks.push_back(read_track(track, skeleton));
    return clip;
}

void require_connected(const JsonReader& reader, const ReferenceSkeleton& skeleton) {
    std::vector<int> component(skeleton.nodes.size());
    for (std::size_t i = 0; i < component.size(); ++i) component[i] = static_cast<int>(i);
    for (const auto& [u, v] : skeleton.edges)
        std::replace(component.begin(), component.end(), int(component[v]), int(component[u]));
    for (std::size_t i = 1; i < component.size(); ++i)
        if (component[i] != component[0])
            reader.fail("no path of edges leads to '" + skeleton.nodes[i].name + "'");
}

std::vector<ReferenceNeed> read_needs(const JsonReader& reader) {
    std::vector<ReferenceNeed> needs;
    for (const auto& [name, range] : reader.entries()) {
        if (std::find(trait_names.begin(), trait_names.end(), name) == trait_names.end() &&
            std::find(count_names.begin(), count_names.end(), name) == count_names.end())
            reader.fail("there is no trait '" + name + "'");
        const std::vector<JsonReader> bounds = range.elements(2, 2);
        needs.push_back({name, bounds[0].number(-1000, 1000), bounds[1].number(-1000, 1000)});
        if (needs.back().low > needs.back().high) range.fail("the lower bound is above the upper one");
    }
    return needs;
}

ReferenceSkeleton read_skeleton(const JsonReader& reader) {
    expect_keys(reader, {"name", "order", "like", "needs", "nodes", "edges", "joints", "clips"});
    ReferenceSkeleton skeleton;
    skeleton.name = read_name(reader.at("name"));
    if (reader.has("order")) skeleton.order = read_integer(reader.at("order"), 0, 1'000'000);
    if (reader.has("like")) skeleton.like = read_name(reader.at("like"));
    if (reader.has("needs")) {
        if (skeleton.like.empty()) reader.at("needs").fail("a reference with needs is \"like\" another");
        skeleton.needs = read_needs(reader.at("needs"));
    }
    for (const JsonReader& node : reader.at("nodes").elements(0, max_nodes))
        skeleton.nodes.push_back(read_node(node, skeleton.nodes));
    if (skeleton.nodes.size() < 2) reader.at("nodes").fail("a reference has at least two nodes");
    for (const JsonReader& edge : reader.at("edges").elements(0, max_nodes * max_nodes))
        skeleton.edges.push_back(read_edge(edge, skeleton));
    require_connected(reader.at("edges"), skeleton);
    for (const JsonReader& joint : reader.at("joints").elements(0, max_joints))
        skeleton.joints.push_back(read_joint(joint, skeleton));
    for (const JsonReader& clip : reader.at("clips").elements(0, max_clips))
        skeleton.clips.push_back(read_clip(clip, skeleton));
    return skeleton;
}

std::vector<ReferenceSkeleton> by_order(std::vector<ReferenceSkeleton> references) {
    std::stable_sort(references.begin(), references.end(), [](const auto& a, const auto& b) {
        return std::pair(a.order, a.name) < std::pair(b.order, b.name);
    });
    return references;
}

std::vector<ReferenceSkeleton> compiled_in() {
    std::vector<ReferenceSkeleton> all;
    for (const Resource& resource : resources())
        if (resource.name.starts_with("references/"))
            all.push_back(parse_reference(resource.bytes, std::string(resource.name)));
    return by_order(std::move(all));
}

std::vector<std::filesystem::path> reference_files(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::directory_iterator entries(directory, error);
    if (error) throw Error(ErrorKind::input, directory.string() + ": not a readable directory of references");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : entries)
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.empty()) throw Error(ErrorKind::input, directory.string() + ": holds no reference (*.json)");
    std::sort(files.begin(), files.end()); // so that the same file is named in a message every time
    return files;
}

std::vector<ReferenceSkeleton> in_folder(const std::filesystem::path& directory) {
    std::vector<ReferenceSkeleton> all;
    for (const std::filesystem::path& file : reference_files(directory)) {
        ReferenceSkeleton skeleton = parse_reference(read_file(file, max_file_bytes), file.string());
        if (index_of(all, skeleton.name) >= 0)
            throw Error(ErrorKind::input,
                        file.string() + ": a second reference named '" + skeleton.name + "'");
        all.push_back(std::move(skeleton));
    }
    return by_order(std::move(all));
}

} // namespace

bool is_humanoid(const ReferenceSkeleton& reference) {
    const auto has = [&](const char* name) { return index_of(reference.joints, name) >= 0; };
    return has("arm_left") && has("arm_right") && has("leg_left") && has("leg_right");
}

ReferenceSkeleton parse_reference(std::span<const unsigned char> bytes, const std::string& source) {
    const Json document = parse_json(std::string(bytes.begin(), bytes.end()), source);
    return read_skeleton(JsonReader(document, source));
}

std::vector<ReferenceSkeleton> load_references(const std::filesystem::path& directory, ClipSet clips) {
    std::vector<ReferenceSkeleton> all = compiled_in();
    if (!directory.empty())
        for (ReferenceSkeleton& skeleton : in_folder(directory)) {
            const int known = index_of(all, skeleton.name);
            if (known >= 0)
                all[known] = std::move(skeleton);
            else
                all.push_back(std::move(skeleton));
        }
    if (clips == ClipSet::thesis)
        for (ReferenceSkeleton& reference : all) reference.clips = thesis_clips(reference);
    return all;
}

const ReferenceSkeleton& find_reference(const std::vector<ReferenceSkeleton>& references,
                                        const std::string& name) {
    std::string list;
    std::vector<std::string> names;
    for (const ReferenceSkeleton& reference : references) {
        if (reference.name == name) return reference;
        list += (list.empty() ? "" : ", ") + reference.name;
        names.push_back(reference.name);
    }
    throw Error(ErrorKind::input,
                "there is no reference '" + name + "' (" + list + ")" + did_you_mean(name, names));
}

} // namespace pantin
