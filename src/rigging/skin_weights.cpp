// SPDX-License-Identifier: MIT
// In come the mesh, the owners of its vertices and the bones; out go up to four weights per vertex. Ours:
// blended over each joint along the limb, then diffused over the mesh. The thesis's: a flood from every
// end-effector with one constant weight (Algorithm 4.4, ERRATA 20).
#include "rigging/skin_weights.hpp"

#include <algorithm>
#include <cmath>

#include "core/smoothstep.hpp"
#include "geometry/extent.hpp"
#include "rigging/mesh_topology.hpp"
#include "rigging/nearest_pixel.hpp"
#include "rigging/reference_shape.hpp"

namespace pantin {
namespace {

constexpr double short_edge = 0.4, shortest_edge = 0.05; // cells

// Weights of a limb's bones at a position: one bone each, blended over half the limb's width on both sides of
// a joint.
void add_limb_weights(std::vector<double>& weights, const LimbBones& bones, double position, double blend) {
    double rest = 1;
    for (int i = bones.count() - 1; i > 0; --i) {
        const double beyond = smoothstep((position - bones.joints[i]) / (2 * blend) + 0.5);
        weights[bones.first + i] += rest * beyond;
        rest -= rest * beyond;
    }
    weights[bones.first] += rest;
}

void add_trunk_weights(std::vector<double>& weights, const std::vector<SpineBone>& spine, Point2d p) {
    double rest = 1;
    for (const SpineBone& s : spine) {
        const double beyond = smoothstep(dot(p - s.pivot, s.direction) / (2 * s.blend) + 0.5);
        weights[s.bone] += rest * beyond;
        rest -= rest * beyond;
    }
    weights[0] += rest;
}

struct Neighbour {
    int vertex = 0;
    double share = 0; // of what flows to the vertex; they add up to one half
};

// Flow along an edge is larger the shorter it is, so that the two ends of a short edge move together.
std::vector<std::vector<Neighbour>> flows_of(const Mesh& mesh, double cell) {
    const auto neighbours = neighbours_of(mesh);
    std::vector<std::vector<Neighbour>> flows(neighbours.size());
    for (std::size_t v = 0; v < neighbours.size(); ++v) {
        double sum = 0;
        for (const int n : neighbours[v]) {
            const double length = distance(mesh.vertices[v], mesh.vertices[n]) / cell;
            flows[v].push_back({n, 1 + short_edge / std::max(length, shortest_edge)});
            sum += flows[v].back().share;
        }
        for (Neighbour& n : flows[v]) n.share *= 0.5 / sum;
    }
    return flows;
}

// One step of diffusion: half of a vertex's weights is replaced by the mean of its neighbours'.
void diffuse(std::vector<std::vector<double>>& weights, const std::vector<std::vector<Neighbour>>& flows) {
    const std::vector<std::vector<double>> before = weights;
    for (std::size_t v = 0; v < weights.size(); ++v) {
        if (flows[v].empty()) continue;
        for (std::size_t b = 0; b < weights[v].size(); ++b) {
            double sum = 0.5 * before[v][b];
            for (const Neighbour& n : flows[v]) sum += n.share * before[n.vertex][b];
            weights[v][b] = sum;
        }
    }
}

// Diffusion for n steps blurs over about √n cells: half the mean limb's width, within limits.
int diffusion_steps(const Limbs& limbs, double cell) {
    double width = 0;
    for (const Limb& limb : limbs.limbs) width += limb.width;
    if (!limbs.limbs.empty()) width /= static_cast<double>(limbs.limbs.size());
    const double cells = 0.5 * width / cell;
    return std::clamp(static_cast<int>(std::rint(2 * cells * cells)), 6, 40);
}

} // namespace

VertexWeights quantised(const std::vector<double>& per_bone) {
    constexpr int one = 1 << 16;
    std::vector<int> order;
    for (std::size_t b = 0; b < per_bone.size(); ++b)
        if (per_bone[b] > 0) order.push_back(static_cast<int>(b));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return per_bone[a] > per_bone[b]; });
    if (order.size() > 4) order.resize(4);
    double total = 0;
    for (int b : order) total += per_bone[b];
    VertexWeights result;
    if (order.empty()) {
        result.weights[0] = 1;
        return result;
    }
    std::array<int, 4> units{};
    std::array<double, 4> remainder{};
    int given = 0;
    const int n = static_cast<int>(order.size());
    for (int k = 0; k < n; ++k) {
        const double exact = per_bone[order[k]] / total * one;
        units[k] = static_cast<int>(std::floor(exact));
        remainder[k] = exact - units[k];
        given += units[k];
    }
    for (; given < one; ++given) {
        const int k =
            static_cast<int>(std::max_element(remainder.begin(), remainder.begin() + n) - remainder.begin());
        ++units[k];
        remainder[k] -= 1;
    }
    for (int k = 0; k < n && units[k] > 0; ++k) {
        result.bones[k] = order[k];
        result.weights[k] = static_cast<double>(units[k]) / one;
    }
    return result;
}

