// SPDX-License-Identifier: MIT
// Vectors and rotations of the animation step.
#pragma once

#include <cmath>

#include "pantin/animation.hpp"

namespace pantin {

// Rows of a rotation matrix.
struct Matrix3 {
    Vec3 rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};
inline Vec3 operator*(const Matrix3& m, Vec3 v) {
    const auto dot = [&v](const Vec3& row) { return row.x * v.x + row.y * v.y + row.z * v.z; };
    return {dot(m.rows[0]), dot(m.rows[1]), dot(m.rows[2])};
}

// Turns first by b, then by a.
inline Quaternion operator*(Quaternion a, Quaternion b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

inline Quaternion normalised(Quaternion q) {
    const double n = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x / n, q.y / n, q.z / n, q.w / n};
}

// The rotation matrix of a unit quaternion; exactly the identity for (0, 0, 0, 1).
inline Matrix3 matrix_of(Quaternion q) {
    return {{{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.z * q.w), 2 * (q.x * q.z + q.y * q.w)},
             {2 * (q.x * q.y + q.z * q.w), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.x * q.w)},
             {2 * (q.x * q.z - q.y * q.w), 2 * (q.y * q.z + q.x * q.w), 1 - 2 * (q.x * q.x + q.y * q.y)}}};
}

} // namespace pantin
