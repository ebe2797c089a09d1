// SPDX-License-Identifier: MIT
#include "animation/body_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math.hpp"

namespace pantin {
namespace {

constexpr double along = 0.7;            // cosine of a direction that counts as that of an axis
constexpr double across = 0.6;           // of one that counts as across it, at most
constexpr std::size_t most_frames = 200; // that are looked at
constexpr double animal_forelegs = 0.8;  // in lengths of the hind legs; people's arms are shorter
// The ground: the lowest joint is at most so far below and above it, in lengths of the legs.
constexpr double below_ground = 0.06, above_ground = 0.35;
constexpr double long_way = 1.5; // in lengths of the legs
constexpr double rolls = 3.6;    // radians a leg's length of way: a body that rolls along

constexpr std::array<Vec3, 6> axes = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {-1, 0, 0}}};
// What most files have.
constexpr std::array<double, 6> usual = {0.1, 0.05, 0, 0, 0, 0};

double cosine(Vec3 a, Vec3 axis) {
    const double n = length(a);
    return n > 1e-9 ? dot(a, axis) / n : 0;
}

Vec3 nearest_axis(Vec3 direction) {
    return *std::max_element(axes.begin(), axes.end(), [&](const Vec3& a, const Vec3& b) {
        return dot(direction, a) < dot(direction, b);
    });
}

double way_over(const std::vector<Vec3>& pose, int a, int b, int c) {
    const Vec3 middle = pose[static_cast<std::size_t>(b)];
    return distance(pose[static_cast<std::size_t>(a)], middle) +
           distance(middle, pose[static_cast<std::size_t>(c)]);
}

// What the frames say of an axis.
struct Evidence {
    double stands = 0;       // share of frames with the trunk above the legs, or an animal's on top of four
    double on_four = 0;      // share of frames of the latter
    double on_ground = 0;    // share of frames with the lowest joint at the height 0
    double stands_there = 0; // share of frames with both
    double level = 0;        // share of frames with the lowest joint where it mostly is
    double aside = 0;        // mean of the cosine between the axis and the line from right to left
};

class Frames {
public:
    Frames(const Motion& motion, const MotionJoints& joints) : joints_(joints) {
        const std::size_t step = std::max<std::size_t>(1, motion.frames() / most_frames);
        for (std::size_t i = 0; i < motion.frames(); i += step) poses_.push_back(joint_positions(motion, i));
        leg_ = std::max(1e-9, leg_length(poses_[0], joints));
        animal_ = arm_length(poses_[0], joints) > animal_forelegs * leg_;
    }

    Evidence evidence(Vec3 up) const {
        Evidence e;
        std::vector<double> lowest;
        const double n = static_cast<double>(poses_.size());
        for (const std::vector<Vec3>& pose : poses_) {
            const LimbDirections d = limb_directions(pose, joints_);
            const bool four = animal_ && is_on_four(d, up);
            e.on_four += four / n;
            const bool stands = four || (cosine(d.trunk, up) > along && cosine(d.legs, up) < -along);
            e.stands += stands / n;
            e.aside += std::abs(cosine(leftwards(pose, joints_), up)) / n;
            lowest.push_back(lowest_of(pose, up));
            const bool grounded = lowest.back() > -below_ground * leg_ && lowest.back() < above_ground * leg_;
            e.on_ground += grounded / n;
            e.stands_there += (stands && grounded) / n;
        }
        std::vector<double> sorted = lowest;
        std::nth_element(sorted.begin(), sorted.begin() + std::ssize(sorted) / 2, sorted.end());
        const double middle = sorted[sorted.size() / 2];
        for (const double low : lowest) e.level += (std::abs(low - middle) < above_ground * leg_) / n;
        return e;
    }

    // Whether the hips go far over the ground below `up`, and not by rolling along.
    bool goes_a_way(Vec3 up) const {
        const auto flat = [&](Vec3 v) { return v - dot(v, up) * up; };
        double farthest = 0, way = 0, turned = 0;
        for (std::size_t i = 1; i < poses_.size(); ++i) {
            const Vec3 from = hips(i - 1), to = hips(i), a = flat(leftwards(poses_[i - 1], joints_)),
                       b = flat(leftwards(poses_[i], joints_));
            farthest = std::max(farthest, length(flat(to - hips(0))));
            way += length(flat(to - from));
            turned += std::abs(math::atan2(dot(cross(a, b), up), dot(a, b)));
        }
        return farthest > long_way * leg_ && turned < rolls * way / leg_;
    }