std::vector<VertexWeights> smooth_weights(const Mesh& mesh, const std::vector<Owner>& owners,
                                          const Limbs& limbs, const Skeleton& skeleton, double cell) {
    std::vector<std::vector<double>> weights(mesh.vertices.size(),
                                             std::vector<double>(skeleton.bones.size(), 0.0));
    for (std::size_t v = 0; v < weights.size(); ++v) {
        if (owners[v].limb < 0) {
            add_trunk_weights(weights[v], skeleton.spine, mesh.vertices[v]);
            continue;
        }
        const Limb& limb = limbs.limbs[owners[v].limb];
        const double blend = std::max(2 * cell, 0.6 * limb.width);
        add_limb_weights(weights[v], skeleton.limbs[owners[v].limb], owners[v].position, blend);
    }
    const auto flows = flows_of(mesh, cell);
    for (int i = diffusion_steps(limbs, cell); i > 0; --i) diffuse(weights, flows);
    std::vector<VertexWeights> result;
    for (const std::vector<double>& w : weights) result.push_back(quantised(w));
    return result;
}

std::vector<FloodResult> flood_weights(const Mesh& mesh, const LabelMap& labels,
                                       const std::vector<FloodInput>& ends) {
    std::vector<FloodResult> results(ends.size());
    std::vector<int> label(mesh.vertices.size());
    for (std::size_t v = 0; v < label.size(); ++v) label[v] = at_nearest(labels, mesh.vertices[v]);
    for (std::size_t e = 0; e < ends.size(); ++e)
        for (std::size_t v = 0; v < label.size(); ++v)
            if (results[e].seed < 0 || distance(mesh.vertices[v], ends[e].end) <
                                           distance(mesh.vertices[results[e].seed], ends[e].end))
                results[e].seed = static_cast<int>(v);
    const auto neighbours = neighbours_of(mesh);
    for (std::size_t e = 0; e < ends.size(); ++e) {
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

namespace {

// Length of the first edge at the vertex, over the figure's diagonal.
template <class Edges> double relative_bone(const std::vector<Point2d>& points, const Edges& edges, int end) {
    const double size = diagonal_of(points);
    if (size == 0) return 0;
    for (const auto& [u, v] : edges)
        if (u == end || v == end) return distance(points[u], points[v]) / size;
    return 0;
}

} // namespace

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
                                          const Mapping& mapping) {
    std::vector<FloodInput> ends;
    for (const EndPair& pair : mapping.pairs) {
        const SkeletonVertex& v = graph.vertices[pair.end];
        ends.push_back({position_of(v), v.label});
    }
    const std::vector<FloodResult> floods = flood_weights(mesh, labels, ends);
    std::vector<VertexWeights> weights(mesh.vertices.size());
    for (VertexWeights& w : weights) w.weights[0] = 1; // the body
    for (std::size_t e = 0; e < floods.size(); ++e) {
        const EndPair& pair = mapping.pairs[e];
        const double sigma = bone_ratio(graph, pair.end, reference, pair.reference_end);
        std::vector<double> per_bone(ends.size() + 1, 0.0);
        per_bone[0] = 1 - sigma;
        per_bone[e + 1] = sigma;
        for (int v : floods[e].reached) weights[v] = quantised(per_bone);
    }
    return weights;
}

} // namespace pantin
