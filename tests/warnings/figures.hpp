// SPDX-License-Identifier: MIT
// Rigs made by hand for the tests of warnings.
#pragma once

#include <vector>

#include "rigging/figures.hpp"

namespace pantin::test {

using tests::fill;

// A mesh vertex on every second labelled pixel, moved by the bone that `bone_of` gives for its place alone.
template <class BoneOf> Rig rig_on(const LabelMap& labels, std::vector<Bone> bones, BoneOf bone_of) {
    Rig rig;
    rig.width = labels.width(), rig.height = labels.height();
    rig.bones = std::move(bones);
    for (int y = 0; y < labels.height(); y += 2)
        for (int x = 0; x < labels.width(); x += 2) {
            if (labels(x, y) == 0) continue;
            rig.mesh.vertices.push_back({static_cast<double>(x), static_cast<double>(y)});
            rig.depth.push_back(0);
            rig.weights.push_back({{bone_of(x, y), 0, 0, 0}, {1, 0, 0, 0}});
        }
    return rig;
}

// Keys of an animation of one second in which bone b turns about z by the angle whose half has the cosine
// cosines[b][key] and the sine sines[b][key].
inline BoneAnimation turning(const std::string& name, const std::vector<std::vector<double>>& cosines,
                             const std::vector<std::vector<double>>& sines) {
    BoneAnimation animation;
    animation.name = name;
    animation.duration = 1;
    const std::size_t keys = cosines.front().size();
    for (std::size_t k = 0; k < keys; ++k)
        animation.times.push_back(static_cast<double>(k) / static_cast<double>(keys - 1));
    animation.root_translation.resize(keys);
    for (std::size_t b = 0; b < cosines.size(); ++b) {
        animation.rotations.emplace_back();
        for (std::size_t k = 0; k < keys; ++k)
            animation.rotations.back().push_back({0, 0, sines[b][k], cosines[b][k]});
    }
    return animation;
}

} // namespace pantin::test
