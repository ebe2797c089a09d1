// SPDX-License-Identifier: MIT
// The rig's bones as glTF joints.
//
// The rig animates in world axes: the rotation of every bone is the identity at rest. Blender and others draw
// a joint as a bone along its local +Y, so every joint node is turned at rest by Q, which takes +Y to the
// bone's direction:
//   world at rest       W = T(head) Q
//   node at rest        translation Qp⁻¹ (head − head_p), rotation Qp⁻¹ Q        (p: the parent)
//   node, bone turned R rotation Qp⁻¹ R Q, the translation stays
//   inverse bind matrix Q⁻¹ T(−head)
// so that world · inverse bind matrix is the bone's motion in world axes, T(head) R T(−head) in the parent's
// frame.
#pragma once

#include <string>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

// Parents come first. Joint 0, "root", stands on the ground and carries the character's translation; joint b
// + 1 is bone b of the rig; an end joint `<bone>.end` closes every bone without children, so that it has a
// length.
struct Joint {
    std::string name;
    int parent = -1;
    Vec3 head;           // world
    Quaternion rest;     // Q
    Vec3 translation;    // of the node
    Quaternion rotation; // of the node, at rest
};
std::vector<Joint> make_joints(const Rig& rig);

// Rotation of the node of bone `joint` when the rig turns it by `turn`.
Quaternion node_rotation(const std::vector<Joint>& joints, std::size_t joint, Quaternion turn);

// Column-major, as glTF stores it.
std::array<float, 16> inverse_bind_matrix(const Joint& joint);

} // namespace pantin
