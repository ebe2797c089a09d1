// SPDX-License-Identifier: MIT
// This work is based on:
// H. J. Smith et al., A Method for Animating Children's Drawings of the Human Figure, 2023, section 3.4:
// limbs take the directions of the motion, each projected on the plane in which it moves most. Differences:
// the plane is the frontal or the sagittal one by the variance of the limb's tip (not by principal components
// of its joints), and the recorded figure is turned to the front all the time.
#include <algorithm>
#include <array>
#include <cmath>

#include "animation/body_axes.hpp"
#include "animation/follow.hpp"
#include "animation/limb_angles.hpp"
#include "animation/vector.hpp"
#include "core/math.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

// Before or behind the trunk: nearer to it than the first share of a limb's length counts as beside it, and
// from the second on as wholly before or behind it. World units of depth.
constexpr double beside = 0.05, apart = 0.15;
constexpr double before_trunk = 0.02, before_each_other = 0.02;
constexpr double long_way = 1.5; // heights of the character
constexpr double camera_seconds = 1.5;

double rest_angle(const Bone& bone) {
    return math::atan2(bone.head.y - bone.tail.y, bone.tail.x - bone.head.x);
}

// What every bone of a humanoid does: its turn against the drawing, in the picture's plane, one a pose.
class Follower {
public:
    Follower(const Rig& rig, const ReferenceSkeleton& reference, const Recording& recording,
             const MotionJoints& joints)
        : rig_(rig), reference_(reference), poses_(recording.poses()), upright_(poses_), joints_(joints),
          rest_(recording.rest()) {
        turns_.assign(rig.bones.size(), std::vector<double>(poses_.size()));
        depths_.assign(rig.bones.size(), {});
        find_trunk();
        for (std::size_t b = 0; b < rig.bones.size(); ++b) {
            if (b == 0)
                turn_to(b, trunk_, math::pi / 2);
            else
                drive(b);
        }
    }
    const BoneTurns& turns() const { return turns_; }
    // Of every bone; limbs before the trunk are before it in the picture.
    std::vector<std::vector<double>> depths() const { return depths_; }

private:
    // Without neck and head, the shoulders say where the trunk is.
    Vec3 trunk_of(const std::vector<Vec3>& pose) const {
        const auto at = [&](int joint) { return pose[static_cast<std::size_t>(joint)]; };
        const int top = joints_.neck >= 0 ? joints_.neck : joints_.head;
        const Vec3 end =
            top >= 0 ? at(top) : 0.5 * (at(joints_.left.upper_arm) + at(joints_.right.upper_arm));
        return end - at(joints_.hips);
    }

    // A direction whose lean, forwards or backwards, is that against the recorded figure's own rest: backs
    // are bent and necks are tilted in many of them.
    static Vec3 unbent(Vec3 v, Vec3 at_rest) {
        const double n = std::sqrt(at_rest.y * at_rest.y + at_rest.z * at_rest.z);
        if (!(n > 0.3 * length(at_rest))) return v;
        const double c = at_rest.y / n, s = at_rest.z / n;
        return {v.x, v.y * c + v.z * s, -v.y * s + v.z * c};
    }

