// SPDX-License-Identifier: MIT
// Two-bone inverse kinematics in the drawing's plane.
#include "animation/footing.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/smoothstep.hpp"
#include "reference/tracks.hpp"

namespace pantin {
namespace {

constexpr double clearly_bent =
    4 * math::pi / 180; // a drawn bend of this much decides to which side the knee bends
constexpr double loaded =
    0.12; // cycles before contact and after lift-off in which a leg starts to carry the body
constexpr double deepest = 0.1;     // of the leg's length: so far the hip may come down for it
constexpr double hardly = 0.5;      // of the median leg's stride
constexpr double least_lift = 0.03; // of the crop's height, but at most…
constexpr double most_lift =
    0.35; // … this share of the leg's length: feet of short legs shall be seen to leave the ground
constexpr double slack = 0.01; // a stepping leg keeps this share of its length, so that the knee never snaps
constexpr double steepest = 75 * math::pi / 180; // of a stiff leg against the drawing
constexpr double airborne = 0.15;                // of the leg's length: so high, a planted leg is free

Point2d turned(Point2d v, double angle) {
    const double c = math::cos(angle), s = math::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}
// Working pixels to heights of the crop, y up.
Point2d upright(Point2d p, const Rig& rig) { return {p.x / rig.height, -p.y / rig.height}; }
double bearing(Point2d v) { return math::atan2(v.y, v.x); }
double half_turn(double angle) { return angle - 2 * math::pi * std::rint(angle / (2 * math::pi)); }
double angle_from(Point2d a, Point2d b) { return math::atan2(cross(a, b), dot(a, b)); }
double arc_cosine(double c) {
    c = std::clamp(c, -1.0, 1.0);
    return math::atan2(std::sqrt(1 - c * c), c);
}

double fraction(double x) { return x - std::floor(x); }

// From the foot's place at rest: along the stride, −1 to 1 and a little beyond, and up, 0 to 1. u: cycles
// since contact. The foot leaves the ground and meets it with the ground's speed (a cubic of Hermite), so it
// does not scrape.
Point2d step_at(double u, double duty) {
    if (u < duty) return {1 - 2 * u / duty, 0};
    const double v = (u - duty) / (1 - duty), s = math::sin(math::pi * v), slope = -2 * (1 - duty) / duty;
    return {(2 * v - 1) * (1 + 2 * v - 2 * v * v) + slope * v * (1 - v) * (1 - 2 * v), s * s};
}

// 1 on the ground, less beside.
double load_at(double u, double duty) {
    const double ramp = std::min(loaded, 0.5 * (1 - duty));
    if (u <= duty || ramp <= 0) return 1;
    return smoothstep(1 - std::min(u - duty, 1 - u) / ramp);
}

// A stiff leg: the part of the foot's place that lies along the bone is foreshortened.
void turn_stiff_leg(Point2d foot, Point2d along, Point2d way, double& turn, double& flap) {
    const double lengthwise = dot(foot, along);
    const Point2d across = foot - lengthwise * along;
    const double d = length(way), seen = std::sqrt(std::max(0.0, d * d - dot(across, across)));
    const double tilt = lengthwise > 0 ? std::min(arc_cosine(seen / lengthwise), steepest) : 0;
    turn = half_turn(bearing(way) - bearing(math::cos(tilt) * lengthwise * along + across));
    flap += tilt;
}

bool follows(const VertexWeights& weights, int bone) {
    return weights.bones[0] == bone && weights.weights[0] > 0.5;
}

} // namespace

int foot_vertex(const Rig& rig, int bone) {
    const Bone& b = rig.bones[bone];
    const Point2d along = b.tail - b.head, middle = 0.5 * (b.head + b.tail);
    int foot = -1;
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v) {
        const Point2d p = rig.mesh.vertices[v];
        if (!follows(rig.weights[v], bone) || dot(p - middle, along) < 0) continue;
        if (foot < 0 || p.y > rig.mesh.vertices[foot].y) foot = static_cast<int>(v);
    }
    return foot;
}

Footing::Footing(const Rig& rig, const ReferenceClip& clip, const std::vector<double>& shift) : rig_(rig) {
    for (std::size_t b = 1; b < rig.bones.size(); ++b)
        for (const ReferenceTrack& track : clip.tracks)
            if (on_ground(track.kind) && rig.bones[b].segment == 0 &&
                rig.bones[b].reference_joint == track.joint)
                legs_.push_back(leg_at(rig, static_cast<int>(b), track, shift[b]));
    share_stride(clip.duration);
}

Footing::Leg Footing::leg_at(const Rig& rig, int bone, const ReferenceTrack& track, double shift) const {
    const auto up = [&rig](Point2d p) { return upright(p, rig); };
    Leg leg;
    leg.track = &track;
    leg.phase = track.phase + shift;
    leg.upper = bone;
    leg.hip = up(rig.bones[bone].head);
    leg.knee = leg.foot = up(rig.bones[bone].tail);
    int last = bone;
    for (int b = bone + 1; b < static_cast<int>(rig.bones.size()) && rig.bones[b].segment > 0; ++b) {
        if (leg.lower < 0) leg.lower = b;
        leg.foot = up(rig.bones[b].tail);
        last = b;
    }
    if (const int sole = foot_vertex(rig, last); sole >= 0) leg.foot = up(rig.mesh.vertices[sole]);
    if (leg.lower < 0) leg.knee = leg.foot;
    const Point2d bone_way = up(rig.bones[bone].tail) - leg.hip;
    leg.along = 1 / std::max(length(bone_way), 1e-9) * bone_way;
    leg.thigh = distance(leg.hip, leg.knee);
    leg.shin = distance(leg.knee, leg.foot);
    const double side = rig.bones[bone].mirrored ? -1 : 1;
    leg.rest_bend = leg.lower < 0 ? 0 : angle_from(leg.knee - leg.hip, leg.foot - leg.knee);
    // A knee that goes to the left turns the shin counter-clockwise.
    leg.bend_side = std::abs(leg.rest_bend) > clearly_bent ? (leg.rest_bend > 0 ? 1 : -1) : side * track.bend;
    leg.stride = -side;
    leg.lift = std::max(track.lift * leg.reach(), std::min(least_lift, most_lift * leg.reach()));
    return leg;
}

