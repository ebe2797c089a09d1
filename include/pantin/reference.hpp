// SPDX-License-Identifier: MIT
// Reference skeletons (thesis 4.5, Fig. 4.13): what a character may move like, with the clips that it then
// plays (thesis 4.6, 6.1). Files: docs/references.md, docs/formats.md ("reference.json").
//
// Nodes lie in [0, 1]², x right, y down. Edges, joints and tracks name nodes and joints by their index.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pantin/label.hpp"
#include "pantin/point.hpp"

namespace pantin {

struct ReferenceNode {
    std::string name; // "head", "chest", "hand_left", …
    Label label = Label::body;
    double x = 0, y = 0; // [0, 1], y down
    double r = 0; // radius of the shape at the node (the shape: nodes and edges drawn with their radii)
};
// One joint of the animation hierarchy: turns about `node`'s inner end.
struct ReferenceJoint {
    std::string name; // glTF/VRM-like: "hips", "chest", "head", "leg_front_left", …
    int parent = -1;  // index of the parent joint, −1 for the root; parents come first
    int node = -1;    // the reference node that the joint moves (end-effector or body node)
};

// What a track moves. The code that plays tracks lists every kind in a switch without a default, so the
// compiler names the places that a new kind needs.
enum class TrackKind {
    x,     // turn about the drawing's x axis,
    y,     // y axis,
    z,     // z axis: in the plane, counter-clockwise seen from the front
    lift,  // in the plane, positive raises the bone's tip: a left wing and a right wing go up together
    flap,  // out of the plane, positive moves the tip towards the viewer
    twist, // about the bone itself
    tx,    // translation of the root joint to the right,
    ty,    // upwards
    step,  // the leg steps: its foot swings through the air and then keeps the ground
    plant, // the leg's foot keeps the ground throughout
};
// As in a reference file, by value of TrackKind.
inline constexpr std::array<std::string_view, 10> track_kind_names = {"x",     "y",  "z",  "lift", "flap",
                                                                      "twist", "tx", "ty", "step", "plant"};
static_assert(track_kind_names.size() == static_cast<std::size_t>(TrackKind::plant) + 1);

// A periodic movement of one joint: value(t) = offset + amplitude · sin(2π (cycles · t/duration + phase)).
struct ReferenceTrack {
    int joint = 0;
    TrackKind kind = TrackKind::z;
    int segment = 0; // along a limb's chain of bones: 0 the innermost
    // Degrees; for translations a share of the character's height; of a step half its way, as a share of the
    // leg's length.
    double amplitude = 0;
    double phase = 0; // in cycles
    double offset = 0;
    int cycles = 1; // whole cycles per clip, so that it loops
    // Of a step, whose phase counts from the foot's contact:
    double lift = 0;   // share of the leg's length by which the foot is lifted
    double duty = 0.6; // share of the cycle that the foot spends on the ground
    int bend = 1; // of step and plant: 1 the knee bends forwards (to the left, unless mirrored), −1 backwards
};
struct ReferenceClip {
    std::string name;    // "walk", "fly", "idle"
    double duration = 1; // seconds
    std::vector<ReferenceTrack> tracks;
};
// A condition on the drawing: a trait of docs/identification.md, or "limb_ends" or "wing_ends" (numbers of
// such end-effectors), lies between `low` and `high`.
struct ReferenceNeed {
    std::string quantity;
    double low = 0, high = 0;
};
struct ReferenceSkeleton {
    std::string name;
    // The reference whose evidence this one shares, or "any": that of the best. "" for one that stands on its
    // own.
    std::string like;
    // Place in the list of references, which decides ties; those of one order come by name.
    int order = 1000;
    // Where all hold, the reference is chosen before the one that it is like; where one does not, it is no
    // candidate.
    std::vector<ReferenceNeed> needs;
    std::vector<ReferenceNode> nodes;
    std::vector<std::pair<int, int>> edges; // node indices, first < second
    std::vector<ReferenceJoint> joints;
    std::vector<ReferenceClip> clips; // the first one is the default
};

// Which clips a reference plays: those of its file, or, where the thesis describes any (6.1: humanoid and
// quadruped), these.
enum class ClipSet { standard, thesis };
// The clips of thesis 6.1 for the reference, by the parts that its joints move: of a humanoid arms and legs
// swing forward and backward, out of the picture's plane, and the head goes left and right; of a quadruped
// the legs go left and right, in the plane, the tail forward and backward, out of it, and the head up and
// down. One clip, `walk`. Of any other reference its own clips, since the thesis describes none. Angles and
// phases are ours: the thesis prints none. No errors.
std::vector<ReferenceClip> thesis_clips(const ReferenceSkeleton& reference);

// Has arms and legs: joints arm_left, arm_right, leg_left and leg_right. Recorded motions and VRM names are
// for these. No errors. Own.
bool is_humanoid(const ReferenceSkeleton& reference);

// A reference from the text of its file. `source`: name for messages. Error(input) names `source`, the place
// and the fact. Format: docs/formats.md.
ReferenceSkeleton parse_reference(std::span<const unsigned char> json, const std::string& source);

// The compiled-in references (the folder references/), by their order: humanoid, quadruped, flying, bird,
// insect, fish, bust; those of `directory`, when not empty, replace the ones of their name or follow.
// Error(input) names the file.
std::vector<ReferenceSkeleton> load_references(const std::filesystem::path& directory = {},
                                               ClipSet clips = ClipSet::standard);

// The reference of that name. Error(input) lists the names that there are.
const ReferenceSkeleton& find_reference(const std::vector<ReferenceSkeleton>& references,
                                        const std::string& name);

// A reference between two (thesis 6.2, the gryphon). Ends of one label and nearest place are one; what
// `second` has more of a label is added to `first` (a quadruped gets wings, a bird gets two more legs), with
// its joint. Each clip of `first` is mixed with the second's clip of that name, or its first one: parts of
// which one reference has more move as that one says, the others by `share` (0 to 1) as the first and by
// 1 − `share` as the second says. Name, like, needs and the first nodes are the first's. No errors.
ReferenceSkeleton blend(const ReferenceSkeleton& first, const ReferenceSkeleton& second, double share);

} // namespace pantin
