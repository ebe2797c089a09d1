// SPDX-License-Identifier: MIT
// The motions of thesis 6.1: which part moves in which direction is the thesis's, angles and phases are ours.
#include <algorithm>

#include "pantin/reference.hpp"

namespace pantin {

namespace {

constexpr double duration = 1.2;  // seconds
constexpr double swing = 25;      // degrees, of arms and legs
constexpr double tail_swing = 30; // of a tail
constexpr double head_turn = 10;  // of a head

// Of a reference that has the four legs of the thesis's quadruped, and no arms.
bool is_quadruped(const ReferenceSkeleton& reference) {
    return (reference.like.empty() ? reference.name : reference.like) == "quadruped";
}

Label label_of(const ReferenceSkeleton& reference, const ReferenceJoint& joint) {
    return joint.node < 0 ? Label::body : reference.nodes[static_cast<std::size_t>(joint.node)].label;
}

ReferenceTrack track(std::size_t joint, TrackKind kind, double amplitude, double phase) {
    ReferenceTrack t;
    t.joint = static_cast<int>(joint);
    t.kind = kind;
    t.amplitude = amplitude;
    t.phase = phase;
    return t;
}

// Left and right in turn, an arm with the leg of the other side, a hind leg with the front leg of the other.
double phase_of(const std::string& joint) {
    const bool right = joint.find("right") != std::string::npos;
    const bool second = joint.starts_with("arm") || joint.find("hind") != std::string::npos;
    return right != second ? 0.5 : 0;
}

} // namespace

std::vector<ReferenceClip> thesis_clips(const ReferenceSkeleton& reference) {
    const bool quadruped = is_quadruped(reference);
    if (!quadruped && !is_humanoid(reference)) return reference.clips;
    ReferenceClip walk{"walk", duration, {}};
    for (std::size_t j = 0; j < reference.joints.size(); ++j) {
        const ReferenceJoint& joint = reference.joints[j];
        const Label part = label_of(reference, joint);
        if (part == Label::limb)
            walk.tracks.push_back(
                track(j, quadruped ? TrackKind::z : TrackKind::flap, swing, phase_of(joint.name)));
        else if (part == Label::tail && quadruped)
            walk.tracks.push_back(track(j, TrackKind::flap, tail_swing, 0));
        else if (part == Label::head)
            walk.tracks.push_back(track(j, quadruped ? TrackKind::lift : TrackKind::z, head_turn, 0.25));
    }
    return {walk};
}

} // namespace pantin