    bool is_animal() const { return animal_; }
    static bool is_on_four(const LimbDirections& d, Vec3 up) {
        return cosine(d.legs, up) < -along && cosine(d.arms, up) < -0.5 &&
               std::abs(cosine(d.trunk, up)) < across;
    }

private:
    Vec3 hips(std::size_t pose) const { return poses_[pose][static_cast<std::size_t>(joints_.hips)]; }
    double lowest_of(const std::vector<Vec3>& pose, Vec3 up) const {
        double lowest = dot(pose[static_cast<std::size_t>(joints_.hips)], up);
        for (const auto& s : {joints_.left, joints_.right})
            for (const int joint : {s.upper_arm, s.forearm, s.hand, s.thigh, s.shin, s.foot})
                lowest = std::min(lowest, dot(pose[static_cast<std::size_t>(joint)], up));
        return lowest;
    }

    const MotionJoints& joints_;
    std::vector<std::vector<Vec3>> poses_;
    double leg_ = 1;
    bool animal_ = false;
};

// The axis that the frames speak for: the lowest joint is on the ground, the figure stands on it, and its
// sides are not below and above it.
BodyAxes axes_of_frames(const Frames& frames) {
    BodyAxes result;
    double best = -1;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const Evidence e = frames.evidence(axes[k]);
        const double score = std::min(e.on_ground, 0.8) + e.stands_there + 0.3 * e.stands * e.level -
                             0.25 * e.aside + usual[k];
        if (score <= best) continue;
        best = score;
        result.up = axes[k];
        result.on_four_legs = e.on_four > 0.8;
    }
    return result;
}

// Files of some conversions have a pose at rest along another axis than their frames: the figure would lie in
// all of them, and slide about. Another axis is right where it stands on it, on one level, and either goes a
// long way or is on the ground at 0 there and not here.
bool contradicts(const Frames& frames, Vec3 up, Vec3 other) {
    const Evidence here = frames.evidence(up), there = frames.evidence(other);
    if (there.stands < 0.8 || there.level < 0.8 || here.stands > 0.1 || here.on_ground > 0.5) return false;
    return there.on_ground > 0.8 || frames.goes_a_way(other);
}

} // namespace

Vec3 leftwards(const std::vector<Vec3>& pose, const MotionJoints& joints) {
    const auto at = [&](int joint) { return pose[static_cast<std::size_t>(joint)]; };
    return at(joints.left.upper_arm) - at(joints.right.upper_arm) + at(joints.left.thigh) -
           at(joints.right.thigh);
}
double arm_length(const std::vector<Vec3>& pose, const MotionJoints& joints) {
    const auto arm = [&](const MotionJoints::Side& s) {
        return way_over(pose, s.upper_arm, s.forearm, s.hand);
    };
    return 0.5 * (arm(joints.left) + arm(joints.right));
}
double leg_length(const std::vector<Vec3>& pose, const MotionJoints& joints) {
    const auto leg = [&](const MotionJoints::Side& s) { return way_over(pose, s.thigh, s.shin, s.foot); };
    return 0.5 * (leg(joints.left) + leg(joints.right));
}

LimbDirections limb_directions(const std::vector<Vec3>& pose, const MotionJoints& joints) {
    const auto at = [&](int joint) { return pose[static_cast<std::size_t>(joint)]; };
    const auto& [l, r] = std::pair(joints.left, joints.right);
    const Vec3 thighs = 0.5 * (at(l.thigh) + at(r.thigh)), arms = 0.5 * (at(l.upper_arm) + at(r.upper_arm));
    return {0.5 * (at(l.foot) + at(r.foot)) - thighs, 0.5 * (at(l.hand) + at(r.hand)) - arms, arms - thighs};
}

BodyAxes body_axes(const Motion& motion, const MotionJoints& joints) {
    const Frames frames(motion, joints);
    const LimbDirections rest = limb_directions(rest_positions(motion), joints);
    BodyAxes result;
    result.up = nearest_axis(-1 * rest.legs);
    result.on_four_legs = frames.is_animal() && Frames::is_on_four(rest, result.up);
    result.stands_at_rest =
        cosine(rest.legs, result.up) < -along &&
        (result.on_four_legs || cosine(rest.trunk, result.up) > along || joints.plan == BodyPlan::bird);
    if (!result.stands_at_rest) return axes_of_frames(frames);
    for (const Vec3& other : axes)
        if (!(other == result.up) && contradicts(frames, result.up, other)) {
            result.rest_up = result.up;
            result.up = other;
            result.stands_at_rest = false;
            break;
        }
    return result;
}

} // namespace pantin
