// SPDX-License-Identifier: MIT
// Retargeted clips and skinning: hand-worked poses, and what holds for every clip of every reference.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "../rigging/figures.hpp"
#include "animation/vector.hpp"
#include "core/math.hpp"
#include "core/random.hpp"

using namespace pantin;
using namespace pantin::tests;

namespace {

double distance_of(const Vec3& a, const Vec3& b) {
    const Vec3 d = a - b;
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

BoneAnimation still(const Rig& rig) {
    BoneAnimation animation;
    animation.duration = 1;
    animation.times = {0, 1};
    animation.rotations.assign(rig.bones.size(), std::vector<Quaternion>(2));
    animation.root_translation.assign(2, {});
    return animation;
}

Quaternion about_z(double degrees) {
    const double half = degrees * math::pi / 360;
    return {0, 0, math::sin(half), math::cos(half)};
}

ReferenceClip clip_with(std::vector<ReferenceTrack> tracks) { return {"test", 1, std::move(tracks)}; }

int joint_named(const ReferenceSkeleton& reference, const std::string& name) {
    for (std::size_t j = 0; j < reference.joints.size(); ++j)
        if (reference.joints[j].name == name) return static_cast<int>(j);
    return -1;
}

} // namespace

TEST_CASE("the world's origin is the bottom centre of the crop and one unit its height") {
    const Vec3 corner = to_world({-0.5, -0.5}, 200, 100), bottom = to_world({99.5, 99.5}, 200, 100, 0.25);
    CHECK(corner.x == -1);
    CHECK(corner.y == 1);
    CHECK(bottom.x == 0);
    CHECK(bottom.y == 0);
    CHECK(bottom.z == 0.25);
}

TEST_CASE("skinning leaves the character at rest where it was drawn") {
    const Rig rig = rig_of(table());
    const std::vector<Vec3> vertices = skin(rig, still(rig), 0.3);
    for (std::size_t v = 0; v < vertices.size(); ++v)
        CHECK(distance_of(vertices[v], to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v])) <
              1e-15);
}

TEST_CASE("turning and moving the root moves the whole character rigidly") {
    const Rig rig = rig_of(table());
    BoneAnimation animation = still(rig);
    animation.rotations[0] = {about_z(90), about_z(90)};
    animation.root_translation = {{0.5, 0.25, 0}, {0.5, 0.25, 0}};
    const std::vector<Vec3> vertices = skin(rig, animation, 0);
    const Vec3 pivot = to_world(rig.bones[0].head, rig.width, rig.height);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const Vec3 rest = to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]);
        const Vec3 expected{pivot.x - (rest.y - pivot.y) + 0.5, pivot.y + (rest.x - pivot.x) + 0.25, rest.z};
        CHECK(distance_of(vertices[v], expected) < 1e-14);
    }
}

TEST_CASE("a bone turns about its inner end and carries its children") {
    const Rig rig = rig_of(table());
    BoneAnimation animation = still(rig);
    const int leg = bone_named(rig, "leg_front_left");
    animation.rotations[leg] = {about_z(90), about_z(90)};
    const std::vector<Vec3> vertices = skin(rig, animation, 0);
    const Vec3 hip = to_world(rig.bones[leg].head, rig.width, rig.height);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const Vec3 rest = to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]);
        if (rig.mesh.vertices[v].y > 80 && rig.mesh.vertices[v].x < 34) {
            const Vec3 expected{hip.x - (rest.y - hip.y), hip.y + (rest.x - hip.x), rest.z};
            CHECK(distance_of(vertices[v], expected) < 0.02); // the last weights of the thigh
        }
        if (rig.mesh.vertices[v].y < 40) CHECK(distance_of(vertices[v], rest) < 0.02);
    }
}

TEST_CASE("every clip of the compiled-in references loops exactly") {
    const Character c = table();
    const Rig table_rig = rig_of(c);
    for (const ReferenceSkeleton& reference : load_references()) {
        Rig rig = table_rig;
        for (Bone& bone : rig.bones) // the bones of a table, whatever the reference calls them
            if (bone.reference_joint >= static_cast<int>(reference.joints.size())) bone.reference_joint = -1;
        for (const ReferenceClip& clip : reference.clips) {
            const BoneAnimation animation = retarget(rig, reference, clip, 24);
            CAPTURE(reference.name, clip.name);
            REQUIRE(animation.times.size() == 25);
            CHECK(animation.times.back() == clip.duration);
            for (const auto& keys : animation.rotations) {
                CHECK((keys.front().x == keys.back().x && keys.front().y == keys.back().y &&
                       keys.front().z == keys.back().z && keys.front().w == keys.back().w));
                for (const Quaternion& q : keys)
                    CHECK(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w == Approx(1).epsilon(1e-14));
            }
            const auto first = skin(rig, animation, 0), last = skin(rig, animation, clip.duration);
            for (std::size_t v = 0; v < first.size(); ++v) CHECK(distance_of(first[v], last[v]) == 0);
        }
    }
}