    // The trunk's angle in the picture. Where it is seen from the side, limbs are looked at as if the trunk
    // stood upright, and turned with it: arms that hang from a crawling figure hang from the drawn one.
    void find_trunk() {
        Directions trunk;
        for (const RecordedPose& p : poses_)
            trunk.push_back(rest_.empty() ? trunk_of(p.joints) : unbent(trunk_of(p.joints), trunk_of(rest_)));
        const bool side = seen_from_the_side(trunk);
        trunk_ = angles_in_picture(trunk, poses_, side);
        if (trunk_.empty()) trunk_.assign(poses_.size(), math::pi / 2);
        carried_.assign(poses_.size(), 0);
        if (!side) return;
        double c = 1, s = 0;
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            const double n = std::sqrt(trunk[i].y * trunk[i].y + trunk[i].z * trunk[i].z);
            if (n > 0.2 * length(trunk[i])) c = trunk[i].y / n, s = trunk[i].z / n;
            for (Vec3& v : upright_[i].joints) v = {v.x, v.y * c + v.z * s, -v.y * s + v.z * c};
            carried_[i] = trunk_[i] - math::pi / 2;
        }
    }

    void drive(std::size_t b) {
        const Bone& bone = rig_.bones[b];
        const std::string name =
            bone.reference_joint >= 0 ? reference_.joints[bone.reference_joint].name : "";
        const bool arm = name.starts_with("arm"), leg = name.starts_with("leg");
        if (arm || leg) {
            const MotionJoints::Side& side = shown_left(bone, name) ? joints_.right : joints_.left;
            const std::array<int, 3> chain = arm ? std::array<int, 3>{side.upper_arm, side.forearm, side.hand}
                                                 : std::array<int, 3>{side.thigh, side.shin, side.foot};
            limb(b, chain);
        } else if (name == "head") {
            head(b);
        } else {
            rest_on_parent(b);
        }
    }

    void rest_on_parent(std::size_t b) {
        const auto parent = static_cast<std::size_t>(rig_.bones[b].parent);
        turns_[b] = turns_[parent];
        depths_[b] = depths_[parent];
    }

    void limb(std::size_t b, const std::array<int, 3>& chain) {
        const Bone& bone = rig_.bones[b];
        if (bone.segment > 1) return rest_on_parent(b);
        const auto from = static_cast<std::size_t>(bone.segment);
        const int to = bone.segment == 0 && !goes_on(rig_, b) ? chain[2] : chain[from + 1];
        const Directions own = directions_of(upright_, chain[from], to);
        const bool side = seen_from_the_side(directions_of(upright_, chain[0], chain[2]));
        std::vector<double> angles = angles_in_picture(own, upright_, side);
        if (angles.empty()) angles = angles_in_picture(own, upright_, !side);
        if (angles.empty()) return rest_on_parent(b);
        for (std::size_t i = 0; i < angles.size(); ++i) angles[i] += carried_[i];
        turn_to(b, angles, rest_angle(bone));
        if (!rig_.solid) depths_[b] = depths_of(chain[0], chain[from], to, chain);
    }

    // A head keeps the way it is drawn and leans as the recorded one; one without a length of its own goes
    // with the neck, or with the body.
    void head(std::size_t b) {
        for (const auto& [from, to] :
             {std::pair{joints_.head, joints_.head_end}, {joints_.neck, joints_.head}}) {
            if (from < 0 || to < 0 || from == to) continue;
            Directions own = directions_of(poses_, from, to);
            if (!rest_.empty()) {
                const Vec3 at_rest =
                    rest_[static_cast<std::size_t>(to)] - rest_[static_cast<std::size_t>(from)];
                for (Vec3& v : own) v = unbent(v, at_rest);
            }
            // With the trunk where that is seen: the two are one figure.
            std::vector<double> angles = angles_in_picture(own, poses_, seen_from_the_side(own));
            if (angles.empty()) continue;
            return turn_to(b, angles, math::pi / 2);
        }
        rest_on_parent(b);
    }

    void turn_to(std::size_t b, const std::vector<double>& angles, double rest) {
        const Bone& bone = rig_.bones[b];
        double last = 0;
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            const double parent = bone.parent >= 0 ? turns_[static_cast<std::size_t>(bone.parent)][i] : 0;
            const double against_parent = nearest_turn(angles[i] - rest - parent, last);
            last = against_parent;
            turns_[b][i] = parent + bone.freedom * against_parent;
        }
        if (bone.parent >= 0) depths_[b] = depths_[static_cast<std::size_t>(bone.parent)];
    }

    // Of the middle of the bone from `a` to `b`, measured from the limb's root along the chest's own
    // forwards, in lengths of the limb.
    std::vector<double> depths_of(int root, int a, int b, const std::array<int, 3>& chain) const {
        std::vector<double> depths;
        for (const RecordedPose& p : poses_) {
            const auto at = [&](int joint) { return p.joints[static_cast<std::size_t>(joint)]; };
            const double size = distance(at(chain[0]), at(chain[1])) + distance(at(chain[1]), at(chain[2]));
            const Vec3 forwards = cross(leftwards(p.joints, joints_), trunk_of(p.joints));
            const double n = length(forwards) * size;
            const double ahead = n > 1e-12 ? dot(0.5 * (at(a) + at(b)) - at(root), forwards) / n : 0;
            const double whole = std::clamp((std::abs(ahead) - beside) / (apart - beside), 0.0, 1.0);
            depths.push_back((ahead > 0 ? whole : -whole) *
                             (before_trunk + before_each_other * std::abs(ahead)));
        }
        return depths;
    }

    const Rig& rig_;
    const ReferenceSkeleton& reference_;
    const std::vector<RecordedPose>& poses_;
    std::vector<RecordedPose> upright_; // the poses, turned so that a trunk seen from the side stands upright
    const MotionJoints& joints_;
    const std::vector<Vec3>& rest_;
    std::vector<double> trunk_, carried_; // its angle; what limbs are turned with it; one a pose
    BoneTurns turns_;
    std::vector<std::vector<double>> depths_;
};

