// SPDX-License-Identifier: MIT
#include "animation/recording.hpp"

#include <algorithm>
#include <cmath>

#include "animation/body_axes.hpp"
#include "core/math.hpp"

namespace pantin {
namespace {

constexpr double facing_seconds = 0.5;        // window over which the figure's facing is averaged
constexpr double least_vote = 0.2;            // of a heading: below it there is none
constexpr double standing = 0.5, lying = 0.5; // cosine of the trunk with the vertical; with the ground
constexpr double turn_back = math::pi;        // radians a second
constexpr double straight = 0.95;             // length of the mean heading of a figure that keeps it
constexpr double long_way = 1.5;              // in lengths of the legs

Vec3 unit(Vec3 v, Vec3 otherwise) { return length(v) > 1e-12 ? (1 / length(v)) * v : otherwise; }

std::vector<std::vector<Vec3>> resampled(const Motion& motion, double start, double seconds) {
    const double whole = motion.frame_time * static_cast<double>(motion.frames() - 1);
    const double first = std::clamp(start, 0.0, whole), last = std::min(whole, first + seconds);
    const int count = std::max(1, static_cast<int>(std::floor((last - first) * key_rate + 0.01)));
    std::vector<std::vector<Vec3>> frames;
    for (int i = 0; i <= count; ++i) {
        const double at = std::min(first + i / key_rate, last) / motion.frame_time;
        const auto before = std::min(static_cast<std::size_t>(at), motion.frames() - 1);
        const std::size_t after = std::min(before + 1, motion.frames() - 1);
        const double share = at - static_cast<double>(before);
        std::vector<Vec3> a = joint_positions(motion, before);
        const std::vector<Vec3> b = joint_positions(motion, after);
        for (std::size_t j = 0; j < a.size(); ++j) a[j] = a[j] + share * (b[j] - a[j]);
        frames.push_back(std::move(a));
    }
    return frames;
}

} // namespace

Recording::Recording(const Motion& motion, const MotionJoints& joints, const FollowOptions& options)
    : joints_(joints), frames_(resampled(motion, options.start, options.seconds)) {
    const BodyAxes axes = body_axes(motion, joints);
    up_ = axes.up;
    find_headings();
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        RecordedPose pose;
        for (const Vec3& place : frames_[i])
            pose.joints.push_back(in_own_directions(place - at(i, joints_.hips), headings_[i]));
        poses_.push_back(std::move(pose));
    }
    find_legs();
    if (axes.stands_at_rest) find_rest(motion);
    find_way(options.way == Way::in_place);
}

Vec3 Recording::in_own_directions(Vec3 v, Vec3 heading) const {
    return {dot(v, cross(up_, heading)), dot(v, up_), dot(v, heading)};
}

// Where a pose says that its figure looks to, on the ground: its left side and its chest (of one on four
// legs, its trunk) each say it, and each the less the more it points up or down.
Vec3 Recording::heading_vote(const Frame& frame) const {
    const Vec3 left = unit(leftwards(frame, joints_), {});
    const Vec3 trunk = unit(limb_directions(frame, joints_).trunk, {});
    Vec3 chest = cross(left, trunk);
    if (joints_.plan == BodyPlan::quadruped) chest = trunk;
    if (joints_.plan == BodyPlan::bird) chest = {};
    return cross(left, up_) + chest - dot(chest, up_) * up_;
}

// A figure that stands faces the viewer. One that lies, or is upside down, is turned only as its body axis
// turns on the ground: rolling over is no turning round, and what it looks to then says nothing. When it
// stands again it turns back to the viewer.
void Recording::find_headings() {
    std::vector<Vec3> raw;
    double astray = 0; // angle from where it looks to, left from a time of lying
    Vec3 last_axis;
    for (const Frame& frame : frames_) {
        const Vec3 vote = heading_vote(frame);
        const Vec3 trunk = unit(limb_directions(frame, joints_).trunk, up_);
        const double upright = joints_.plan == BodyPlan::humanoid ? dot(trunk, up_) : 1;
        const Vec3 flat = trunk - dot(trunk, up_) * up_;
        const Vec3 axis = length(flat) > lying ? unit(flat, {}) : Vec3{};
        const bool clear = length(vote) > least_vote;
        if (raw.empty()) {
            raw.push_back(clear ? unit(vote, {}) : up_.y != 0 ? Vec3{0, 0, 1} : Vec3{0, -1, 0});
        } else if (upright > standing && clear) {
            const Vec3 own = unit(vote, {});
            if (!stood_) astray = angle_between(own, raw.back());
            const double step = turn_back / key_rate;
            astray = std::abs(astray) <= step ? 0 : astray - (astray > 0 ? step : -step);
            raw.push_back(turned(own, astray));
        } else if (length(axis) > 0 && length(last_axis) > 0) {
            raw.push_back(turned(raw.back(), angle_between(last_axis, axis)));
        } else {
            raw.push_back(raw.back());
        }
        stood_ = upright > standing && clear;
        last_axis = axis;
    }
    smooth_headings(raw);
}

