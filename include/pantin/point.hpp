// SPDX-License-Identifier: MIT
// Points. In the plane: pixel coordinates, x right, y down.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace pantin {

struct Point2i {
    int x = 0, y = 0;
    bool operator==(const Point2i&) const = default;
};

struct Point2d {
    double x = 0, y = 0;
    bool operator==(const Point2d&) const = default;
};

// Vector arithmetic in the units of the arguments: sum, difference, multiple, scalar product, z of the vector
// product (positive: b is clockwise of a on the screen, where y points down), length, distance. No error.
// Own.
inline Point2d operator+(Point2d a, Point2d b) { return {a.x + b.x, a.y + b.y}; }
inline Point2d operator-(Point2d a, Point2d b) { return {a.x - b.x, a.y - b.y}; }
inline Point2d operator*(double s, Point2d a) { return {s * a.x, s * a.y}; }
inline double dot(Point2d a, Point2d b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point2d a, Point2d b) { return a.x * b.y - a.y * b.x; }
inline double length(Point2d a) { return std::sqrt(dot(a, a)); } // sqrt, not hypot: exact on every C library
inline double distance(Point2d a, Point2d b) { return length(a - b); }
inline Point2d to_double(Point2i p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

// 3D: right-handed, x to the right, y up, z towards the viewer.
struct Vec3 {
    double x = 0, y = 0, z = 0;
    bool operator==(const Vec3&) const = default;
};

// As in the plane; cross: the vector product, right-handed. No error. Own.
inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline double distance(Vec3 a, Vec3 b) { return length(a - b); }

// An axis-aligned rectangle of pixels: columns x … x+width−1, rows y … y+height−1.
struct Box {
    int x = 0, y = 0, width = 0, height = 0;
    std::int64_t area() const { return std::int64_t{width} * height; }
    bool operator==(const Box&) const = default;
};

} // namespace pantin
