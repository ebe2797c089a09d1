// SPDX-License-Identifier: MIT
// Algorithm 4.4 of the thesis (ERRATA 20): in come the mesh, the labels and the mapped end-effectors; a flood
// from each gives the vertices that it reaches one weight σ for the end's bone, 1 − σ for the body.
#include "rigging/thesis_weights.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/extent.hpp"
#include "image/nearest_pixel.hpp"
#include "rigging/mesh_topology.hpp"
#include "rigging/reference_shape.hpp"
#include "rigging/skin_weights.hpp"

namespace pantin {
namespace {

// The first among equals; −1 in an empty mesh.
int nearest_vertex(const Mesh& mesh, Point2d p) {
    int nearest = -1;
    for (int v = 0; v < std::ssize(mesh.vertices); ++v)
        if (nearest < 0 || distance(mesh.vertices[v], p) < distance(mesh.vertices[nearest], p)) nearest = v;
    return nearest;
}

// Length of the first edge at the vertex, over the figure's diagonal.
template <class Edges> double relative_bone(const std::vector<Point2d>& points, const Edges& edges, int end) {
    const double size = diagonal_of(points);
    if (size == 0) return 0;
    for (const auto& [u, v] : edges)
        if (u == end || v == end) return distance(points[u], points[v]) / size;
    return 0;
}

} // namespace

std::vector<FloodResult> flood_weights(const Mesh& mesh, const LabelMap& labels,
                                       const std::vector<FloodInput>& ends) {
    std::vector<int> label; // per vertex, of the pixel below it
    for (const Point2d& p : mesh.vertices) label.push_back(at_nearest(labels, p));
    const auto neighbours = neighbours_of(mesh);
    std::vector<FloodResult> results(ends.size());
    for (std::size_t e = 0; e < ends.size(); ++e) {
        results[e].seed = nearest_vertex(mesh, ends[e].end);
        if (results[e].seed < 0) continue;
        const int wanted = label[results[e].seed];
        // C_3: no end-effector of the same label is nearer.
        const auto is_nearest = [&](int w) {
            for (const FloodInput& other : ends)
                if (static_cast<int>(other.label) == wanted &&
                    distance(mesh.vertices[w], other.end) < distance(mesh.vertices[w], ends[e].end))
                    return false;
            return true;
        };
        std::vector<char> visited(mesh.vertices.size(), 0);
        std::vector<int>& queue = results[e].reached;
        queue = {results[e].seed};
        visited[results[e].seed] = 1;
        for (std::size_t head = 0; head < queue.size(); ++head)
            for (int w : neighbours[queue[head]]) {
                if (visited[w] || label[w] != wanted) continue; // C_1, C_2
                visited[w] = 1;
                if (is_nearest(w)) queue.push_back(w);
            }
        std::sort(queue.begin(), queue.end());
    }
    return results;
}

double bone_ratio(const SkeletonGraph& graph, int end, const ReferenceSkeleton& reference,
                  int reference_end) {
    std::vector<Point2d> points, nodes;
    for (const SkeletonVertex& v : graph.vertices) points.push_back(position_of(v));
    for (const ReferenceNode& n : reference.nodes)
        nodes.push_back({std::rint((reference_span + 1) * n.x), std::rint((reference_span + 1) * n.y)});
    std::vector<std::pair<int, int>> edges;
    for (const SkeletonEdge& edge : graph.edges) edges.emplace_back(edge.u, edge.v);
    const double a = relative_bone(points, edges, end),
                 b = relative_bone(nodes, reference.edges, reference_end);
    return a > 0 && b > 0 ? std::min(a, b) / std::max(a, b) : 0;
}

std::vector<VertexWeights> thesis_weights(const Mesh& mesh, const LabelMap& labels,
                                          const SkeletonGraph& graph, const ReferenceSkeleton& reference,
                                          const Mapping& mapping, WeightEnds which) {
    std::vector<FloodInput> ends; // those with a partner first
    for (const EndPair& pair : mapping.pairs) {
        const SkeletonVertex& v = graph.vertices[pair.end];
        ends.push_back({position_of(v), v.label});
    }
    if (which == WeightEnds::all)
        for (int i = 0; i < std::ssize(graph.vertices); ++i) {
            const SkeletonVertex& v = graph.vertices[i];
            const bool mapped = std::any_of(mapping.pairs.begin(), mapping.pairs.end(),
                                            [&](const EndPair& pair) { return pair.end == i; });
            if (v.end && !mapped) ends.push_back({position_of(v), v.label});
        }
    const std::vector<FloodResult> floods = flood_weights(mesh, labels, ends);
    std::vector<VertexWeights> weights(mesh.vertices.size());
    for (VertexWeights& w : weights) w.weights[0] = 1; // the body
    for (std::size_t e = 0; e < mapping.pairs.size(); ++e) {
        const EndPair& pair = mapping.pairs[e];
        const double sigma = bone_ratio(graph, pair.end, reference, pair.reference_end);
        std::vector<double> per_bone(mapping.pairs.size() + 1, 0.0);
        per_bone[0] = 1 - sigma;
        per_bone[e + 1] = sigma;
        for (int v : floods[e].reached) weights[v] = quantised(per_bone);
    }
    return weights;
}

} // namespace pantin
