// SPDX-License-Identifier: MIT
// Thesis 4.6 and 6.1: the clips of a reference skeleton on the bones of a character. Rotations are relative
// to the pose as drawn, so any drawing starts from its own rest pose. Our additions: swings shrink with short
// limbs, and the phases of legs alternate when the drawing has more or fewer of them than the reference.
#include <algorithm>
#include <cmath>

#include "animation/footing.hpp"
#include "animation/vector.hpp"
#include "core/math.hpp"
#include "pantin/animation.hpp"

namespace pantin {
namespace {

// Direction of a bone at rest, y up.
Point2d direction_of(const Bone& bone) {
    const Point2d d{bone.tail.x - bone.head.x, bone.head.y - bone.tail.y};
    const double n = length(d);
    return n > 1e-9 ? Point2d{d.x / n, d.y / n} : Point2d{0, 1};
}

// "leg_front_left" belongs to the group "leg".
std::string group_of(const std::string& joint) { return joint.substr(0, joint.find('_')); }

double first_phase(const ReferenceClip& clip, int joint) {
    for (const ReferenceTrack& track : clip.tracks)
        if (track.joint == joint && track.segment == 0) return track.phase;
    return 0;
}

class Retargeting {
public:
    Retargeting(const Rig& rig, const ReferenceSkeleton& reference, const ReferenceClip& clip)
        : rig_(rig), reference_(reference), clip_(clip), shift_(rig.bones.size()) {
        for (std::size_t b = 0; b < rig.bones.size(); ++b) shift_[b] = rig.bones[b].phase_shift;
        for (std::size_t j = 0; j < reference.joints.size(); ++j)
            alternate(group_of(reference.joints[j].name));
        for (std::size_t b = 0; b < rig.bones.size(); ++b)
            if (rig.bones[b].segment > 0) shift_[b] = shift_[rig.bones[b].parent];
    }

    // Turn against the parent in the drawing's plane, radians.
    double plane_turn(int bone, double cycle) const {
        const Bone& b = rig_.bones[bone];
        const double side = b.mirrored ? -1 : 1, outwards = direction_of(b).x >= 0 ? 1 : -1;
        double z = 0;
        for (const ReferenceTrack& track : clip_.tracks) {
            if (track.joint != b.reference_joint || track.segment != b.segment) continue;
            switch (track.kind) {
            case TrackKind::z:
                z += side * value(track, bone, cycle);
                break;
            case TrackKind::lift:
                z += outwards * value(track, bone, cycle);
                break;
            case TrackKind::x:
            case TrackKind::y:
            case TrackKind::flap:
            case TrackKind::twist: // rotation()
            case TrackKind::tx:
            case TrackKind::ty: // translation()
            case TrackKind::step:
            case TrackKind::plant:
                break; // Footing
            }
        }
        return z * b.freedom * (math::pi / 180);
    }

    Quaternion rotation(int bone, double cycle, double plane_turn, double flap) const {
        const Bone& b = rig_.bones[bone];
        double x = 0, y = 0, twist = 0;
        const Point2d d = direction_of(b);
        const double side = b.mirrored ? -1 : 1;
        for (const ReferenceTrack& track : clip_.tracks) {
            if (track.joint != b.reference_joint || track.segment != b.segment) continue;
            const double angle = b.freedom * value(track, bone, cycle) * (math::pi / 180);
            switch (track.kind) {
            case TrackKind::x:
                x += angle;
                break;
            case TrackKind::y:
                y += side * angle;
                break;
            case TrackKind::flap:
                flap += angle;
                break;
            case TrackKind::twist:
                twist += angle;
                break;
            case TrackKind::z:
            case TrackKind::lift: // plane_turn()
            case TrackKind::tx:
            case TrackKind::ty: // translation()
            case TrackKind::step:
            case TrackKind::plant:
                break; // Footing
            }
        }
        return normalised(about({0, 0, 1}, plane_turn) * about({d.y, -d.x, 0}, flap) *
                          about({d.x, d.y, 0}, twist) * about({0, 1, 0}, y) * about({1, 0, 0}, x));
    }

