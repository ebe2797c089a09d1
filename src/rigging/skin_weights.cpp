// SPDX-License-Identifier: MIT
// In come the mesh, the owners of its vertices and the bones; out go up to four weights per vertex, blended
// over each joint along the limb, then diffused over the mesh. Our own; thesis_weights.cpp has the thesis's.
#include "rigging/skin_weights.hpp"

#include <algorithm>
#include <cmath>

#include "core/smoothstep.hpp"
#include "rigging/mesh_topology.hpp"

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

} // namespace pantin
