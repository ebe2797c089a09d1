// SPDX-License-Identifier: MIT
// Thesis 4.6 from the mapped end-effectors on: mesh, bones, weights, texture coordinates. `thesis_weights` is
// Algorithm 4.4 on one bone per end-effector; otherwise limbs have several bones along the skeleton and
// smooth weights.
#include <algorithm>
#include <array>
#include <cmath>

#include "image/label_map.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "pantin/rigging.hpp"
#include "rigging/bones.hpp"
#include "rigging/cut.hpp"
#include "rigging/inward_paths.hpp"
#include "rigging/limbs.hpp"
#include "rigging/mesh_topology.hpp"
#include "rigging/skin_weights.hpp"
#include "rigging/thesis_weights.hpp"

namespace pantin {
namespace {

constexpr double depth_step = 0.002; // world units between two parts in the draw order

// The median edge along the axes: the cell, also when it was chosen automatically. Of Voronoi regions, whose
// edges are shorter, a pixel.
double cell_of(const Mesh& mesh) {
    std::vector<double> lengths = {1};
    for (const auto& [u, v] : edges_of(mesh)) {
        const Point2d d = mesh.vertices[v] - mesh.vertices[u];
        if (d.x == 0 || d.y == 0) lengths.push_back(length(d));
    }
    const auto middle = lengths.begin() + std::ssize(lengths) / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return std::max(1.0, *middle);
}

Point2d centre_of(const LabelMap& labels, const Mask& silhouette, Label label, Point2d otherwise) {
    double x = 0, y = 0, count = 0;
    for (int row = 0; row < labels.height(); ++row)
        for (int column = 0; column < labels.width(); ++column)
            if (silhouette(column, row) && labels(column, row) == static_cast<int>(label))
                x += column, y += row, ++count;
    return count > 0 ? Point2d{x / count, y / count} : otherwise;
}

std::vector<Point2d> texture_coordinates(const Mesh& mesh, int width, int height) {
    std::vector<Point2d> texture;
    for (const Point2d& p : mesh.vertices) texture.push_back({(p.x + 0.5) / width, (p.y + 0.5) / height});
    return texture;
}

// Draw order at rest, from back to front: tail, every second limb, body, wings, the other limbs, head.
double layer_of(const Bone& bone, int limb_index) {
    const LabelRow& row = row_of(bone.label);
    return limb_index % 2 == 0 ? row.layer : row.second;
}

std::vector<double> part_depths(const std::vector<Bone>& bones, const std::vector<VertexWeights>& weights) {
    std::vector<double> layer(bones.size(), 0);
    std::array<int, label_count> limbs{}; // seen so far, by label
    for (std::size_t b = 1; b < bones.size(); ++b) {
        const bool continues = bones[b].segment > 0;
        layer[b] = continues ? layer[bones[b].parent]
                             : layer_of(bones[b], limbs[static_cast<std::size_t>(bones[b].label)]++);
    }
    std::vector<double> depth;
    for (const VertexWeights& w : weights) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) sum += w.weights[k] * layer[w.bones[k]];
        depth.push_back(depth_step * sum);
    }
    return depth;
}

void require_bones(std::size_t bones) {
    if (bones < 2)
        throw CharacterRejected("rig", "no end-effector could be mapped to the reference skeleton");
}

void rig_as_in_thesis(Rig& rig, const SkeletonGraph& graph, const LabelMap& labels, const LabelMap& filled,
                      const ReferenceSkeleton& reference, bool mirrored, WeightEnds ends) {
    const Point2d root = inward_paths(graph, filled, distance_transform(foreground(labels))).root;
    rig.bones = make_thesis_bones(graph, reference, rig.mapping, mirrored, root);
    rig.weights = thesis_weights(rig.mesh, filled, graph, reference, rig.mapping, ends);
}

void rig_smoothly(Rig& rig, const SkeletonGraph& graph, const LabelMap& labels, const LabelMap& filled,
                  const ReferenceSkeleton& reference, bool mirrored, const RigOptions& options) {
    const Mask silhouette = foreground(labels);
    Limbs limbs = find_limbs(graph, filled, distance_transform(silhouette), reference, rig.mapping);
    const Grid<Owner> pixels = pixel_owners(limbs, skeleton_points(graph), silhouette, filled);
    const std::vector<double> contact = contact_shares(limbs, pixels, silhouette);
    for (std::size_t l = 0; l < contact.size(); ++l) limbs.limbs[l].contact = contact[l];
    const Point2d head = centre_of(filled, silhouette, Label::head, limbs.root);
    const Skeleton skeleton =
        make_bones(limbs, reference, mirrored, std::clamp(options.limb_segments, 1, 4), head);
    require_bones(skeleton.bones.size());
    rig.bones = skeleton.bones;
    const double cell = cell_of(rig.mesh);
    std::vector<Owner> owners = vertex_owners(rig.mesh, pixels);
    if (options.mesh.cut_touching_parts) cut_touching_parts(rig.mesh, owners, pixels, limbs, cell);
    rig.weights = smooth_weights(rig.mesh, owners, limbs, skeleton, cell);
}

} // namespace

Mesh make_mesh(const Mask& silhouette, const MeshOptions& options) {
    return options.method == MeshMethod::voronoi_regions ? voronoi_mesh(silhouette, options.margin)
                                                         : marching_squares(silhouette, options);
}

Rig rig_with_mapping(const SkeletonGraph& graph, const LabelMap& labels, const ReferenceSkeleton& reference,
                     bool mirrored, const Mapping& mapping, const RigOptions& options) {
    if (mapping.pairs.empty() && !options.thesis_weights) require_bones(0);
    Rig rig;
    rig.width = labels.width();
    rig.height = labels.height();
    rig.mapping = mapping;
    MeshOptions mesh = options.mesh;
    if (mesh.margin < 0) mesh.margin = ink_margin(rig.width, rig.height);
    const Mask silhouette = foreground(labels);
    rig.mesh = make_mesh(silhouette, mesh);
    if (rig.mesh.faces.empty()) throw CharacterRejected("rig", "the silhouette is empty");
    const LabelMap filled = nearest_labels(labels);
    if (options.thesis_weights)
        rig_as_in_thesis(rig, graph, labels, filled, reference, mirrored, options.weight_ends);
    else
        rig_smoothly(rig, graph, labels, filled, reference, mirrored, options);
    rig.texture = texture_coordinates(rig.mesh, rig.width, rig.height);
    rig.depth = part_depths(rig.bones, rig.weights);
    return rig;
}

Rig rig(const SkeletonGraph& graph, const LabelMap& labels, const Identification& identification,
        const std::vector<ReferenceSkeleton>& references, const RigOptions& options) {
    const auto reference =
        std::find_if(references.begin(), references.end(),
                     [&](const ReferenceSkeleton& r) { return r.name == identification.reference; });
    if (reference == references.end())
        throw Error(ErrorKind::input,
                    "identification: no reference skeleton named '" + identification.reference + "'");
    const auto match =
        std::find_if(identification.candidates.begin(), identification.candidates.end(),
                     [&](const Candidate& c) { return c.reference == identification.reference; });
    const Candidate candidate = match == identification.candidates.end() ? Candidate{} : *match;
    const Mapping mapping = map_end_effectors(graph, labels, *reference, candidate, options.mapping);
    return rig_with_mapping(graph, labels, *reference, candidate.mirrored, mapping, options);
}

} // namespace pantin
