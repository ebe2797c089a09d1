// SPDX-License-Identifier: MIT
// A posed mesh's vertices in, outward unit normals out: the faces' normals, by area (own).
#include "pantin/animation.hpp"

namespace pantin {

std::vector<Vec3> vertex_normals(const Mesh& mesh, const std::vector<Vec3>& vertices) {
    std::vector<Vec3> normals(vertices.size());
    for (const std::vector<int>& face : mesh.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const int a = face[0], b = face[i + 1], c = face[i]; // faces run clockwise seen from outside
            const Vec3 normal =
                cross(vertices[b] - vertices[a], vertices[c] - vertices[a]); // twice the area long
            for (const int corner : {a, b, c}) normals[corner] = normals[corner] + normal;
        }
    for (Vec3& normal : normals) {
        const double size = length(normal);
        normal = size > 0 ? (1 / size) * normal : Vec3{0, 0, 1};
    }
    return normals;
}

} // namespace pantin
