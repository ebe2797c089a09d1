// SPDX-License-Identifier: MIT
// This work is based on:
// H. J. Smith et al., A Method for Animating Children's Drawings of the Human Figure, 2023, section 3.4:
// limbs take the directions of the motion, each projected on the plane in which it moves most. Differences:
// the plane is the frontal or the sagittal one by the variance of the limb's tip (not by principal components
// of its joints), and the recorded figure is turned to the front all the time.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "animation/vector.hpp"
#include "core/math.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

constexpr double rate = 30;            // key poses per second
constexpr double facing_seconds = 0.5; // window over which the figure's facing is averaged
constexpr double still = 1e-3;         // variance of a limb's way, of its squared length
constexpr double least_projection =
    0.2; // of a limb's length: shorter ones have no direction, the last one stays

double norm(Vec3 v) { return std::sqrt(dot(v, v)); }
Vec3 unit(Vec3 v, Vec3 otherwise) { return norm(v) > 1e-12 ? (1 / norm(v)) * v : otherwise; }

// The joints' places, in the recorded figure's own directions: x to its left (the right of the picture), y
// up, z forwards. The hips are the origin; `travelled` is their way from the start along x and z, and their
// height above the ground.
struct Pose {
    std::vector<Vec3> joints;
    Vec3 travelled;
};

using Frame = std::vector<Vec3>;

std::vector<Frame> resampled(const Motion& motion, double start, double seconds) {
    const double length = motion.frame_time * static_cast<double>(motion.frames() - 1);
    const double first = std::clamp(start, 0.0, length), last = std::min(length, first + seconds);
    const int count = std::max(1, static_cast<int>(std::floor((last - first) * rate + 0.01)));
    std::vector<Frame> frames;
    for (int i = 0; i <= count; ++i) {
        const double at = std::min(first + i / rate, last) / motion.frame_time;
        const auto before = std::min(static_cast<std::size_t>(at), motion.frames() - 1);
        const std::size_t after = std::min(before + 1, motion.frames() - 1);
        const double share = at - static_cast<double>(before);
        Frame a = joint_positions(motion, before);
        const Frame b = joint_positions(motion, after);
        for (std::size_t j = 0; j < a.size(); ++j) a[j] = a[j] + share * (b[j] - a[j]);
        frames.push_back(std::move(a));
    }
    return frames;
}

class Recording {
public:
    Recording(const Motion& motion, const MotionJoints& joints, double start, double seconds)
        : joints_(joints), frames_(resampled(motion, start, seconds)) {
        find_up();
        find_facing();
        find_legs();
        for (std::size_t i = 0; i < frames_.size(); ++i) poses_.push_back(pose(i));
    }

    const std::vector<Pose>& poses() const { return poses_; }
    double leg_length() const { return leg_length_; }
    double standing_height() const { return standing_height_; }
    int neck() const { return joints_.neck >= 0 ? joints_.neck : joints_.head; }

private:
    Vec3 at(std::size_t frame, int joint) const { return frames_[frame][static_cast<std::size_t>(joint)]; }
    Vec3 shoulders(std::size_t frame) const {
        return 0.5 * (at(frame, joints_.left.upper_arm) + at(frame, joints_.right.upper_arm));
    }

    // Files are y up or z up: the axis along which shoulders are above feet.
    void find_up() {
        Vec3 sum;
        for (std::size_t i = 0; i < frames_.size(); ++i)
            sum = sum + shoulders(i) - 0.5 * (at(i, joints_.left.foot) + at(i, joints_.right.foot));
        up_ = std::abs(sum.z) > std::abs(sum.y) ? Vec3{0, 0, sum.z > 0 ? 1.0 : -1.0}
                                                : Vec3{0, sum.y > 0 ? 1.0 : -1.0, 0};
    }

