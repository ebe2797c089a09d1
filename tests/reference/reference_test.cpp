// SPDX-License-Identifier: MIT
// Reference skeletons: what is compiled in, what a directory adds, what a malformed file says.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <set>

#include "pantin/error.hpp"
#include "pantin/reference.hpp"

using namespace pantin;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

ReferenceSkeleton parse(const std::string& text) {
    return parse_reference({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, "fox.json");
}

std::string failure(const std::string& text) {
    try {
        parse(text);
    } catch (const Error& error) {
        REQUIRE(error.kind() == ErrorKind::input);
        REQUIRE(std::string(error.what()).find('\n') == std::string::npos);
        return error.what();
    }
    return "";
}

const std::string fox = R"({"name": "fox",
    "nodes": [{"name": "head", "label": "head", "x": 0.1, "y": 0.2, "r": 0.1},
              {"name": "chest", "label": "body", "x": 0.5, "y": 0.5, "r": 0.2}],
    "edges": [["chest", "head"]],
    "joints": [{"name": "chest", "parent": null, "node": "chest"}, {"name": "head", "parent": "chest", "node": "head"}],
    "clips": [{"name": "walk", "duration": 1.5, "tracks": [
        {"joint": "head", "axis": "z", "amplitude": 10, "phase": 0.25, "cycles": 2}]}]})";

std::string replaced(const std::string& from, const std::string& to) {
    std::string text = fox;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

// Kinds of the tracks of a joint in the clip.
std::set<TrackKind> kinds_of(const ReferenceClip& clip, const ReferenceSkeleton& reference,
                             const std::string& joint) {
    std::set<TrackKind> kinds;
    for (const ReferenceTrack& track : clip.tracks)
        if (reference.joints[static_cast<std::size_t>(track.joint)].name == joint) kinds.insert(track.kind);
    return kinds;
}

struct Folder {
    fs::path path = fs::temp_directory_path() / "pantin-test-references";
    Folder() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }
};

} // namespace

TEST_CASE(
    "the compiled-in references are the three of the thesis and those that are like them, in a fixed order") {
    const auto all = load_references();
    std::vector<std::string> names, alone;
    for (const ReferenceSkeleton& reference : all) {
        names.push_back(reference.name);
        if (reference.like.empty()) alone.push_back(reference.name);
        CHECK(reference.like.empty() == reference.needs.empty());
        CHECK(reference.edges.size() + 1 == reference.nodes.size()); // a tree
        std::set<Label> labels;
        for (const ReferenceNode& node : reference.nodes) labels.insert(node.label);
        CHECK(labels.count(Label::head) == 1);
        CHECK(labels.count(Label::limb) == (reference.name != "fish" && reference.name != "bust"));
        CHECK(labels.count(Label::wing) == (reference.name == "flying"));
    }
    CHECK(names ==
          std::vector<std::string>{"humanoid", "quadruped", "flying", "bird", "insect", "fish", "bust"});
    CHECK(alone == std::vector<std::string>{"humanoid", "quadruped", "flying"});
}

TEST_CASE("the needs of a reference are read, and refused when they make no sense") {
    const auto with = [](const std::string& more) {
        return replaced("\"name\": \"fox\",", "\"name\": \"fox\", " + more);
    };
    const ReferenceSkeleton skeleton = parse(with("\"like\": \"any\", \"needs\": {\"limb_ends\": [3, 5]},"));
    CHECK(skeleton.like == "any");
    REQUIRE(skeleton.needs.size() == 1);
    CHECK(skeleton.needs[0].quantity == "limb_ends");
    CHECK(skeleton.needs[0].low == 3);
    CHECK(skeleton.needs[0].high == 5);
    CHECK_THAT(failure(with("\"needs\": {},")),
               Contains("needs: a reference with needs is \"like\" another"));
    CHECK_THAT(failure(with("\"like\": \"any\", \"needs\": {\"fins\": [0, 1]},")),
               Contains("needs: there is no trait 'fins'"));
    CHECK_THAT(failure(with("\"like\": \"any\", \"needs\": {\"limb_ends\": [5, 3]},")),
               Contains("needs.limb_ends: the lower bound is above the upper one"));
}

