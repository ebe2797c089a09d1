// SPDX-License-Identifier: MIT
// The joints of a character folder of AnimatedDrawings: char_cfg.yaml (or .yml), a figure of any body.
// Reading needs yaml-cpp (yaml_available).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pantin/point.hpp"

namespace pantin {

struct FigureJoint {
    std::string name;
    Point2d place;   // pixels of texture.png
    int parent = -1; // index of the joint that it hangs on; −1: none
    bool operator==(const FigureJoint&) const = default;
};
struct FigureJoints {
    // In the file's order; parents make trees. Empty when the file cannot be used.
    std::vector<FigureJoint> joints;
    // The first thing that is wrong, one line that names the file and the fact; joints that are there
    // nevertheless can be used. Empty: nothing is.
    std::string remark;
};

// The file of joints in the folder, which need not exist.
std::filesystem::path joints_file(const std::filesystem::path& folder);
// The joints of a folder whose texture.png has the given size. No error: what is wrong is the remark. A name
// that is given twice means its first joint where it is a parent; of a parent that is not there, or that
// hangs on its own child, nothing hangs. Format: AnimatedDrawings (Smith et al. 2023).
FigureJoints read_joints(const std::filesystem::path& folder, int width, int height);
// Whether the file names all joints of a human figure (animated_drawings_joints). No error. Own.
bool names_humanoid(const std::filesystem::path& folder);

} // namespace pantin
