// SPDX-License-Identifier: MIT
// Linear blend skinning (Magnenat-Thalmann, Laperrière, Thalmann 1988) of the flat mesh in 3D.
#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/vector.hpp"
#include "pantin/animation.hpp"

namespace pantin {
namespace {

// A bone's place in the world: p ↦ rotation · (p − head) + position.
struct Placement {
    Quaternion turn;
    Matrix3 rotation;
    Vec3 head, position;
};

struct Key {
    std::size_t index = 0; // between this key and the next
    double share = 0;
};

Key key_at(const BoneAnimation& animation, double time) {
    const std::size_t n = animation.times.size();
    if (n < 2) return {};
    time -= animation.duration * std::floor(time / animation.duration);
    std::size_t i = 0;
    while (i + 2 < n && animation.times[i + 1] <= time) ++i;
    const double step = animation.times[i + 1] - animation.times[i];
    return {i, std::clamp((time - animation.times[i]) / step, 0.0, 1.0)};
}

// Normalised linear interpolation along the shorter way; keys lie close, so it keeps to the arc.
Quaternion between(Quaternion a, Quaternion b, double t) {
    if (t == 0) return a;
    const double dot = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, s = dot < 0 ? -t : t;
    return normalised(
        {(1 - t) * a.x + s * b.x, (1 - t) * a.y + s * b.y, (1 - t) * a.z + s * b.z, (1 - t) * a.w + s * b.w});
}

std::vector<Placement> place_bones(const Rig& rig, const BoneAnimation& animation, double time) {
    const Key key = key_at(animation, time);
    const std::size_t next = key.index + (animation.times.size() > 1 ? 1 : 0);
    std::vector<Placement> placed(rig.bones.size());
    for (std::size_t b = 0; b < rig.bones.size(); ++b) {
        Placement& p = placed[b];
        const auto& keys = animation.rotations[b];
        const Quaternion local = between(keys[key.index], keys[next], key.share);
        p.head = to_world(rig.bones[b].head, rig.width, rig.height, rig.bones[b].head_depth);
        if (rig.bones[b].parent < 0) {
            const Vec3 from = animation.root_translation[key.index], to = animation.root_translation[next];
            p.turn = local;
            p.position = p.head + from + key.share * (to - from);
        } else {
            const Placement& parent = placed[rig.bones[b].parent];
            p.turn = normalised(parent.turn * local);
            p.position = parent.rotation * (p.head - parent.head) + parent.position;
        }
        p.rotation = matrix_of(p.turn);
    }
    if (!animation.depths.empty())
        for (std::size_t b = 0; b < rig.bones.size(); ++b) {
            const std::vector<double>& depths = animation.depths[b];
            placed[b].position.z += depths[key.index] + key.share * (depths[next] - depths[key.index]);
        }
    return placed;
}

} // namespace

Vec3 to_world(Point2d working_pixel, int width, int height, double depth) {
    return {(working_pixel.x + 0.5 - 0.5 * width) / height, (height - 0.5 - working_pixel.y) / height, depth};
}

std::vector<Vec3> skin(const Rig& rig, const BoneAnimation& animation, double time) {
    const std::vector<Placement> placed = place_bones(rig, animation, time);
    std::vector<Vec3> vertices(rig.mesh.vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const Vec3 rest = to_world(rig.mesh.vertices[v], rig.width, rig.height, rig.depth[v]);
        const VertexWeights& w = rig.weights[v];
        for (int k = 0; k < 4 && w.weights[k] > 0; ++k) {
            const Placement& p = placed[w.bones[k]];
            vertices[v] = vertices[v] + w.weights[k] * (p.rotation * (rest - p.head) + p.position);
        }
    }
    return vertices;
}

BoneAnimation as_filmed(BoneAnimation animation) {
    for (std::size_t i = 0; i < animation.camera.size(); ++i)
        animation.root_translation[i].x -= animation.camera[i];
    animation.camera.clear();
    return animation;
}

View view_of(const Rig& rig, const std::vector<BoneAnimation>& animations) {
    constexpr double margin = 0.02; // of the longer side
    double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;
    const auto include = [&](const Vec3& p) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        bottom = std::min(bottom, p.y), top = std::max(top, p.y);
    };
    for (std::size_t v = 0; v < rig.mesh.vertices.size(); ++v)
        include(to_world(rig.mesh.vertices[v], rig.width, rig.height));
    for (const BoneAnimation& animation : animations)
        for (double time : animation.times)
            for (const Vec3& p : skin(rig, animation, time)) include(p);
    if (!(right >= left)) return {};
    const double pad = margin * std::max(right - left, top - bottom);
    return {left - pad, bottom - pad, right - left + 2 * pad, top - bottom + 2 * pad};
}

} // namespace pantin
