// SPDX-License-Identifier: MIT
// In come limbs, or mapped end-effectors, and the reference with its joints; out go bones. As in the thesis
// (4.6) one per end-effector, from its neighbour in the graph to the end (ERRATA 20); by default our own:
// several along each limb, jointed at its bend, and a spine.
#include "rigging/bones.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace pantin {
namespace {

constexpr double stubby = 1.6;      // a limb shorter than this many widths is one stiff bone
constexpr double long_tail = 5.0;   // a tail longer than this many widths gets one more bone
constexpr double long_neck = 2.2;   // a head with its neck longer than this many widths gets two bones
constexpr double bend_share = 0.06; // a limb that leaves its chord by this share of its length bends there
constexpr double innermost_bend = 0.35; // of the length, and as far from the tip
constexpr double shortest_spine = 0.12; // of the longer side of the skeleton's box
constexpr double spine_blend = 0.35;    // of the spine's length

int joint_of(const ReferenceSkeleton& reference, int node) {
    for (std::size_t j = 0; j < reference.joints.size(); ++j)
        if (reference.joints[j].node == node) return static_cast<int>(j);
    return -1;
}

std::string unused_name(const std::string& wanted, const std::vector<Bone>& bones) {
    const auto used = [&bones](const std::string& name) {
        return std::any_of(bones.begin(), bones.end(), [&name](const Bone& b) { return b.name == name; });
    };
    std::string name = wanted;
    for (int n = 2; used(name); ++n) name = wanted + "_" + std::to_string(n);
    return name;
}

Bone root_bone(const ReferenceSkeleton& reference, bool mirrored, Point2d root) {
    Bone bone;
    bone.name = reference.joints.empty() ? "hips" : reference.joints[0].name;
    bone.head = root;
    bone.tail = root + Point2d{0, -1};
    bone.reference_joint = reference.joints.empty() ? -1 : 0;
    bone.mirrored = mirrored;
    return bone;
}

std::string base_name(const ReferenceSkeleton& reference, int reference_end) {
    const int joint = joint_of(reference, reference_end);
    return joint >= 0 ? reference.joints[joint].name : reference.nodes[reference_end].name;
}

int segments_of(const Limb& limb, int limb_segments) {
    if (limb.label == Label::head) return limb_segments > 1 && limb.length() > long_neck * limb.width ? 2 : 1;
    if (limb.length() < stubby * limb.width) return 1;
    return limb_segments +
           (limb.label == Label::tail && limb_segments > 1 && limb.length() > long_tail * limb.width);
}

// Short, thick limbs and limbs that lie on the body move less, so that they neither shear nor tear the
// drawing: one as long as it is wide moves half as far (a wing, broad by nature, two thirds), one of two
// widths fully; from a quarter of the border in contact with the parent on the swing shrinks to a quarter.
double freedom_of(const Limb& limb) {
    if (limb.label == Label::head) return 1;
    const double slenderness = limb.width > 0 ? limb.length() / limb.width : 2;
    const double by_shape =
        std::clamp(0.5 + 0.5 * (slenderness - 1), limb.label == Label::wing ? 0.65 : 0.4, 1.0);
    const double by_contact = std::clamp(1 - 2.2 * (limb.contact - 0.25), 0.25, 1.0);
    return by_shape * by_contact;
}

// The bone of a limb that covers the position.
int bone_at(const LimbBones& bones, double position) {
    int segment = 0;
    while (segment + 1 < bones.count() && position >= bones.joints[segment + 1]) ++segment;
    return bones.first + segment;
}

// Where a limb of two bones is jointed: at its drawn elbow or knee, the point farthest from the chord; in the
// middle of a straight one.
double bend_of(const Limb& limb) {
    const Point2d from = limb.path.front(), chord = limb.path.back() - from;
    const double middle = limb.length() / 2, span = length(chord);
    double best = middle, farthest = bend_share * limb.length();
    if (span < 1e-9) return middle;
    for (std::size_t i = 0; i < limb.path.size(); ++i) {
        const double s = limb.position[i] / limb.length();
        if (s < innermost_bend || s > 1 - innermost_bend) continue;
        const double off = std::abs(cross(chord, limb.path[i] - from)) / span;
        if (off > farthest) farthest = off, best = limb.position[i];
    }
    return best;
}

std::vector<double> joints_of(const Limb& limb, int count) {
    std::vector<double> joints;
    for (int i = 0; i <= count; ++i) joints.push_back(limb.length() * i / count);
    if (count == 2 && limb.label != Label::head) joints[1] = bend_of(limb);
    return joints;
}

// The VRM name of a humanoid's bone; the performer faces the viewer, so the arm at the left of the picture is
// the right one.
std::string humanoid_name(const std::string& joint, int segment, bool mirrored) {
    const bool arm = joint.starts_with("arm_"), leg = joint.starts_with("leg_");
    if (!arm && !leg) return "";
    const std::string side = joint.ends_with("left") != mirrored ? "right" : "left";
    const std::string part = std::string(segment == 0 ? "Upper" : "Lower") + (arm ? "Arm" : "Leg");
    return side + part + (segment > 1 ? "." + std::to_string(segment - 1) : "");
}

class BoneMaker {
public:
    BoneMaker(const Limbs& limbs, const ReferenceSkeleton& reference, bool mirrored, int limb_segments,
              Point2d head_centre)
        : limbs_(limbs), reference_(reference), mirrored_(mirrored), limb_segments_(limb_segments),
          head_centre_(head_centre), humanoid_(is_humanoid(reference)), trunk_(reference.joints.size(), 0) {
        skeleton_.bones.push_back(root_bone(reference, mirrored, limbs.root));
        if (limb_segments > 1) add_spine();
        for (const Limb& limb : limbs.limbs) add_limb(limb);
    }
    Skeleton take() { return std::move(skeleton_); }

private:
    // Mean attachment of the limbs on the body whose joint hangs on the given one; false where there is none.
    bool attachment_of(int joint, Point2d& mean) const {
        int count = 0;
        mean = {};
        for (const Limb& limb : limbs_.limbs) {
            const int own = joint_of(reference_, limb.reference_end);
            if (limb.parent >= 0 || own < 0 || reference_.joints[own].parent != joint) continue;
            mean = mean + limb.path.front();
            ++count;
        }
        if (count > 0) mean = (1.0 / count) * mean;
        return count > 0;
    }