    // Where the figure's left is, on the ground.
    void find_facing() {
        std::vector<Vec3> sides;
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            const Vec3 side = at(i, joints_.left.upper_arm) - at(i, joints_.right.upper_arm) +
                              at(i, joints_.left.thigh) - at(i, joints_.right.thigh);
            sides.push_back(side - dot(side, up_) * up_);
        }
        const auto reach = static_cast<std::ptrdiff_t>(facing_seconds * rate / 2);
        const auto count = static_cast<std::ptrdiff_t>(sides.size());
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            const Vec3 sum = std::accumulate(sides.begin() + std::max<std::ptrdiff_t>(0, i - reach),
                                             sides.begin() + std::min(count, i + reach + 1), Vec3{},
                                             [](Vec3 a, Vec3 b) { return a + b; });
            lefts_.push_back(unit(sum, lefts_.empty() ? Vec3{1, 0, 0} : lefts_.back()));
        }
    }

    void find_legs() {
        const auto length = [&](const MotionJoints::Side& s) {
            return norm(at(0, s.shin) - at(0, s.thigh)) + norm(at(0, s.foot) - at(0, s.shin));
        };
        leg_length_ = std::max(1e-9, 0.5 * (length(joints_.left) + length(joints_.right)));
        ground_ = dot(at(0, joints_.left.foot), up_);
        for (std::size_t i = 0; i < frames_.size(); ++i)
            for (const int foot : {joints_.left.foot, joints_.right.foot})
                ground_ = std::min(ground_, dot(at(i, foot), up_));
        const double below =
            dot(at(0, joints_.hips) - 0.5 * (at(0, joints_.left.thigh) + at(0, joints_.right.thigh)), up_);
        standing_height_ = leg_length_ + below;
    }

    Pose pose(std::size_t frame) const {
        const Vec3 left = lefts_[frame], forward = cross(left, up_), hips = at(frame, joints_.hips);
        Pose p;
        for (const Vec3& place : frames_[frame]) {
            const Vec3 v = place - hips;
            p.joints.push_back({dot(v, left), dot(v, up_), dot(v, forward)});
        }
        if (frame > 0) {
            const Vec3 step = hips - at(frame - 1, joints_.hips);
            p.travelled = poses_[frame - 1].travelled + Vec3{dot(step, left), 0, dot(step, forward)};
        }
        p.travelled.y = dot(hips, up_) - ground_;
        return p;
    }

    const MotionJoints& joints_;
    std::vector<Frame> frames_;
    Vec3 up_{0, 1, 0};
    std::vector<Vec3> lefts_;
    double leg_length_ = 1, standing_height_ = 1, ground_ = 0;
    std::vector<Pose> poses_;
};

// Seen from the side, forwards is to the right of the picture.
Point2d seen(Vec3 v, bool from_the_side) { return {from_the_side ? v.z : v.x, v.y}; }

// True when the way from `a` to `b` varies more forwards than sideways; a limb that is still is seen from the
// front.
bool moves_forwards(const std::vector<Pose>& poses, int a, int b) {
    Vec3 mean, squares;
    double squared_length = 0;
    const double n = static_cast<double>(poses.size());
    for (const Pose& p : poses) {
        const Vec3 v = p.joints[static_cast<std::size_t>(b)] - p.joints[static_cast<std::size_t>(a)];
        mean = mean + (1 / n) * v;
        squares = squares + (1 / n) * Vec3{v.x * v.x, 0, v.z * v.z};
        squared_length += dot(v, v) / n;
    }
    return squares.z - mean.z * mean.z > squares.x - mean.x * mean.x + still * squared_length;
}

// Angles of the way from `a` to `b` in the picture, counter-clockwise from the right, one a pose.
std::vector<double> angles_of(const std::vector<Pose>& poses, int a, int b, bool from_the_side) {
    std::vector<double> angles;
    for (const Pose& p : poses) {
        const Vec3 v = p.joints[static_cast<std::size_t>(b)] - p.joints[static_cast<std::size_t>(a)];
        const Point2d d = seen(v, from_the_side);
        const bool clear = length(d) > least_projection * norm(v) && norm(v) > 1e-12;
        const double last = angles.empty() ? -math::pi / 2 : angles.back();
        angles.push_back(clear ? math::atan2(d.y, d.x) : last);
    }
    return angles;
}

// The turn nearest to `near` that differs from `angle` by whole circles.
double nearest_turn(double angle, double near) {
    return angle + 2 * math::pi * std::rint((near - angle) / (2 * math::pi));
}

