// SPDX-License-Identifier: MIT
// Feet that keep the ground: steps, planted feet, legs that are too short.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "../rigging/figures.hpp"
#include "animation/footing.hpp"
#include "animation/vector.hpp"

using namespace pantin;
using namespace pantin::tests;

namespace {

constexpr const char* legs[] = {"leg_front_left", "leg_front_right", "leg_hind_left", "leg_hind_right"};

int joint_named(const ReferenceSkeleton& reference, const std::string& name) {
    for (std::size_t j = 0; j < reference.joints.size(); ++j)
        if (reference.joints[j].name == name) return static_cast<int>(j);
    return -1;
}

ReferenceTrack track_of(const ReferenceSkeleton& reference, const std::string& joint, TrackKind kind,
                        double amplitude) {
    ReferenceTrack track;
    track.joint = joint_named(reference, joint);
    track.kind = kind;
    track.amplitude = amplitude;
    return track;
}

// Every leg steps with the amplitude, a quarter of a cycle after the last.
ReferenceClip stepping(const ReferenceSkeleton& reference, double amplitude, double duty) {
    ReferenceClip clip{"steps", 2, {}};
    for (const char* leg : legs) {
        ReferenceTrack track = track_of(reference, leg, TrackKind::step, amplitude);
        track.phase = 0.25 * static_cast<double>(clip.tracks.size());
        track.lift = 0.15;
        track.duty = duty;
        clip.tracks.push_back(track);
    }
    return clip;
}

// Where the sole of each leg of the table is, over one cycle.
std::vector<Vec3> ways_of_sole(const Rig& rig, const BoneAnimation& animation, const std::string& leg) {
    const int shin = bone_named(rig, leg + ".1"), bone = shin > 0 ? shin : bone_named(rig, leg);
    const int sole = foot_vertex(rig, bone);
    REQUIRE(sole >= 0);
    std::vector<Vec3> ways;
    for (const double time : animation.times) ways.push_back(skin(rig, animation, time)[sole]);
    return ways;
}

double fraction(double x) { return x - std::floor(x); }

// While a foot is down it goes with the ground, at its height.
void check_steps(const Rig& rig, const ReferenceClip& clip, double tolerance) {
    const Character c = table();
    const BoneAnimation animation = retarget(rig, c.reference, clip, 64);
    REQUIRE(animation.ground_speed > 0); // the table faces left, so the ground goes to the right
    for (const ReferenceTrack& track : clip.tracks) {
        if (track.kind != TrackKind::step) continue;
        const std::string leg = c.reference.joints[track.joint].name;
        const std::vector<Vec3> ways = ways_of_sole(rig, animation, leg);
        double ground = ways[0].y;
        for (const Vec3& p : ways) ground = std::min(ground, p.y);
        double highest = 0;
        CAPTURE(leg);
        for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
            const double u = fraction(static_cast<double>(i) / 64 + track.phase);
            highest = std::max(highest, ways[i].y - ground);
            if (u + 1.0 / 64 > track.duty) continue;
            CHECK(ways[i].y == Approx(ground).margin(tolerance));
            CHECK(ways[i + 1].x - ways[i].x ==
                  Approx(animation.ground_speed * clip.duration / 64).margin(tolerance));
        }
        CHECK(highest > 0.02);
    }
}

} // namespace

TEST_CASE("feet that step go with the ground while they are down, and are lifted") {
    const Character c = table();
    const Rig rig = rig_of(c);
    check_steps(rig, stepping(c.reference, 0.3, 0.6), 1e-3); // a sole follows the shin by 0.999
    ReferenceClip clip = stepping(c.reference, 0.2, 0.75);
    clip.tracks.push_back(track_of(c.reference, "hips", TrackKind::z, 2));
    clip.tracks.push_back(track_of(c.reference, "chest", TrackKind::z, 2));
    check_steps(rig, clip, 1e-3); // while the trunk sways
}

TEST_CASE("a stiff leg keeps its foot on the ground by turning towards the viewer") {
    const Character c = table();
    RigOptions options;
    options.limb_segments = 1;
    const Rig rig = rig_of(c, options);
    REQUIRE(bone_named(rig, "leg_front_left.1") < 0);
    check_steps(rig, stepping(c.reference, 0.3, 0.6), 2.5e-3);
}

TEST_CASE("knees bend forwards, backwards where the track says so, and as they are drawn") {
    const Character c = table();
    Rig rig = rig_of(c);
    const int thigh = bone_named(rig, "leg_front_left");
    const auto turn = [&](int bend) {
        ReferenceClip clip = stepping(c.reference, 0, 0.5);
        for (ReferenceTrack& track : clip.tracks) track.bend = bend;
        const BoneAnimation animation = retarget(rig, c.reference, clip, 64);
        return animation.rotations[thigh][48].z; // lifted highest
    };
    CHECK(turn(1) < -0.05); // forwards is to the left: the thigh, pointing down, turns clockwise
    CHECK(turn(-1) > 0.05);
    rig.bones[thigh].tail.x += 12; // a drawn knee to the right
    rig.bones[thigh + 1].head.x += 12;
    CHECK(turn(1) > 0.05);
}

TEST_CASE("planted feet stay where they are while the body sways, and leave the ground with it") {
    const Character c = table();
    const Rig rig = rig_of(c);
    ReferenceClip clip{"sway", 1, {}};
    for (const char* leg : legs) clip.tracks.push_back(track_of(c.reference, leg, TrackKind::plant, 0));
    ReferenceTrack bob = track_of(c.reference, "hips", TrackKind::ty, 0.02);
    bob.offset = -0.03; // every hip stays below its place at rest
    clip.tracks.push_back(bob);
    clip.tracks.push_back(track_of(c.reference, "hips", TrackKind::z, 1));
    const BoneAnimation swaying = retarget(rig, c.reference, clip, 32);
    CHECK(swaying.ground_speed == 0);
    for (const char* leg : legs)
        for (const std::vector<Vec3> ways = ways_of_sole(rig, swaying, leg); const Vec3& p : ways) {
            CHECK(p.x == Approx(ways[0].x).margin(4e-3));
            CHECK(p.y == Approx(ways[0].y).margin(4e-3));
        }
    clip.tracks[4].offset = 0.2; // in the air all the time
    const BoneAnimation jumping = retarget(rig, c.reference, clip, 32);
    const double rest = to_world({0, 90}, rig.width, rig.height).y;
    for (const char* leg : legs)
        for (const Vec3& p : ways_of_sole(rig, jumping, leg)) CHECK(p.y > rest + 0.1);
}
