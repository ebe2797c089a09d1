// SPDX-License-Identifier: MIT
// A small rig made by hand for the tests of the exporters.
#pragma once

#include "pantin/animation.hpp"
#include "pantin/rigging.hpp"

namespace pantin::test {

// A square of 2 × 2 quads in a working crop of 8 × 8 pixels; three bones: hips, leg (upper), leg.1 (lower).
inline Rig square_rig() {
    Rig rig;
    rig.width = rig.height = 8;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            rig.mesh.vertices.push_back({4.0 * x - 0.5, 4.0 * y - 0.5});
            rig.texture.push_back({x / 2.0, y / 2.0});
            rig.depth.push_back(x == 1 && y == 1 ? 0.001 : 0.0);
        }
    // Clockwise on the screen: right, then down.
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            const int a = 3 * y + x;
            rig.mesh.faces.push_back({a, a + 1, a + 4, a + 3});
        }
    rig.bones = {{"hips", -1, {4, 4}, {4, 1}, Label::body, 0, 0, false},
                 {"leg", 0, {5, 5}, {6, 6}, Label::limb, 1, 0, false},
                 {"leg.1", 1, {6, 6}, {6, 7.5}, Label::limb, 1, 1, false}};
    for (std::size_t i = 0; i < rig.mesh.vertices.size(); ++i)
        rig.weights.push_back({{0, 0, 0, 0}, {1, 0, 0, 0}});
    rig.weights[4] = {{1, 0, 2, 0}, {0.1, 0.2, 0.7, 0}};
    rig.weights[8] = {{2, 1, 0, 0}, {1.0 / 3, 1.0 / 3, 1 - 2.0 / 3, 0}};
    return rig;
}

// About z, by the angle whose half has this cosine and sine.
inline Quaternion turn_z(double half_cosine, double half_sine) { return {0, 0, half_sine, half_cosine}; }

inline BoneAnimation swing() {
    BoneAnimation animation;
    animation.name = "walk";
    animation.duration = 1;
    animation.times = {0, 0.5, 1};
    const Quaternion rest, left = turn_z(0.8, 0.6), up{0.6, 0, 0, 0.8};
    animation.rotations = {{rest, rest, rest}, {rest, left, rest}, {rest, up, rest}};
    animation.root_translation = {{0, 0, 0}, {0.25, 0.5, 0}, {0, 0, 0}};
    return animation;
}

} // namespace pantin::test
