// SPDX-License-Identifier: MIT
// Character folders of AnimatedDrawings (facebookresearch/AnimatedDrawings): texture.png, mask.png and
// char_cfg.yaml, whose joints figure_joints.hpp reads.
#pragma once

#include <array>
#include <filesystem>

#include "pantin/image.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

// The joints of a human figure in AnimatedDrawings, parents first. "neck" is the middle of the head; left and
// right are the figure's own.
struct AnimatedDrawingsJoint {
    const char *name, *parent;
};
inline constexpr std::array<AnimatedDrawingsJoint, 16> animated_drawings_joints = {
    {{"root", nullptr},
     {"hip", "root"},
     {"torso", "hip"},
     {"neck", "torso"},
     {"right_shoulder", "torso"},
     {"right_elbow", "right_shoulder"},
     {"right_hand", "right_elbow"},
     {"left_shoulder", "torso"},
     {"left_elbow", "left_shoulder"},
     {"left_hand", "left_elbow"},
     {"right_hip", "root"},
     {"right_knee", "right_hip"},
     {"right_foot", "right_knee"},
     {"left_hip", "root"},
     {"left_knee", "left_hip"},
     {"left_foot", "left_knee"}}};

// Whether it is a folder with char_cfg.yaml (or .yml) or texture.png. No error. Own.
bool is_animated_drawings_folder(const std::filesystem::path& folder);

// Writes texture.png, mask.png and char_cfg.yaml for a rig with two arms and two legs; false when it has
// none.
bool write_animated_drawings(const std::filesystem::path& folder, const Rig& rig,
                             const ReferenceSkeleton& reference, const RgbaImage& texture);

} // namespace pantin
