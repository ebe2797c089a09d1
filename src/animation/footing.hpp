// SPDX-License-Identifier: MIT
// Feet that keep the ground: the tracks "step" and "plant" of a reference's clips (docs/references.md).
#pragma once

#include <vector>

#include "pantin/animation.hpp"

namespace pantin {

// The mesh vertex that stands on the ground: the lowest one of those that follow the bone and lie beyond its
// middle; −1: none.
int foot_vertex(const Rig& rig, int bone);

// A step cycle, measured from the contact of the foot. On the ground the foot moves back evenly, as the
// ground does under a character that stays in its place; then it is lifted and brought forward. Two bones
// reach the foot by the law of cosines, a stiff leg by turning towards the viewer, which shortens it in the
// picture; the root sinks as far as the legs on the ground need to reach it, which makes the body vault over
// the standing leg.
class Footing {
public:
    // `shift`: of each bone's phase, in cycles.
    Footing(const Rig& rig, const ReferenceClip& clip, const std::vector<double>& shift);

    // turns: of each bone against its parent in the drawing's plane, radians, counter-clockwise; those of
    // legs are replaced. flaps: out of the plane, added to. root: its translation in world units; lowered
    // where legs step.
    void apply(double cycle, std::vector<double>& turns, std::vector<double>& flaps, Vec3& root) const;

    // Way of the ground in world units a second, negative to the left; 0 for a clip without steps.
    double ground_speed() const { return ground_speed_; }

private:
    struct Leg {
        int upper = 0, lower = -1; // bones; one alone is stiff
        Point2d hip, knee, foot;   // at rest, world units, y up; the knee of a stiff leg is its foot
        Point2d along;             // unit vector of a stiff leg's bone
        double thigh = 0, shin = 0;
        double rest_bend = 0; // of the shin against the thigh, counter-clockwise
        double bend_side = 1; // 1: the knee bends counter-clockwise
        double stride = 0;    // from contact to the middle of the stance, signed
        double lift = 0;
        double phase = 0;
        const ReferenceTrack* track = nullptr;
        bool plants() const { return track->kind == TrackKind::plant; }
        double reach() const { return thigh + shin; }
    };
    struct Joint { // of a bone in the plane
        Point2d place;
        double turn = 0;
    };

    Leg leg_at(const Rig& rig, int bone, const ReferenceTrack& track, double shift) const;
    double longest_stride(const Leg& leg) const;
    void share_stride(double duration);
    std::vector<Joint> joints_of(const std::vector<double>& turns, const Vec3& root) const;
    double sink(const Leg& leg, Point2d hip, double cycle) const;
    static void reach_for(const Leg& leg, Point2d way, std::vector<double>& turns,
                          std::vector<double>& flaps);

    const Rig& rig_;
    std::vector<Leg> legs_;
    double ground_speed_ = 0;
};

} // namespace pantin