double Footing::longest_stride(const Leg& leg) const {
    const double reach = (1 - slack) * leg.reach();
    const double height = std::max(0.0, leg.hip.y - leg.foot.y - deepest * leg.reach());
    const double across = std::sqrt(std::max(0.0, reach * reach - height * height));
    return std::max(0.0, across - std::abs(leg.hip.x - leg.foot.x));
}

// All feet go over one ground: the stride is the shortest of those that suit the legs, each by its length,
// its shape and the place where it is drawn. A leg that could hardly step, against the median, is left to
// slide.
void Footing::share_stride(double duration) {
    std::vector<double> strides;
    for (const Leg& leg : legs_) {
        const double wanted = leg.track->amplitude * leg.reach() * rig_.bones[leg.upper].freedom;
        if (!leg.plants()) strides.push_back(std::min(wanted, longest_stride(leg)));
    }
    if (strides.empty()) return;
    std::sort(strides.begin(), strides.end());
    const double shared = std::max(strides.front(), hardly * strides[strides.size() / 2]);
    for (Leg& leg : legs_) {
        if (leg.plants()) continue;
        if (ground_speed_ == 0) ground_speed_ = -leg.stride * 2 * shared / (leg.track->duty * duration);
        leg.stride *= std::min(shared, longest_stride(leg));
    }
}

std::vector<Footing::Joint> Footing::joints_of(const std::vector<double>& turns, const Vec3& root) const {
    std::vector<Joint> joints;
    for (std::size_t b = 0; b < rig_.bones.size(); ++b) {
        const Bone& bone = rig_.bones[b];
        const Point2d rest = upright(bone.head, rig_);
        Joint joint{rest + Point2d{root.x, root.y}, turns[b]};
        if (bone.parent >= 0) {
            const Point2d from = upright(rig_.bones[bone.parent].head, rig_);
            const Joint& moved = joints[bone.parent];
            joint = {moved.place + turned(rest - from, moved.turn), moved.turn + turns[b]};
        }
        joints.push_back(joint);
    }
    return joints;
}

// How far the hip must come down for the leg to reach its place on the ground.
double Footing::sink(const Leg& leg, Point2d hip, double cycle) const {
    if (leg.plants()) return 0;
    const double u = fraction(cycle + leg.phase), duty = leg.track->duty;
    const double reach = leg.stride == 0 || leg.lower < 0 ? leg.reach() : (1 - slack) * leg.reach();
    const double across = leg.foot.x + leg.stride * step_at(u, duty).x - hip.x;
    const double down = std::sqrt(std::max(0.0, reach * reach - across * across));
    return load_at(u, duty) * std::clamp(hip.y - leg.foot.y - down, 0.0, deepest * leg.reach());
}

// way: from the hip to the foot's place, as the parent bone sees it.
void Footing::reach_for(const Leg& leg, Point2d way, std::vector<double>& turns, std::vector<double>& flaps) {
    if (leg.lower < 0)
        return turn_stiff_leg(leg.foot - leg.hip, leg.along, way, turns[leg.upper], flaps[leg.upper]);
    const double a = leg.thigh, b = leg.shin;
    const double d = std::clamp(length(way), 1.02 * std::abs(a - b) + 1e-9, a + b);
    const double knee = leg.bend_side * (math::pi - arc_cosine((a * a + b * b - d * d) / (2 * a * b)));
    const double thigh = leg.bend_side * arc_cosine((a * a + d * d - b * b) / (2 * a * d));
    turns[leg.upper] = half_turn(bearing(way) - thigh - bearing(leg.knee - leg.hip));
    turns[leg.lower] = half_turn(knee - leg.rest_bend);
}

void Footing::apply(double cycle, std::vector<double>& turns, std::vector<double>& flaps, Vec3& root) const {
    if (legs_.empty()) return;
    std::vector<Joint> joints = joints_of(turns, root);
    double lowered = 0;
    for (const Leg& leg : legs_) lowered = std::max(lowered, sink(leg, joints[leg.upper].place, cycle));
    root.y -= lowered;
    for (Joint& joint : joints) joint.place.y -= lowered;
    for (const Leg& leg : legs_) {
        const Point2d hip = joints[leg.upper].place;
        Point2d target = leg.foot;
        double free = 0; // share of the clip's own swing that a leg in the air takes
        if (leg.plants()) {
            free = smoothstep((distance(hip, target) / leg.reach() - 1) / airborne);
        } else {
            const Point2d step = step_at(fraction(cycle + leg.phase), leg.track->duty);
            target = target + Point2d{leg.stride * step.x, leg.lift * step.y};
        }
        const double swing = free * turns[leg.upper], kick = leg.lower < 0 ? 0 : free * turns[leg.lower];
        const double parent_turn = joints[rig_.bones[leg.upper].parent].turn;
        reach_for(leg, turned(target - hip, -parent_turn), turns, flaps);
        turns[leg.upper] += swing;
        if (leg.lower >= 0) turns[leg.lower] += kick;
    }
}

} // namespace pantin
