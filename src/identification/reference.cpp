// The reference skeletons: JSON to structs (format: docs/formats.md, "reference.json"; thesis 4.5,
// Fig. 4.13).
//
// Nodes, edges, joints and tracks refer to each other by name in the file and by index in memory. The reader
// is strict: a missing key, an unknown key, a value of the wrong type or out of range, a name that nothing
// bears is an Error(input) of one line that names the file, the place and the fact.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include <nlohmann/json.hpp>

#include "core/resources.hpp"
#include "pantin/error.hpp"
#include "pantin/identification.hpp"

namespace pantin {
namespace {

using nlohmann::json;

constexpr int max_nodes = 40; // the search of the graph distance is exact up to here
constexpr int max_joints = 64;
constexpr int max_clips = 32;
constexpr int max_tracks = 256;
constexpr std::streamoff max_file_bytes = 1 << 20;

// One JSON value and where it stands, for error messages such as `fox.json: nodes[3].x: …`.
class Reader {
public:
    Reader(const json& value, std::string file, std::string place)
        : value_(value), file_(std::move(file)), place_(std::move(place)) {}

    [[noreturn]] void fail(const std::string& fact) const {
        throw Error(ErrorKind::input, file_ + ": " + (place_.empty() ? "" : place_ + ": ") + fact);
    }
    void expect_keys(std::initializer_list<const char*> known) const {
        if (!value_.is_object()) fail("must be an object");
        for (const auto& [key, unused] : value_.items())
            if (std::none_of(known.begin(), known.end(), [&key](const char* k) { return key == k; }))
                fail("unknown key " + json(key).dump());
    }
    bool has(const char* key) const { return value_.contains(key); }
    bool is_null() const { return value_.is_null(); }
    Reader at(const char* key) const {
        if (!has(key)) fail(std::string("misses '") + key + "'");
        return {value_[key], file_, place_.empty() ? key : place_ + "." + key};
    }
    std::vector<Reader> elements(std::size_t most) const {
        if (!value_.is_array()) fail("must be a list");
        if (value_.size() > most) fail("has more than " + std::to_string(most) + " elements");
        std::vector<Reader> all;
        for (std::size_t i = 0; i < value_.size(); ++i)
            all.emplace_back(value_[i], file_, place_ + "[" + std::to_string(i) + "]");
        return all;
    }
    std::string name() const {
        if (!value_.is_string()) fail("must be a name");
        const std::string text = value_.get<std::string>();
        const auto allowed = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                   c == '-';
        };
        if (text.empty() || text.size() > 40 || !std::all_of(text.begin(), text.end(), allowed))
            fail("a name is 1 to 40 letters, digits, '_' and '-'");
        return text;
    }
    double number(double low, double high) const {
        if (!value_.is_number()) fail("must be a number");
        const double x = value_.get<double>();
        if (!(x >= low && x <= high))
            fail("must lie in [" + json(low).dump() + ", " + json(high).dump() + "]");
        return x;
    }
    int integer(int low, int high) const {
        const double x = number(low, high);
        if (x != std::floor(x)) fail("must be a whole number");
        return static_cast<int>(x);
    }

private:
    const json& value_;
    std::string file_, place_;
};

// Index of the element of that name, −1 when there is none.
template <class T> int index_of(const std::vector<T>& list, const std::string& name) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].name == name) return static_cast<int>(i);
    return -1;
}
template <class T> int find_named(const Reader& reader, const std::vector<T>& list, const char* kind) {
    const int index = index_of(list, reader.name());
    if (index < 0) reader.fail("there is no " + std::string(kind) + " '" + reader.name() + "'");
    return index;
}
template <class T> std::string new_name(const Reader& reader, const std::vector<T>& list) {
    const std::string name = reader.at("name").name();
    if (index_of(list, name) >= 0) reader.fail("the name '" + name + "' occurs twice");
    return name;
}

ReferenceNode read_node(const Reader& reader, const std::vector<ReferenceNode>& before) {
    reader.expect_keys({"name", "label", "x", "y", "r"});
    ReferenceNode node;
    node.name = new_name(reader, before);
    node.label = label_from_name(reader.at("label").name());
    if (node.label == Label::background) reader.at("label").fail("must be head, body, limb, tail or wing");
    node.x = reader.at("x").number(0, 1);
    node.y = reader.at("y").number(0, 1);
    node.r = reader.at("r").number(0.001, 0.5);
    return node;
}

std::pair<int, int> read_edge(const Reader& reader, const ReferenceSkeleton& skeleton) {
    const std::vector<Reader> ends = reader.elements(2);
    if (ends.size() != 2) reader.fail("an edge is a pair of node names");
    int u = find_named(ends[0], skeleton.nodes, "node"), v = find_named(ends[1], skeleton.nodes, "node");
    if (u > v) std::swap(u, v);
    if (u == v) reader.fail("an edge joins two different nodes");
    if (std::count(skeleton.edges.begin(), skeleton.edges.end(), std::pair{u, v}))
        reader.fail("the edge occurs twice");
    return {u, v};
}

ReferenceJoint read_joint(const Reader& reader, const ReferenceSkeleton& skeleton) {
    reader.expect_keys({"name", "parent", "node"});
    ReferenceJoint joint;
    joint.name = new_name(reader, skeleton.joints);
    const Reader parent = reader.at("parent");
    if (parent.is_null() != skeleton.joints.empty())
        parent.fail("the first joint, and no other, has the parent null");
    // Only the joints read so far are known, so parents come first.
    joint.parent = parent.is_null() ? -1 : find_named(parent, skeleton.joints, "earlier joint");
    joint.node = find_named(reader.at("node"), skeleton.nodes, "node");
    return joint;
}