    double size() const {
        Point2d low = limbs_.root, high = low;
        for (const Limb& limb : limbs_.limbs)
            for (const Point2d& p : limb.path) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        return std::max(high.x - low.x, high.y - low.y);
    }

    // A joint that moves a node of the body becomes a bone between what hangs on the root and what hangs on
    // it.
    void add_spine() {
        for (std::size_t j = 1; j < reference_.joints.size(); ++j) {
            const ReferenceJoint& joint = reference_.joints[j];
            if (reference_.nodes[joint.node].label != Label::body || joint.parent != 0) continue;
            Point2d near, far;
            if (!attachment_of(static_cast<int>(j), far)) continue;
            if (!attachment_of(0, near)) near = limbs_.root;
            const double spine = distance(near, far);
            if (spine < shortest_spine * size()) continue;
            Bone bone = root_bone(reference_, mirrored_, 0.5 * (near + far));
            bone.name = joint.name;
            bone.parent = 0;
            bone.tail = far;
            bone.reference_joint = static_cast<int>(j);
            trunk_[j] = static_cast<int>(skeleton_.bones.size());
            skeleton_.spine.push_back(
                {trunk_[j], bone.head, (1 / spine) * (far - near), spine_blend * spine});
            skeleton_.bones.push_back(bone);
        }
    }

    std::string name_of(const Limb& limb, int segment, int count) const {
        const std::string base = base_name(reference_, limb.reference_end);
        const std::string human =
            humanoid_ && limb.label == Label::limb ? humanoid_name(base, segment, mirrored_) : "";
        if (!human.empty()) return human;
        if (limb.label == Label::head) return count > 1 && segment == 0 ? "neck" : base;
        return segment == 0 ? base : base + "." + std::to_string(segment);
    }

    int parent_of(const Limb& limb, int joint) const {
        if (limb.parent >= 0) return bone_at(skeleton_.limbs[limb.parent], limb.parent_position);
        return joint < 0 || reference_.joints[joint].parent < 0 ? 0 : trunk_[reference_.joints[joint].parent];
    }

    void add_limb(const Limb& limb) {
        const int count = segments_of(limb, limb_segments_), joint = joint_of(reference_, limb.reference_end);
        const bool head = limb.label == Label::head;
        LimbBones placed;
        placed.first = static_cast<int>(skeleton_.bones.size());
        placed.joints = joints_of(limb, count);
        for (int i = 0; i < count; ++i) {
            Bone bone;
            bone.name = unused_name(name_of(limb, i, count), skeleton_.bones);
            bone.parent = i > 0 ? placed.first + i - 1 : parent_of(limb, joint);
            bone.head = limb.at(placed.joints[i]);
            bone.tail = head && i + 1 == count ? head_centre_ : limb.at(placed.joints[i + 1]);
            bone.label = limb.label;
            bone.reference_joint = joint;
            bone.segment = head ? 0 : i; // neck and head share the head's turns
            bone.mirrored = mirrored_;
            bone.phase_shift = limb.phase_shift;
            bone.freedom = freedom_of(limb) / (head ? count : 1);
            skeleton_.bones.push_back(bone);
        }
        skeleton_.limbs.push_back(placed);
    }

    const Limbs& limbs_;
    const ReferenceSkeleton& reference_;
    const bool mirrored_;
    const int limb_segments_;
    const Point2d head_centre_;
    const bool humanoid_;
    std::vector<int> trunk_; // bone that the limbs of each joint hang on
    Skeleton skeleton_;
};

} // namespace

Skeleton make_bones(const Limbs& limbs, const ReferenceSkeleton& reference, bool mirrored, int limb_segments,
                    Point2d head_centre) {
    return BoneMaker(limbs, reference, mirrored, limb_segments, head_centre).take();
}

std::vector<Bone> make_thesis_bones(const SkeletonGraph& graph, const ReferenceSkeleton& reference,
                                    const Mapping& mapping, bool mirrored, Point2d root) {
    std::vector<Bone> bones = {root_bone(reference, mirrored, root)};
    for (const EndPair& pair : mapping.pairs) {
        const SkeletonVertex& end = graph.vertices[pair.end];
        Bone bone;
        bone.name = unused_name(base_name(reference, pair.reference_end), bones);
        bone.parent = 0;
        bone.head = root;
        for (const SkeletonEdge& edge : graph.edges)
            if (edge.u == pair.end || edge.v == pair.end) {
                const SkeletonVertex& inner = graph.vertices[edge.u == pair.end ? edge.v : edge.u];
                bone.head = {inner.x, inner.y};
                break;
            }
        bone.tail = {end.x, end.y};
        bone.label = end.label;
        bone.reference_joint = joint_of(reference, pair.reference_end);
        bone.mirrored = mirrored;
        bones.push_back(bone);
    }
    return bones;
}

} // namespace pantin