double rest_angle(const Bone& bone) {
    return math::atan2(bone.head.y - bone.tail.y, bone.tail.x - bone.head.x);
}

// What every bone does: its turn against the drawing, in the picture's plane, one a pose.
class Follower {
public:
    Follower(const Rig& rig, const ReferenceSkeleton& reference, const Recording& recording,
             const MotionJoints& joints)
        : rig_(rig), reference_(reference), poses_(recording.poses()), joints_(joints) {
        turns_.assign(rig.bones.size(), std::vector<double>(poses_.size()));
        const int neck = recording.neck();
        from_the_side_ = neck >= 0 && moves_forwards(poses_, joints.hips, neck);
        for (std::size_t b = 0; b < rig.bones.size(); ++b) {
            if (b == 0 && neck >= 0)
                lean(b, joints.hips, neck);
            else if (b > 0)
                drive(b);
        }
    }
    // Against the parent bone.
    Quaternion rotation(std::size_t bone, std::size_t pose) const {
        const int parent = rig_.bones[bone].parent;
        const double angle =
            turns_[bone][pose] - (parent >= 0 ? turns_[static_cast<std::size_t>(parent)][pose] : 0);
        return {0, 0, math::sin(angle / 2), math::cos(angle / 2)};
    }

private:
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
        } else if (name == "head" && joints_.head >= 0 && joints_.head_end >= 0) {
            lean(b, joints_.head, joints_.head_end);
        } else {
            rest_on_parent(b);
        }
    }

    void rest_on_parent(std::size_t b) { turns_[b] = turns_[static_cast<std::size_t>(rig_.bones[b].parent)]; }

    void limb(std::size_t b, const std::array<int, 3>& chain) {
        const Bone& bone = rig_.bones[b];
        if (bone.segment > 1) return rest_on_parent(b);
        const bool alone = std::none_of(rig_.bones.begin(), rig_.bones.end(), [&](const Bone& other) {
            return other.parent == static_cast<int>(b) && other.reference_joint == bone.reference_joint;
        });
        const auto from = static_cast<std::size_t>(bone.segment);
        const int to = alone && bone.segment == 0 ? chain[2] : chain[from + 1];
        turn_to(b, angles_of(poses_, chain[from], to, moves_forwards(poses_, chain[0], chain[2])),
                rest_angle(bone));
    }

    // Body and head keep the way they are drawn and lean as the recorded figure does against the vertical.
    void lean(std::size_t b, int from, int to) {
        turn_to(b, angles_of(poses_, from, to, from_the_side_), math::pi / 2);
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
    }

    const Rig& rig_;
    const ReferenceSkeleton& reference_;
    const std::vector<Pose>& poses_;
    const MotionJoints& joints_;
    bool from_the_side_ = false;
    std::vector<std::vector<double>> turns_;
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

} // namespace

bool shown_left(const Bone& bone, const std::string& joint) {
    return joint.ends_with("left") != bone.mirrored;
}

BoneAnimation follow(const Rig& rig, const ReferenceSkeleton& reference, const Motion& motion,
                     const MotionJoints& joints, double start, double seconds) {
    const Recording recording(motion, joints, start, seconds);
    const std::vector<Pose>& poses = recording.poses();
    const Follower follower(rig, reference, recording, joints);
    const double scale = drawn_leg_length(rig, reference) / recording.leg_length();
    const bool walks_forwards = moves_forwards(poses, joints.left.thigh, joints.left.foot);
    BoneAnimation animation;
    animation.name = motion.name;
    animation.rotations.resize(rig.bones.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        animation.times.push_back(static_cast<double>(i) / rate);
        for (std::size_t b = 0; b < rig.bones.size(); ++b)
            animation.rotations[b].push_back(follower.rotation(b, i));
        const Vec3 way = poses[i].travelled;
        animation.root_translation.push_back(
            {scale * (walks_forwards ? way.z : way.x), scale * (way.y - recording.standing_height()), 0});
    }
    animation.duration = animation.times.back();
    return animation;
}

} // namespace pantin