// Mean length of the legs in world units; 0 without legs.
double drawn_leg_length(const Rig& rig, const ReferenceSkeleton& reference) {
    double sum = 0;
    int legs = 0;
    for (const Bone& bone : rig.bones) {
        if (bone.reference_joint < 0 || !reference.joints[bone.reference_joint].name.starts_with("leg"))
            continue;
        sum += distance(bone.head, bone.tail) / rig.height;
        legs += bone.segment == 0;
    }
    return legs > 0 ? sum / legs : 0;
}

// The way itself, smoothed: what a figure does on the spot stays to be seen.
std::vector<double> camera_along(const std::vector<Vec3>& way) {
    const auto reach = static_cast<std::ptrdiff_t>(camera_seconds * key_rate / 2);
    const std::ptrdiff_t count = std::ssize(way);
    std::vector<double> camera;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t span = std::min({reach, i, count - 1 - i});
        double sum = 0;
        for (std::ptrdiff_t k = i - span; k <= i + span; ++k) sum += way[static_cast<std::size_t>(k)].x;
        camera.push_back(sum / static_cast<double>(2 * span + 1));
    }
    return camera;
}

void set_camera(BoneAnimation& animation, Way way) {
    const auto [least, most] =
        std::minmax_element(animation.root_translation.begin(), animation.root_translation.end(),
                            [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    if (way == Way::follow || (way == Way::automatic && most->x - least->x > long_way))
        animation.camera = camera_along(animation.root_translation);
}

// Turns against the drawing to turns against the parent bone.
std::vector<std::vector<Quaternion>> rotations_of(const Rig& rig, const BoneTurns& turns) {
    std::vector<std::vector<Quaternion>> rotations(turns.size());
    for (std::size_t b = 0; b < turns.size(); ++b)
        for (std::size_t i = 0; i < turns[b].size(); ++i) {
            const int parent = rig.bones[b].parent;
            const double angle = turns[b][i] - (parent >= 0 ? turns[static_cast<std::size_t>(parent)][i] : 0);
            rotations[b].push_back({0, 0, math::sin(angle / 2), math::cos(angle / 2)});
        }
    return rotations;
}

bool any(const std::vector<std::vector<double>>& depths) {
    return std::any_of(depths.begin(), depths.end(), [](const std::vector<double>& d) { return !d.empty(); });
}

} // namespace

bool goes_on(const Rig& rig, std::size_t bone) {
    return std::any_of(rig.bones.begin(), rig.bones.end(), [&](const Bone& other) {
        return other.parent == static_cast<int>(bone) &&
               other.reference_joint == rig.bones[bone].reference_joint;
    });
}

bool shown_left(const Bone& bone, const std::string& joint) {
    return joint.ends_with("left") != bone.mirrored;
}

bool can_follow(const ReferenceSkeleton& reference, BodyPlan plan) {
    const auto has = [&](const char* name) {
        return std::any_of(reference.joints.begin(), reference.joints.end(),
                           [&](const ReferenceJoint& j) { return j.name == name; });
    };
    switch (plan) {
    case BodyPlan::humanoid:
        return is_humanoid(reference);
    case BodyPlan::quadruped:
        return has("leg_front_left") && has("leg_hind_left") && !has("leg_middle_left");
    case BodyPlan::bird:
        return has("wing_left") && has("wing_right");
    }
    return false;
}

BoneAnimation follow(const Rig& rig, const ReferenceSkeleton& reference, const Motion& motion,
                     const MotionJoints& joints, const FollowOptions& options) {
    const Recording recording(motion, joints, options);
    const std::vector<RecordedPose>& poses = recording.poses();
    BoneAnimation animation;
    animation.name = motion.name;
    double forwards = 1; // 1: the character looks to the right of the picture, where the way leads
    if (joints.plan == BodyPlan::humanoid) {
        const Follower follower(rig, reference, recording, joints);
        animation.rotations = rotations_of(rig, follower.turns());
        animation.depths = follower.depths();
        for (std::vector<double>& d : animation.depths)
            if (d.empty()) d.assign(poses.size(), 0);
        if (!any(follower.depths())) animation.depths.clear();
    } else {
        const AnimalFollower follower(rig, reference, recording, joints);
        animation.rotations = rotations_of(rig, follower.turns());
        forwards = follower.forwards();
    }
    const double scale = drawn_leg_length(rig, reference) / recording.leg_length();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        animation.times.push_back(static_cast<double>(i) / key_rate);
        animation.root_translation.push_back(
            {forwards * scale * poses[i].way, scale * (poses[i].height - recording.standing_height()), 0});
    }
    animation.duration = animation.times.back();
    set_camera(animation, options.way);
    return animation;
}

} // namespace pantin
