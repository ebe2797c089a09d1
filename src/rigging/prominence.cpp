// SPDX-License-Identifier: MIT
// In come the skeleton graph and its ends; out goes a share for each, 0 for the tips of one part that forks.
// Our own: in the thesis (4.6) all ends count the same (ERRATA 19).
#include "rigging/prominence.hpp"

#include <algorithm>

#include "rigging/shortest_paths.hpp"

namespace pantin {
namespace {

constexpr double forked_tip_share = 0.3; // of the rest of the limb

// Length of the part that an end finishes: along the skeleton to the nearest vertex of another label, to the
// farthest vertex where there is none.
double part_length(const SkeletonGraph& graph, int end) {
    const ShortestPaths paths = shortest_paths(graph, end);
    for (const int v : paths.order)
        if (graph.vertices[v].label != graph.vertices[end].label) return paths.length[v];
    return paths.length[paths.order.back()];
}

// The only edge of an end.
const SkeletonEdge* edge_of(const SkeletonGraph& graph, int end) {
    for (const SkeletonEdge& edge : graph.edges)
        if (edge.u == end || edge.v == end) return &edge;
    return nullptr;
}

// A finger or a feather: the limb forks late, and another end of the same fork is longer (or comes first).
bool is_forked_tip(const SkeletonGraph& graph, int end, double length) {
    const SkeletonEdge* stem = edge_of(graph, end);
    if (!stem) return false;
    const int fork = stem->u == end ? stem->v : stem->u;
    if (graph.vertices[fork].label != graph.vertices[end].label) return false;
    if (stem->length > forked_tip_share * (length - stem->length)) return false;
    for (const SkeletonEdge& edge : graph.edges) {
        if (edge.u != fork && edge.v != fork) continue;
        const int other = edge.u == fork ? edge.v : edge.u;
        const bool sibling = other != end && graph.vertices[other].end &&
                             graph.vertices[other].label == graph.vertices[end].label;
        if (sibling && (edge.length > stem->length || (edge.length == stem->length && other < end)))
            return true;
    }
    return false;
}

} // namespace

std::vector<double> prominence_of(const SkeletonGraph& graph, const std::vector<int>& ends,
                                  const std::vector<Label>& reference_labels) {
    std::vector<double> lengths, prominence(ends.size(), 1);
    for (const int e : ends) lengths.push_back(part_length(graph, e));
    for (const Label label : part_labels) {
        std::vector<std::size_t> group;
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (graph.vertices[ends[i]].label == label) group.push_back(i);
        std::stable_sort(group.begin(), group.end(),
                         [&lengths](std::size_t i, std::size_t k) { return lengths[i] < lengths[k]; });
        long spare = std::ssize(group) - std::count(reference_labels.begin(), reference_labels.end(), label);
        for (const std::size_t i : group) {
            const double longest = lengths[group.back()];
            prominence[i] = longest > 0 ? lengths[i] / longest : 1;
            if (spare <= 0 || !is_forked_tip(graph, ends[i], lengths[i])) continue;
            prominence[i] = 0;
            --spare;
        }
    }
    return prominence;
}

} // namespace pantin