void Recording::smooth_headings(const std::vector<Vec3>& raw) {
    const auto reach = static_cast<std::ptrdiff_t>(facing_seconds * key_rate / 2);
    const std::ptrdiff_t count = std::ssize(raw);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, i - reach),
                             end = std::min(count, i + reach + 1);
        Vec3 sum;
        for (std::ptrdiff_t k = begin; k < end; ++k) sum = sum + raw[static_cast<std::size_t>(k)];
        headings_.push_back(length(sum) > 1e-3 ? unit(sum, {}) : raw[static_cast<std::size_t>(i)]);
    }
}

// About the vertical, counter-clockwise seen from above, radians.
double Recording::angle_between(Vec3 from, Vec3 to) const {
    return math::atan2(dot(cross(from, to), up_), dot(from, to));
}
Vec3 Recording::turned(Vec3 horizontal, double angle) const {
    return math::cos(angle) * horizontal + math::sin(angle) * cross(up_, horizontal);
}

void Recording::find_legs() {
    leg_length_ = std::max(1e-9, pantin::leg_length(frames_[0], joints_));
    const Vec3 below = at(0, joints_.hips) - 0.5 * (at(0, joints_.left.thigh) + at(0, joints_.right.thigh));
    standing_height_ = leg_length_ + std::min(length(below), 0.5 * leg_length_);
    double ground = dot(at(0, joints_.left.foot), up_);
    for (std::size_t i = 0; i < frames_.size(); ++i)
        for (const auto& side : {joints_.left, joints_.right})
            for (const int joint : {joints_.hips, side.foot, side.hand})
                ground = std::min(ground, dot(at(i, joint), up_));
    for (std::size_t i = 0; i < frames_.size(); ++i)
        poses_[i].height = dot(at(i, joints_.hips), up_) - ground;
}

void Recording::find_rest(const Motion& motion) {
    const Frame rest = rest_positions(motion);
    const Vec3 vote = heading_vote(rest);
    if (length(vote) < least_vote) return;
    for (const Vec3& place : rest)
        rest_.push_back(
            in_own_directions(place - rest[static_cast<std::size_t>(joints_.hips)], unit(vote, {})));
}

// Of the hips' places on the ground: the direction in which they vary most.
Vec3 Recording::principal_axis() const {
    const Vec3 e = std::abs(up_.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, f = cross(up_, e);
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    const auto n = static_cast<double>(frames_.size());
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const Vec3 way = at(i, joints_.hips) - at(0, joints_.hips);
        const double u = dot(way, e), v = dot(way, f);
        x += u / n, y += v / n, xx += u * u / n, xy += u * v / n, yy += v * v / n;
    }
    const double angle = 0.5 * math::atan2(2 * (xy - x * y), xx - x * x - yy + y * y);
    return math::cos(angle) * e + math::sin(angle) * f;
}

// Rather than sideways.
bool Recording::goes_forwards() const {
    double along = 0, aside = 0;
    for (std::size_t i = 1; i < frames_.size(); ++i) {
        const Vec3 step = at(i, joints_.hips) - at(i - 1, joints_.hips);
        along += std::abs(dot(step, headings_[i]));
        aside += std::abs(dot(step, cross(up_, headings_[i])));
    }
    return along >= aside;
}

// The way is seen by a camera that stands where it sees most of it. A figure that keeps its heading is seen
// exactly from the side or from the front.
void Recording::find_way(bool in_place) {
    if (in_place) return;
    Vec3 mean;
    for (const Vec3& heading : headings_) mean = mean + heading;
    mean = (1 / static_cast<double>(headings_.size())) * mean;
    const bool keeps_heading = length(mean) > straight, forwards = goes_forwards();
    const auto direction = [&](Vec3 heading) { return forwards ? heading : cross(up_, heading); };
    Vec3 axis = keeps_heading ? direction(unit(mean, {})) : principal_axis();
    // At first it goes to the right, if it looks, or sidesteps, along the axis at all.
    for (const Vec3& heading : headings_) {
        const double along = dot(axis, direction(heading));
        if (std::abs(along) < 0.5) continue;
        if (along < 0) axis = -1 * axis;
        break;
    }
    double least = 0, most = 0;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        const double way = dot(at(i, joints_.hips) - at(0, joints_.hips), axis);
        poses_[i].way = way;
        least = std::min(least, way), most = std::max(most, way);
    }
    if (keeps_heading || !forwards || most - least < long_way * leg_length_) return;
    for (std::size_t i = 0; i < poses_.size(); ++i) poses_[i].forwards = dot(headings_[i], axis);
}

} // namespace pantin
