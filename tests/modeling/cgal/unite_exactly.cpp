// SPDX-License-Identifier: MIT
// The union of solids by CGAL's polygon mesh processing (Loriot, Rouxel-Labbé, Tournois, Yaz:
// corefine_and_compute_union), to compare unite() with.
//
// The only file that touches CGAL, whose polygon mesh processing is GPL-3+. Points are made exactly (numbers
// that remember how they were made), so each union's result is a valid input of the next; only what comes out
// at the end is rounded.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <string>

#include "modeling/cgal/unite_exactly.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Kernel::Point_3>;

ExactMesh to_exact(const SolidMesh& mesh) {
    ExactMesh result;
    for (const Vec3& v : mesh.vertices) result.add_vertex({v.x, v.y, v.z});
    for (const auto& [a, b, c] : mesh.triangles) {
        using Vertex = ExactMesh::Vertex_index;
        if (result.add_face(Vertex(a), Vertex(b), Vertex(c)) == ExactMesh::null_face())
            throw Error(ErrorKind::input, "exact union: a part's surface is no manifold");
    }
    return result;
}

SolidMesh rounded(ExactMesh& mesh) {
    mesh.collect_garbage(); // so that vertices are numbered without gaps
    SolidMesh result;
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        result.vertices.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for (const auto f : mesh.faces()) {
        std::array<int, 3> corners{};
        int k = 0;
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
            corners[k++] = static_cast<int>(v.idx());
        result.triangles.push_back(corners);
    }
    return result;
}

} // namespace

bool exact_union_available() { return true; }

SolidMesh unite_exactly(const std::vector<InflatedPart>& parts) {
    try {
        ExactMesh all;
        for (const InflatedPart& part : parts) {
            ExactMesh next = to_exact(part_surface(*part.inflation, part.height, part.frame)), result;
            if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(all, next, result))
                throw Error(
                    ErrorKind::input,
                    "exact union: parts touch along a line or in a point, their union is no manifold");
            all = result;
        }
        return rounded(all);
    } catch (const CGAL::Failure_exception& failure) {
        throw Error(ErrorKind::internal, "exact union: CGAL: " + failure.message());
    }
}

} // namespace pantin
