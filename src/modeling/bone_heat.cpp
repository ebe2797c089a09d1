// SPDX-License-Identifier: MIT
// This work is based on: I. Baran, J. Popović, Automatic rigging and animation of 3D characters, 2007,
// section 4.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <Eigen/SparseCholesky>

#include "pantin/model.hpp"
#include "rigging/skin_weights.hpp"

namespace pantin {
namespace {

constexpr double heat = 2;             // c: the larger, the more the nearest bone counts
constexpr double same_distance = 1e-9; // of the mesh's size: bones so equally near share the heat
constexpr double least_weight = 1e-4;  // smaller influences are dropped

using Matrix = Eigen::SparseMatrix<double>;

double distance_to(const BoneSegment& bone, Vec3 p) {
    const Vec3 along = bone.tail - bone.head;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(p - bone.head, along) / square, 0.0, 1.0) : 0;
    return distance(p, bone.head + t * along);
}

struct Nearest {
    std::vector<int> bones; // all that are equally near to the surface of their part
    double distance = 0;    // of the first one's axis
};

Nearest nearest_bones(Vec3 p, const std::vector<BoneSegment>& bones, double tolerance) {
    Nearest nearest;
    double best = std::numeric_limits<double>::infinity();
    for (int b = 0; b < std::ssize(bones); ++b) {
        const double axis = distance_to(bones[b], p), gap = axis - bones[b].radius;
        if (gap > best + tolerance) continue;
        if (gap < best - tolerance) nearest.bones.clear(), best = gap, nearest.distance = axis;
        nearest.bones.push_back(b);
    }
    return nearest;
}

double size_of(const SolidMesh& mesh) {
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& v : mesh.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return distance(low, high);
}

// The surface's Laplacian, its edge weights at least 0, and a third of each triangle's area at its corners.
void add_surface(const SolidMesh& mesh, std::vector<Eigen::Triplet<double>>& entries,
                 std::vector<double>& area) {
    for (const auto& triangle : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const int at = triangle[k], i = triangle[(k + 1) % 3], j = triangle[(k + 2) % 3];
            const Vec3 u = mesh.vertices[i] - mesh.vertices[at], v = mesh.vertices[j] - mesh.vertices[at];
            const double twice = length(cross(u, v));
            area[at] += twice / 6;
            const double weight = twice > 0 ? 0.5 * std::max(dot(u, v) / twice, 0.0) : 0;
            entries.emplace_back(i, i, weight);
            entries.emplace_back(j, j, weight);
            entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
        }
}

// Four influences are left: what the fifth has is taken from all, so that weights stay continuous where one
// bone takes another's place.
void keep_four(std::vector<double>& weights) {
    if (weights.size() <= 4) return;
    std::vector<double> sorted = weights;
    std::nth_element(sorted.begin(), sorted.begin() + 4, sorted.end(), std::greater<>());
    const double fifth = sorted[4];
    if (*std::max_element(weights.begin(), weights.end()) <= fifth)
        return; // five equal ones: the first four stay
    for (double& w : weights) w = std::max(w - fifth, 0.0);
}

} // namespace

std::vector<VertexWeights> bone_heat(const SolidMesh& mesh, const std::vector<BoneSegment>& bones) {
    const int count = static_cast<int>(mesh.vertices.size()), bone_count = static_cast<int>(bones.size());
    if (count == 0 || bone_count == 0) return std::vector<VertexWeights>(mesh.vertices.size());
    const double size = size_of(mesh);
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> area(mesh.vertices.size(), 0);
    add_surface(mesh, entries, area);
    Eigen::MatrixXd sources = Eigen::MatrixXd::Zero(count, bone_count);
    for (int v = 0; v < count; ++v) {
        const Nearest nearest = nearest_bones(mesh.vertices[v], bones, same_distance * size);
        const double d = std::max(nearest.distance, 1e-4 * size);
        const double strength = heat * std::max(area[v], 1e-12 * size * size) / (d * d);
        entries.emplace_back(v, v, strength);
        for (const int b : nearest.bones)
            sources(v, b) = strength / static_cast<double>(nearest.bones.size());
    }
    Matrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factors(matrix);
    for (int b = 0; b < bone_count; ++b) sources.col(b) = factors.solve(Eigen::VectorXd(sources.col(b)));

    std::vector<VertexWeights> weights;
    std::vector<double> row(bones.size());
    for (int v = 0; v < count; ++v) {
        for (int b = 0; b < bone_count; ++b)
            row[b] = sources(v, b) < least_weight ? 0 : std::min(sources(v, b), 1.0);
        keep_four(row);
        weights.push_back(quantised(row));
    }
    return weights;
}

} // namespace pantin