    const std::vector<double>& shift() const { return shift_; }

    Vec3 translation(double cycle) const {
        Vec3 t;
        const double side = rig_.bones[0].mirrored ? -1 : 1;
        for (const ReferenceTrack& track : clip_.tracks) {
            if (track.joint != rig_.bones[0].reference_joint) continue;
            if (track.kind == TrackKind::tx) t.x += side * value(track, 0, cycle);
            if (track.kind == TrackKind::ty) t.y += value(track, 0, cycle);
        }
        return t;
    }

private:
    double value(const ReferenceTrack& track, int bone, double cycle) const {
        const double turns = track.cycles * cycle + track.phase + track.cycles * shift_[bone];
        return track.offset + track.amplitude * math::sin(2 * math::pi * turns);
    }
    static Quaternion about(Vec3 axis, double angle) {
        if (angle == 0) return {};
        const double half = angle / 2, s = math::sin(half);
        return {s * axis.x, s * axis.y, s * axis.z, math::cos(half)};
    }

    // Legs of a group whose number differs from the reference's: from left to right each half a cycle after
    // the last.
    void alternate(const std::string& group) {
        std::vector<int> legs, joints;
        for (std::size_t b = 0; b < rig_.bones.size(); ++b) {
            const Bone& bone = rig_.bones[b];
            if (bone.label == Label::limb && bone.segment == 0 && bone.reference_joint >= 0 &&
                group_of(reference_.joints[bone.reference_joint].name) == group) {
                legs.push_back(static_cast<int>(b));
                joints.push_back(bone.reference_joint);
            }
        }
        std::sort(joints.begin(), joints.end());
        joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
        const auto wanted = std::count_if(reference_.joints.begin(), reference_.joints.end(),
                                          [&](const ReferenceJoint& j) { return group_of(j.name) == group; });
        if (legs.size() == joints.size() && static_cast<std::ptrdiff_t>(legs.size()) == wanted) return;
        std::stable_sort(legs.begin(), legs.end(),
                         [&](int a, int b) { return rig_.bones[a].tail.x < rig_.bones[b].tail.x; });
        for (std::size_t i = 0; i < legs.size(); ++i)
            shift_[legs[i]] =
                0.5 * static_cast<double>(i % 2) - first_phase(clip_, rig_.bones[legs[i]].reference_joint);
    }

    const Rig& rig_;
    const ReferenceSkeleton& reference_;
    const ReferenceClip& clip_;
    std::vector<double> shift_; // per bone, in cycles
};

} // namespace

BoneAnimation retarget(const Rig& rig, const ReferenceSkeleton& reference, const ReferenceClip& clip,
                       int samples) {
    const Retargeting retargeting(rig, reference, clip);
    const Footing footing(rig, clip, retargeting.shift());
    BoneAnimation animation;
    animation.name = clip.name;
    animation.duration = clip.duration;
    animation.ground_speed = footing.ground_speed();
    animation.rotations.resize(rig.bones.size());
    samples = std::max(samples, 1);
    std::vector<double> turns(rig.bones.size()), flaps(rig.bones.size());
    for (int i = 0; i <= samples; ++i) {
        animation.times.push_back(clip.duration * (static_cast<double>(i) / samples));
        const double cycle =
            static_cast<double>(i % samples) / samples; // the last pose is the first, to the bit
        for (std::size_t b = 0; b < turns.size(); ++b)
            turns[b] = retargeting.plane_turn(static_cast<int>(b), cycle);
        Vec3 root = retargeting.translation(cycle);
        std::fill(flaps.begin(), flaps.end(), 0.0);
        footing.apply(cycle, turns, flaps, root);
        for (std::size_t b = 0; b < turns.size(); ++b)
            animation.rotations[b].push_back(
                retargeting.rotation(static_cast<int>(b), cycle, turns[b], flaps[b]));
        animation.root_translation.push_back(root);
    }
    return animation;
}

} // namespace pantin