TEST_CASE("each reference has a moving clip first and a calm one, and every joint moves in the first") {
    for (const ReferenceSkeleton& reference : load_references()) {
        REQUIRE(reference.clips.size() >= 2);
        const std::map<std::string, std::string> first = {
            {"flying", "fly"}, {"fish", "swim"}, {"bust", "nod"}};
        CHECK(reference.clips[0].name ==
              (first.contains(reference.name) ? first.at(reference.name) : "walk"));
        CHECK(reference.clips[1].name == "idle");
        for (std::size_t j = 0; j < reference.joints.size(); ++j)
            CHECK(std::any_of(
                reference.clips[0].tracks.begin(), reference.clips[0].tracks.end(),
                [&](const ReferenceTrack& t) { return t.joint == static_cast<int>(j) && t.amplitude != 0; }));
    }
}

TEST_CASE(
    "lift raises the tip on either side, flap brings it to the viewer, z turns with the mirrored drawing") {
    const Character c = table();
    Rig rig = rig_of(c);
    const int head = bone_named(rig, "head"), tail = bone_named(rig, "tail");
    std::vector<ReferenceTrack> tracks;
    for (const char* joint : {"head", "tail"})
        tracks.push_back({joint_named(c.reference, joint), TrackKind::lift, 0, 0, 0, 30, 1});
    const auto tip = [&](const BoneAnimation& animation, int bone) {
        const Bone& b = rig.bones[bone];
        const Vec3 from = to_world(b.head, rig.width, rig.height),
                   to = to_world(b.tail, rig.width, rig.height);
        return matrix_of(animation.rotations[bone][0]) * (to - from);
    };
    BoneAnimation animation = retarget(rig, c.reference, clip_with(tracks));
    CHECK(tip(animation, head).x < 0);
    CHECK(tip(animation, head).y > 0.01);
    CHECK(tip(animation, tail).x > 0);
    CHECK(tip(animation, tail).y > 0.01);
    for (ReferenceTrack& track : tracks) track.kind = TrackKind::flap;
    animation = retarget(rig, c.reference, clip_with(tracks));
    CHECK(tip(animation, head).z > 0.01);
    CHECK(tip(animation, tail).z > 0.01);
    for (ReferenceTrack& track : tracks) track.kind = TrackKind::z;
    animation = retarget(rig, c.reference, clip_with(tracks));
    CHECK(tip(animation, tail).y > 0.01);
    for (Bone& bone : rig.bones) bone.mirrored = true;
    animation = retarget(rig, c.reference, clip_with(tracks));
    CHECK(tip(animation, tail).y < -0.01);
}

// Each leg of the reference swings in the plane, a quarter of a cycle after the last.
static ReferenceClip swinging_legs(const ReferenceSkeleton& reference) {
    std::vector<ReferenceTrack> tracks;
    for (const char* leg : {"leg_front_left", "leg_front_right", "leg_hind_left", "leg_hind_right"})
        tracks.push_back({joint_named(reference, leg), TrackKind::z, 0, 20,
                          0.25 * static_cast<double>(tracks.size()), 0, 1});
    return clip_with(tracks);
}

TEST_CASE("short limbs swing less, and legs alternate when their number differs from the reference's") {
    const Character c = table();
    Rig rig = rig_of(c);
    const ReferenceClip walk = swinging_legs(c.reference);
    const int leg = bone_named(rig, "leg_front_left");
    const auto largest = [&](const BoneAnimation& animation, int bone) {
        double turn = 0;
        for (const Quaternion& q : animation.rotations[bone]) turn = std::max(turn, std::abs(q.z));
        return turn;
    };
    const double full = largest(retarget(rig, c.reference, walk), leg);
    for (Bone& bone : rig.bones)
        if (bone.label == Label::limb) bone.freedom = 0.4;
    CHECK(largest(retarget(rig, c.reference, walk), leg) < 0.5 * full);

    Character two = c; // only the two front legs
    two.mapping.pairs.resize(4);
    fill(two.labels, 60, 50, 100, 100, Label::background);
    two.graph.edges.erase(two.graph.edges.begin() + 7, two.graph.edges.end());
    const Rig biped = rig_of(two);
    const BoneAnimation animation = retarget(biped, two.reference, walk);
    const int a = bone_named(biped, "leg_front_left"), b = bone_named(biped, "leg_front_right");
    REQUIRE(a > 0);
    REQUIRE(b > 0);
    for (int i = 0; i < 12; ++i) // half a cycle apart
        CHECK(animation.rotations[a][i].z == Approx(animation.rotations[b][i + 12].z).margin(1e-12));
}

TEST_CASE("the view holds every frame") {
    const Character c = table();
    const Rig rig = rig_of(c);
    const BoneAnimation walk = retarget(rig, c.reference, c.reference.clips[0]);
    const View view = view_of(rig, {walk});
    for (double time : {0.0, 0.1, 0.35, 0.8})
        for (const Vec3& p : skin(rig, walk, time)) {
            CHECK(p.x > view.left);
            CHECK(p.x < view.left + view.width);
            CHECK(p.y > view.bottom);
            CHECK(p.y < view.bottom + view.height);
        }
}