TEST_CASE("a reference is read as written") {
    const ReferenceSkeleton skeleton = parse(fox);
    REQUIRE(skeleton.nodes.size() == 2);
    CHECK(skeleton.nodes[0].label == Label::head);
    CHECK(skeleton.nodes[1].r == 0.2);
    CHECK(skeleton.edges == std::vector<std::pair<int, int>>{{0, 1}});
    CHECK(skeleton.joints[0].parent == -1);
    CHECK(skeleton.joints[1].parent == 0);
    REQUIRE(skeleton.clips.size() == 1);
    const ReferenceTrack& track = skeleton.clips[0].tracks.at(0);
    CHECK(track.joint == 1);
    CHECK(track.kind == TrackKind::z);
    CHECK(track.amplitude == 10);
    CHECK(track.phase == 0.25);
    CHECK(track.cycles == 2);
    CHECK(track.offset == 0);
}

TEST_CASE("a malformed reference is an error that names the file, the place and the fact") {
    CHECK_THAT(failure(""), Contains("fox.json: not valid JSON"));
    CHECK_THAT(failure(fox.substr(0, 200)), Contains("fox.json: not valid JSON"));
    CHECK_THAT(failure("[1, 2]"), Contains("fox.json: must be an object"));
    CHECK_THAT(failure("{\"name\": 1e999}"), Contains("fox.json: not valid JSON"));
    CHECK_THAT(failure(replaced("\"x\": 0.1", "\"x\": 1.5")),
               Contains("fox.json: nodes[0].x: must lie between 0 and 1"));
    CHECK_THAT(failure(replaced("\"x\": 0.1", "\"x\": \"left\"")), Contains("nodes[0].x: must be a number"));
    CHECK_THAT(failure(replaced("\"x\": 0.1, ", "")), Contains("nodes[0]: misses \"x\""));
    CHECK_THAT(failure(replaced("\"label\": \"head\"", "\"label\": \"fin\"")),
               Contains("nodes[0].label: must be head"));
    CHECK_THAT(failure(replaced("\"name\": \"chest\"", "\"name\": \"head\"")),
               Contains("'head' occurs twice"));
    CHECK_THAT(failure(replaced("[\"chest\", \"head\"]", "[\"chest\", \"toe\"]")),
               Contains("edges[0][1]: there is no node 'toe'"));
    CHECK_THAT(failure(replaced("[\"chest\", \"head\"]", "[\"chest\", \"chest\"]")),
               Contains("two different nodes"));
    CHECK_THAT(failure(replaced("[\"chest\", \"head\"]", "")), Contains("no path of edges leads to 'chest'"));
    CHECK_THAT(failure(replaced("\"parent\": \"chest\"", "\"parent\": \"tail\"")),
               Contains("joints[1].parent"));
    CHECK_THAT(failure(replaced("\"parent\": null", "\"parent\": \"head\"")), Contains("joints[0].parent"));
    CHECK_THAT(failure(replaced("\"cycles\": 2", "\"lift\": 0.1")),
               Contains("lift: belongs to the axis step"));
    CHECK_THAT(failure(replaced("\"cycles\": 2", "\"bend\": -1")),
               Contains("bend: belongs to the axes step and plant"));
    CHECK_THAT(failure(replaced("\"axis\": \"z\"", "\"axis\": \"plant\"")),
               Contains("cycles: does not belong"));
    CHECK_THAT(failure(replaced("\"axis\": \"z\"", "\"axis\": \"w\"")), Contains("clips[0].tracks[0].axis"));
    CHECK_THAT(failure(replaced("\"cycles\": 2", "\"cycles\": 2.5")), Contains("whole number"));
    CHECK_THAT(failure(replaced("\"cycles\"", "\"cycle\"")), Contains("unknown key \"cycle\""));
    CHECK_THAT(failure(replaced("\"name\": \"fox\"", "\"name\": \"../fox\"")), Contains("name: a name is"));
}

