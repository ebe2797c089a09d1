// SPDX-License-Identifier: MIT
// What every mesh has to be, and masks to make meshes of.
#pragma once

#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <utility>

#include "core/random.hpp"
#include "pantin/rigging.hpp"

namespace pantin::test {

inline double area_of(const Mesh& mesh) {
    double twice = 0;
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i)
            twice += cross(mesh.vertices[face[i]], mesh.vertices[face[(i + 1) % face.size()]]);
    return twice / 2;
}

// Area inside the mesh's border: the directed edges that no other face runs through the other way.
inline double border_area(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
    double twice = 0;
    for (const auto& [edge, count] : edges)
        if (!edges.count({edge.second, edge.first}))
            twice += cross(mesh.vertices[edge.first], mesh.vertices[edge.second]);
    return twice / 2;
}

inline Mask random_blobs(Random& random, int side, int blobs) {
    Mask mask(side, side);
    for (int b = 0; b < blobs; ++b) {
        const double x = random.uniform(0, side), y = random.uniform(0, side),
                     r = random.uniform(1, side / 5.0);
        const std::uint8_t value = b % 4 != 3;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                if ((i - x) * (i - x) + (j - y) * (j - y) < r * r) mask(i, j) = value;
    }
    return mask;
}

inline void check_is_proper(const Mesh& mesh) {
    std::set<std::pair<double, double>> places;
    for (const Point2d& p : mesh.vertices) places.insert({p.x, p.y});
    CHECK(places.size() == mesh.vertices.size());
    std::map<std::pair<int, int>, int> directed;
    for (const std::vector<int>& face : mesh.faces) {
        CHECK(face.size() >= 3);
        CHECK(face.size() <= 6);
        double twice = 0;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int u = face[i], v = face[(i + 1) % face.size()];
            ++directed[{u, v}];
            twice += cross(mesh.vertices[u], mesh.vertices[v]);
        }
        CHECK(twice > 0); // clockwise on screen
    }
    for (const auto& [edge, count] : directed) CHECK(count == 1); // so two faces at most, of one orientation
}

} // namespace pantin::test
