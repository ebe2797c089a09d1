// SPDX-License-Identifier: MIT
// How far one surface is from another, for the tests of this module.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "pantin/model.hpp"

namespace pantin::test {

// Distances of points to a surface, by a tree of boxes around its triangles.
class NearestOnSurface {
public:
    explicit NearestOnSurface(const SolidMesh& mesh) {
        for (const auto& [a, b, c] : mesh.triangles)
            triangles_.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
        boxes_.resize(2 * triangles_.size());
        build(0, 0, triangles_.size());
    }
    double distance_of(Vec3 p) const {
        double nearest = std::numeric_limits<double>::infinity();
        search(p, 0, 0, triangles_.size(), nearest);
        return nearest;
    }

private:
    using Triangle = std::array<Vec3, 3>;
    struct Bounds {
        Vec3 low, high;
    };
    // A node holds the triangles [begin, end); its first child is the next box, the second one comes after
    // the first one's boxes.
    static std::size_t second_child(std::size_t box, std::size_t begin, std::size_t middle) {
        return box + 2 * (middle - begin);
    }

    void build(std::size_t box, std::size_t begin, std::size_t end) {
        Bounds bounds{triangles_[begin][0], triangles_[begin][0]};
        for (std::size_t t = begin; t < end; ++t)
            for (const Vec3& v : triangles_[t])
                for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
                    bounds.low.*axis = std::min(bounds.low.*axis, v.*axis);
                    bounds.high.*axis = std::max(bounds.high.*axis, v.*axis);
                }
        boxes_[box] = bounds;
        if (end - begin == 1) return;
        const Vec3 size = bounds.high - bounds.low;
        const auto axis = size.x >= std::max(size.y, size.z) ? &Vec3::x
                          : size.y >= size.z                 ? &Vec3::y
                                                             : &Vec3::z;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto sum = [&](const Triangle& t) { return t[0].*axis + t[1].*axis + t[2].*axis; };
        std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                         [&](const Triangle& s, const Triangle& t) { return sum(s) < sum(t); });
        build(box + 1, begin, middle);
        build(second_child(box, begin, middle), middle, end);
    }

    void search(Vec3 p, std::size_t box, std::size_t begin, std::size_t end, double& nearest) const {
        if (to_box(p, boxes_[box]) >= nearest) return;
        if (end - begin == 1) {
            nearest = std::min(nearest, to_triangle(p, triangles_[begin]));
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2, second = second_child(box, begin, middle);
        if (to_box(p, boxes_[box + 1]) <= to_box(p, boxes_[second])) {
            search(p, box + 1, begin, middle, nearest);
            search(p, second, middle, end, nearest);
        } else {
            search(p, second, middle, end, nearest);
            search(p, box + 1, begin, middle, nearest);
        }
    }

    static double to_box(Vec3 p, const Bounds& box) {
        const auto outside = [&](double Vec3::*axis) {
            return std::max({box.low.*axis - p.*axis, 0.0, p.*axis - box.high.*axis});
        };
        return length(Vec3{outside(&Vec3::x), outside(&Vec3::y), outside(&Vec3::z)});
    }
    static double to_segment(Vec3 p, Vec3 a, Vec3 b) {
        const Vec3 v = b - a;
        const double square = dot(v, v), t = square > 0 ? std::clamp(dot(p - a, v) / square, 0.0, 1.0) : 0;
        return distance(p, a + t * v);
    }
    static double to_triangle(Vec3 p, const Triangle& t) {
        const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
        bool over = length(normal) > 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = t[k], b = t[(k + 1) % 3];
            over = over && dot(cross(normal, b - a), p - a) >= 0;
            nearest = std::min(nearest, to_segment(p, a, b));
        }
        return over ? std::abs(dot(normal, p - t[0])) / length(normal) : nearest;
    }

    std::vector<Triangle> triangles_;
    std::vector<Bounds> boxes_;
};

// From corners and middles of one surface's triangles to the other surface, both ways.
struct SurfaceDistance {
    double mean = 0, largest = 0;
};
inline SurfaceDistance surface_distance(const SolidMesh& a, const SolidMesh& b) {
    SurfaceDistance result;
    std::size_t count = 0;
    const auto one_way = [&](const SolidMesh& from, const SolidMesh& to) {
        std::vector<Vec3> points = from.vertices;
        for (const auto& [i, j, k] : from.triangles)
            points.push_back((1.0 / 3) * (from.vertices[i] + from.vertices[j] + from.vertices[k]));
        const NearestOnSurface nearest(to);
        for (const Vec3& p : points) {
            const double d = nearest.distance_of(p);
            result.mean += d;
            result.largest = std::max(result.largest, d);
        }
        count += points.size();
    };
    one_way(a, b);
    one_way(b, a);
    result.mean /= static_cast<double>(count);
    return result;
}

} // namespace pantin::test
