// SPDX-License-Identifier: MIT
// A reference between two: the gryphon of the thesis (6.2) has the legs of a quadruped and the wings of a
// bird.
#include <algorithm>
#include <cmath>
#include <vector>

#include "pantin/reference.hpp"
#include "reference/named.hpp"
#include "reference/tracks.hpp"

namespace pantin {
namespace {

bool is_end(const ReferenceSkeleton& skeleton, int node) {
    return std::count_if(skeleton.edges.begin(), skeleton.edges.end(),
                         [node](const auto& e) { return e.first == node || e.second == node; }) == 1;
}

std::vector<int> ends_with(const ReferenceSkeleton& skeleton, Label label) {
    std::vector<int> ends;
    for (int n = 0; n < std::ssize(skeleton.nodes); ++n)
        if (skeleton.nodes[n].label == label && is_end(skeleton, n)) ends.push_back(n);
    return ends;
}

double distance_of(const ReferenceNode& a, const ReferenceNode& b) {
    return distance(Point2d{a.x, a.y}, Point2d{b.x, b.y});
}

template <class T> std::string free_name(const std::vector<T>& list, std::string name) {
    while (index_of(list, name) >= 0) name += "_2";
    return name;
}

int nearest_body_node(const ReferenceSkeleton& skeleton, const ReferenceNode& node) {
    int best = 0;
    double least = -1;
    for (int n = 0; n < std::ssize(skeleton.nodes); ++n) {
        if (skeleton.nodes[n].label != Label::body || is_end(skeleton, n)) continue;
        const double d = distance_of(skeleton.nodes[n], node);
        if (least < 0 || d < least) best = n, least = d;
    }
    return best;
}

int joint_at(const ReferenceSkeleton& skeleton, int node) {
    for (int j = 0; j < std::ssize(skeleton.joints); ++j)
        if (skeleton.joints[j].node == node) return j;
    return -1;
}

// Whose tracks move a joint.
enum class Owner { both, first, second };

class Blender {
public:
    Blender(const ReferenceSkeleton& first, const ReferenceSkeleton& second, double share)
        : first_(first), second_(second), share_(share), result_(first), joint_(second.joints.size(), -1) {
        for (std::size_t j = 0; j < second.joints.size(); ++j)
            if (j == 0 || second.nodes[second.joints[j].node].label == Label::body)
                joint_[j] = j == 0 ? 0 : index_of(first.joints, second.joints[j].name);
        for (const Label label : part_labels)
            if (role_of(label) != PartRole::trunk) pair_ends(label);
        for (ReferenceClip& clip : result_.clips) mix(clip);
    }
    ReferenceSkeleton take() { return std::move(result_); }

private:
    Owner owner_of(const ReferenceSkeleton& skeleton, int joint) const {
        const Label label = skeleton.nodes[skeleton.joints[joint].node].label;
        if (label == Label::body) return Owner::both;
        const auto a = ends_with(first_, label).size(), b = ends_with(second_, label).size();
        return a == b ? Owner::both : a > b ? Owner::first : Owner::second;
    }

    // Each end of the first and the nearest one of the second are one; what the second has more is added.
    void pair_ends(Label label) {
        std::vector<int> spare = ends_with(second_, label);
        for (const int n : ends_with(first_, label)) {
            const auto nearest = std::min_element(spare.begin(), spare.end(), [&](int a, int b) {
                return distance_of(second_.nodes[a], first_.nodes[n]) <
                       distance_of(second_.nodes[b], first_.nodes[n]);
            });
            if (nearest == spare.end()) return;
            if (const int j = joint_at(second_, *nearest); j >= 0) joint_[j] = joint_at(first_, n);
            spare.erase(nearest);
        }
        for (const int n : spare) add_end(n);
    }

    void add_end(int n) {
        ReferenceNode node = second_.nodes[n];
        node.name = free_name(result_.nodes, node.name);
        const int body = nearest_body_node(result_, node), own = static_cast<int>(result_.nodes.size());
        result_.nodes.push_back(node);
        result_.edges.emplace_back(body, own);
        const int j = joint_at(second_, n);
        if (j < 0) return;
        joint_[j] = static_cast<int>(result_.joints.size());
        result_.joints.push_back(
            {free_name(result_.joints, second_.joints[j].name), std::max(0, joint_at(result_, body)), own});
    }

    const ReferenceClip* partner_of(const ReferenceClip& clip) const {
        const int same = index_of(second_.clips, clip.name);
        if (second_.clips.empty()) return nullptr;
        return &second_.clips[same >= 0 ? static_cast<std::size_t>(same) : 0];
    }

    // The partner's clip runs a whole number of times within the clip. Feet that both have keep the first's
    // ground.
    void mix(ReferenceClip& clip) const {
        const ReferenceClip* partner = partner_of(clip);
        if (!partner) return;
        std::erase_if(clip.tracks,
                      [&](const ReferenceTrack& t) { return owner_of(first_, t.joint) == Owner::second; });
        for (ReferenceTrack& track : clip.tracks)
            if (owner_of(first_, track.joint) == Owner::both && !on_ground(track.kind)) scale(track, share_);
        const int times = std::max(1, static_cast<int>(std::rint(clip.duration / partner->duration)));
        for (ReferenceTrack track : partner->tracks) {
            const Owner owner = owner_of(second_, track.joint);
            if (joint_[track.joint] < 0 || owner == Owner::first ||
                (owner == Owner::both && on_ground(track.kind)))
                continue;
            if (owner == Owner::both) scale(track, 1 - share_);
            track.joint = joint_[track.joint];
            if (!on_ground(track.kind)) track.cycles *= times;
            clip.tracks.push_back(track);
        }
    }

    static void scale(ReferenceTrack& track, double factor) {
        track.amplitude *= factor;
        track.offset *= factor;
    }

    const ReferenceSkeleton &first_, &second_;
    const double share_;
    ReferenceSkeleton result_;
    std::vector<int> joint_; // of the second's joints, in the result; −1: none
};

} // namespace

ReferenceSkeleton blend(const ReferenceSkeleton& first, const ReferenceSkeleton& second, double share) {
    return Blender(first, second, share).take();
}

} // namespace pantin
