#include "rigging/bones.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace pantin {
namespace {

constexpr double stubby = 1.6;    // a limb shorter than this many widths is one stiff bone
constexpr double long_tail = 5.0; // a tail longer than this many widths gets one more bone

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
    if (limb.label == Label::head || limb.length() < stubby * limb.width) return 1;
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

} // namespace

Skeleton make_bones(const Limbs& limbs, const ReferenceSkeleton& reference, bool mirrored, int limb_segments,
                    Point2d head_centre) {
    Skeleton skeleton;
    skeleton.bones.push_back(root_bone(reference, mirrored, limbs.root));
    for (const Limb& limb : limbs.limbs) {
        LimbBones placed;
        placed.first = static_cast<int>(skeleton.bones.size());
        const int count = segments_of(limb, limb_segments);
        for (int i = 0; i <= count; ++i) placed.joints.push_back(limb.length() * i / count);
        const std::string name = unused_name(base_name(reference, limb.reference_end), skeleton.bones);
        for (int i = 0; i < count; ++i) {
            Bone bone;
            bone.name = i == 0 ? name : name + "." + std::to_string(i);
            bone.parent = i > 0 ? placed.first + i - 1 : 0;
            if (i == 0 && limb.parent >= 0)
                bone.parent = bone_at(skeleton.limbs[limb.parent], limb.parent_position);
            bone.head = limb.at(placed.joints[i]);
            bone.tail = limb.label == Label::head ? head_centre : limb.at(placed.joints[i + 1]);
            bone.label = limb.label;
            bone.reference_joint = joint_of(reference, limb.reference_end);
            bone.segment = i;
            bone.mirrored = mirrored;
            bone.phase_shift = limb.phase_shift;
            bone.freedom = freedom_of(limb);
            skeleton.bones.push_back(bone);
        }
        skeleton.limbs.push_back(placed);
    }
    return skeleton;
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