ReferenceTrack read_track(const Reader& reader, const ReferenceSkeleton& skeleton) {
    reader.expect_keys({"joint", "axis", "segment", "amplitude", "phase", "offset", "cycles"});
    ReferenceTrack track;
    track.joint = find_named(reader.at("joint"), skeleton.joints, "joint");
    track.axis = reader.at("axis").name();
    static constexpr std::array<std::string_view, 8> axes = {"x", "y", "z", "lift", "flap", "twist", "tx", "ty"};
    if (std::find(axes.begin(), axes.end(), track.axis) == axes.end())
        reader.at("axis").fail("must be x, y, z, lift, flap, twist, tx or ty");
    if (reader.has("segment")) track.segment = reader.at("segment").integer(0, 8);
    track.amplitude = reader.at("amplitude").number(-360, 360);
    if (reader.has("phase")) track.phase = reader.at("phase").number(-1, 1);
    if (reader.has("offset")) track.offset = reader.at("offset").number(-360, 360);
    if (reader.has("cycles")) track.cycles = reader.at("cycles").integer(0, 64);
    return track;
}

ReferenceClip read_clip(const Reader& reader, const ReferenceSkeleton& skeleton) {
    reader.expect_keys({"name", "duration", "tracks"});
    ReferenceClip clip;
    clip.name = new_name(reader, skeleton.clips);
    clip.duration = reader.at("duration").number(0.05, 60);
    for (const Reader& track : reader.at("tracks").elements(max_tracks))
        clip.tracks.push_back(read_track(track, skeleton));
    return clip;
}

void require_connected(const Reader& reader, const ReferenceSkeleton& skeleton) {
    std::vector<int> component(skeleton.nodes.size());
    for (std::size_t i = 0; i < component.size(); ++i) component[i] = static_cast<int>(i);
    for (const auto& [u, v] : skeleton.edges)
        std::replace(component.begin(), component.end(), int(component[v]), int(component[u]));
    for (std::size_t i = 1; i < component.size(); ++i)
        if (component[i] != component[0])
            reader.fail("no path of edges leads to '" + skeleton.nodes[i].name + "'");
}

ReferenceSkeleton read_skeleton(const Reader& reader) {
    reader.expect_keys({"name", "nodes", "edges", "joints", "clips"});
    ReferenceSkeleton skeleton;
    skeleton.name = reader.at("name").name();
    for (const Reader& node : reader.at("nodes").elements(max_nodes))
        skeleton.nodes.push_back(read_node(node, skeleton.nodes));
    if (skeleton.nodes.size() < 2) reader.at("nodes").fail("a reference has at least two nodes");
    for (const Reader& edge : reader.at("edges").elements(max_nodes * max_nodes))
        skeleton.edges.push_back(read_edge(edge, skeleton));
    require_connected(reader.at("edges"), skeleton);
    for (const Reader& joint : reader.at("joints").elements(max_joints))
        skeleton.joints.push_back(read_joint(joint, skeleton));
    for (const Reader& clip : reader.at("clips").elements(max_clips))
        skeleton.clips.push_back(read_clip(clip, skeleton));
    return skeleton;
}

std::vector<unsigned char> read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) throw Error(ErrorKind::input, file.string() + ": cannot be read");
    if (stream.tellg() > max_file_bytes) throw Error(ErrorKind::input, file.string() + ": larger than 1 MiB");
    stream.seekg(0);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The *.json files of the directory in the order of their names.
std::vector<std::filesystem::path> reference_files(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::directory_iterator entries(directory, error);
    if (error) throw Error(ErrorKind::input, directory.string() + ": not a readable directory of references");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : entries)
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.empty()) throw Error(ErrorKind::input, directory.string() + ": holds no reference (*.json)");
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

ReferenceSkeleton parse_reference(std::span<const unsigned char> bytes, const std::string& source) {
    json document;
    try {
        document = json::parse(bytes.begin(), bytes.end());
    } catch (const json::parse_error& error) {
        throw Error(ErrorKind::input, source + ": not JSON, at byte " + std::to_string(error.byte));
    } catch (const json::exception&) { // a number too large for a double
        throw Error(ErrorKind::input, source + ": holds a number out of range");
    }
    return read_skeleton({document, source, ""});
}

std::vector<ReferenceSkeleton> load_references(const std::filesystem::path& directory) {
    std::vector<ReferenceSkeleton> all;
    for (const char* name : {"humanoid", "quadruped", "flying"}) {
        const std::string path = std::string("references/") + name + ".json";
        all.push_back(parse_reference(find_resource(path), path));
    }
    if (directory.empty()) return all;
    std::set<std::string> seen;
    for (const std::filesystem::path& file : reference_files(directory)) {
        ReferenceSkeleton skeleton = parse_reference(read_file(file), file.string());
        if (!seen.insert(skeleton.name).second)
            throw Error(ErrorKind::input,
                        file.string() + ": a second reference named '" + skeleton.name + "'");
        const int known = index_of(all, skeleton.name);
        if (known >= 0)
            all[known] = std::move(skeleton);
        else
            all.push_back(std::move(skeleton));
    }
    return all;
}

} // namespace pantin
