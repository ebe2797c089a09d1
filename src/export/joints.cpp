// SPDX-License-Identifier: MIT
// The rig's bones in, glTF joints out, at rest along +Y (glTF 2.0 specification, 3.7.3; joints.hpp has the
// algebra).
#include "export/joints.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

Quaternion conjugate(Quaternion q) { return {-q.x, -q.y, -q.z, q.w}; }

Quaternion multiply(Quaternion a, Quaternion b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

Vec3 rotate(Quaternion q, Vec3 v) {
    const Quaternion turned = multiply(multiply(q, {v.x, v.y, v.z, 0}), conjugate(q));
    return {turned.x, turned.y, turned.z};
}

// The turn about z that takes +Y to the direction (x, y), by the half-angle formulas: no trigonometry.
Quaternion from_up_to(double x, double y) {
    const double length = std::sqrt(x * x + y * y);
    if (length < 1e-9) return {};
    const double cosine = std::clamp(y / length, -1.0, 1.0);
    const double half = std::sqrt((1 - cosine) / 2);
    return {0, 0, x > 0 ? -half : half, std::sqrt((1 + cosine) / 2)};
}

Joint place(std::string name, int parent, Vec3 head, Quaternion rest, const std::vector<Joint>& joints) {
    Joint joint{std::move(name), parent, head, rest, head, rest};
    if (parent >= 0) {
        const Joint& above = joints[static_cast<std::size_t>(parent)];
        joint.translation = rotate(conjugate(above.rest), head - above.head);
        joint.rotation = multiply(conjugate(above.rest), rest);
    }
    return joint;
}

} // namespace

std::vector<Joint> make_joints(const Rig& rig) {
    std::vector<Joint> joints;
    joints.push_back(place("root", -1, {}, {}, joints));
    std::vector<bool> leaf(rig.bones.size(), true);
    for (const Bone& bone : rig.bones) {
        const Vec3 head = to_world(bone.head, rig.width, rig.height, bone.head_depth);
        const Vec3 tail = to_world(bone.tail, rig.width, rig.height, bone.tail_depth);
        joints.push_back(
            place(bone.name, bone.parent + 1, head, from_up_to(tail.x - head.x, tail.y - head.y), joints));
        if (bone.parent >= 0) leaf[static_cast<std::size_t>(bone.parent)] = false;
    }
    for (std::size_t b = 0; b < rig.bones.size(); ++b) {
        if (!leaf[b]) continue;
        const Vec3 tail = to_world(rig.bones[b].tail, rig.width, rig.height, rig.bones[b].tail_depth);
        joints.push_back(
            place(rig.bones[b].name + ".end", static_cast<int>(b) + 1, tail, joints[b + 1].rest, joints));
    }
    return joints;
}

Quaternion node_rotation(const std::vector<Joint>& joints, std::size_t joint, Quaternion turn) {
    const Joint& j = joints[joint];
    const Quaternion above = j.parent >= 0 ? joints[static_cast<std::size_t>(j.parent)].rest : Quaternion{};
    return multiply(multiply(conjugate(above), turn), j.rest);
}

std::array<float, 16> inverse_bind_matrix(const Joint& joint) {
    const Quaternion back = conjugate(joint.rest);
    const Vec3 columns[4] = {rotate(back, {1, 0, 0}), rotate(back, {0, 1, 0}), rotate(back, {0, 0, 1}),
                             rotate(back, Vec3{} - joint.head)};
    std::array<float, 16> matrix{};
    for (std::size_t c = 0; c < 4; ++c) {
        matrix[4 * c] = static_cast<float>(columns[c].x);
        matrix[4 * c + 1] = static_cast<float>(columns[c].y);
        matrix[4 * c + 2] = static_cast<float>(columns[c].z);
    }
    matrix[15] = 1;
    return matrix;
}

} // namespace pantin