TEST_CASE("no truncation and no changed byte of a reference makes the reader do anything but succeed or fail "
          "clearly") {
    for (std::size_t n = 0; n < fox.size(); ++n) CHECK_FALSE(failure(fox.substr(0, n)).empty());
    for (std::size_t n = 0; n < fox.size(); ++n)
        for (const char c : {'\0', '"', '9', '\xff', '}'}) {
            std::string text = fox;
            text[n] = c;
            const std::string message = failure(text);
            CHECK((message.empty() || message.find("fox.json: ") == 0));
        }
}

TEST_CASE("a directory replaces references of the same name and adds others") {
    const Folder folder;
    folder.write("b.json", fox);
    folder.write("a.json", replaced("\"name\": \"fox\"", "\"name\": \"humanoid\""));
    folder.write("notes.txt", "not a reference");
    const auto all = load_references(folder.path);
    REQUIRE(all.size() == 8);
    CHECK(all[0].name == "humanoid");
    CHECK(all[0].nodes.size() == 2);
    CHECK(all[1].name == "quadruped");
    CHECK(all[7].name == "fox");
}

TEST_CASE("a directory that is missing, empty or ambiguous is an error that names it") {
    CHECK_THROWS_WITH(load_references("/nonexistent/references"), Contains("/nonexistent/references"));
    const Folder folder;
    CHECK_THROWS_WITH(load_references(folder.path), Contains("holds no reference"));
    folder.write("a.json", fox);
    folder.write("b.json", fox);
    CHECK_THROWS_WITH(load_references(folder.path), Contains("b.json: a second reference named 'fox'"));
}

TEST_CASE("the clips of thesis 6.1 move what it says in the direction that it says") {
    const std::vector<ReferenceSkeleton> references = load_references();
    const ReferenceSkeleton &human = find_reference(references, "humanoid"),
                            &animal = find_reference(references, "quadruped");
    using Kinds = std::set<TrackKind>;
    REQUIRE(thesis_clips(human).size() == 1);
    const ReferenceClip walk = thesis_clips(human)[0];
    CHECK(walk.name == "walk");
    for (const char* limb : {"arm_left", "arm_right", "leg_left", "leg_right"})
        CHECK(kinds_of(walk, human, limb) == Kinds{TrackKind::flap}); // forward and backward
    CHECK(kinds_of(walk, human, "head") == Kinds{TrackKind::z});      // left and right
    CHECK(kinds_of(walk, human, "hips").empty());
    const auto phase = [](const ReferenceClip& clip, const ReferenceSkeleton& reference, const char* joint) {
        for (const ReferenceTrack& track : clip.tracks)
            if (reference.joints[static_cast<std::size_t>(track.joint)].name == joint) return track.phase;
        return -1.0;
    };
    CHECK(phase(walk, human, "arm_left") == phase(walk, human, "leg_right"));
    CHECK(phase(walk, human, "arm_left") != phase(walk, human, "leg_left"));

    const ReferenceClip trot = thesis_clips(animal)[0];
    for (const char* leg : {"leg_front_left", "leg_front_right", "leg_hind_left", "leg_hind_right"})
        CHECK(kinds_of(trot, animal, leg) == Kinds{TrackKind::z});   // left and right
    CHECK(kinds_of(trot, animal, "tail") == Kinds{TrackKind::flap}); // the third dimension
    CHECK(kinds_of(trot, animal, "head") == Kinds{TrackKind::lift}); // upwards and downwards
    CHECK(phase(trot, animal, "leg_front_left") == phase(trot, animal, "leg_hind_right"));
    CHECK(phase(trot, animal, "leg_front_left") != phase(trot, animal, "leg_front_right"));

    // Of a flyer the thesis describes none.
    for (const char* name : {"flying", "fish"}) {
        const ReferenceSkeleton& other = find_reference(references, name);
        REQUIRE(thesis_clips(other).size() == other.clips.size());
        for (std::size_t i = 0; i < other.clips.size(); ++i)
            CHECK(thesis_clips(other)[i].name == other.clips[i].name);
    }
}
