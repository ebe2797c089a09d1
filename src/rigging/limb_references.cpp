// SPDX-License-Identifier: MIT
// In come limbs, some of them paired by the mapping (thesis 4.6); out goes a reference end for each for which
// there is one. Our own: the thesis animates no unmatched end-effector.
#include "rigging/limb_references.hpp"

#include <algorithm>

namespace pantin {
namespace {

// Position inside the box of the skeleton's vertices, for comparison with the reference's nodes.
Point2d normalised(Point2d p, const SkeletonGraph& graph) {
    double left = p.x, right = p.x, top = p.y, bottom = p.y;
    for (const SkeletonVertex& v : graph.vertices) {
        left = std::min(left, v.x), right = std::max(right, v.x);
        top = std::min(top, v.y), bottom = std::max(bottom, v.y);
    }
    return {(p.x - left) / std::max(1.0, right - left), (p.y - top) / std::max(1.0, bottom - top)};
}

// Ends of the reference with the label that drive no limb yet.
std::vector<int> free_reference_ends(const std::vector<Limb>& limbs, const ReferenceSkeleton& reference,
                                     Label label) {
    std::vector<int> degree(reference.nodes.size(), 0), ends;
    for (const auto& [u, v] : reference.edges) ++degree[u], ++degree[v];
    for (std::size_t n = 0; n < reference.nodes.size(); ++n) {
        if (degree[n] > 1 || reference.nodes[n].label != label) continue;
        const bool taken = std::any_of(limbs.begin(), limbs.end(), [&](const Limb& limb) {
            return limb.matched && limb.reference_end == static_cast<int>(n);
        });
        if (!taken) ends.push_back(static_cast<int>(n));
    }
    return ends;
}

void follow_nearest(Limb& limb, const std::vector<Limb>& limbs) {
    const Limb* nearest = nullptr;
    for (const Limb& other : limbs) {
        if (!other.matched || other.label != limb.label || &other == &limb) continue;
        if (!nearest ||
            distance(other.path.back(), limb.path.back()) < distance(nearest->path.back(), limb.path.back()))
            nearest = &other;
    }
    if (!nearest) return; // what the mapping said, if anything
    limb.reference_end = nearest->reference_end;
    limb.phase_shift = row_of(limb.label).alternates ? 0.5 : 0; // legs do, wings beat together
}

} // namespace

void assign_reference_ends(std::vector<Limb>& limbs, const SkeletonGraph& graph,
                           const ReferenceSkeleton& reference) {
    for (Limb& limb : limbs) {
        if (limb.matched) continue;
        const Point2d at = normalised(limb.path.back(), graph);
        int best = -1;
        double best_distance = 0;
        for (const int node : free_reference_ends(limbs, reference, limb.label)) {
            const double d = distance(at, {reference.nodes[node].x, reference.nodes[node].y});
            if (best < 0 || d < best_distance) best = node, best_distance = d;
        }
        if (best >= 0)
            limb.reference_end = best, limb.matched = true;
        else
            follow_nearest(limb, limbs);
    }
}

} // namespace pantin
