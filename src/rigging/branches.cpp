// SPDX-License-Identifier: MIT
// In come the inward paths, the labels and the end-effector mapping; out goes, for every end, how far along
// its path its part reaches. Our own: thesis 4.6 ends a bone at the end's neighbour in the graph.
#include "rigging/branches.hpp"

#include <algorithm>

#include "image/nearest_pixel.hpp"
#include "skeletonization/graph_edit.hpp"

namespace pantin {
namespace {

// Runs of another label that are shorter do not end a branch: 1.5 % of the longer side, at least 3 pixels.
double label_noise(const LabelMap& labels) {
    return std::max(3.0, 0.015 * std::max(labels.width(), labels.height()));
}

// Outside of the silhouette as on the trunk: no branch goes on there.
PartRole role_at(Label label) { return label == Label::background ? PartRole::trunk : role_of(label); }

// Points from the end-effector until the label changes its role for longer than noise does.
int extent_by_label(const InwardPath& path, PartRole role, const LabelMap& labels) {
    const int n = static_cast<int>(path.points.size());
    int own = 0; // points up to and with the last one of the kind
    double foreign = 0;
    for (int i = 0; i < n; ++i) {
        if (role_at(static_cast<Label>(at_nearest(labels, path.points[i]))) == role) {
            own = i + 1;
            foreign = 0;
        } else {
            foreign += i > 0 ? distance(path.points[i - 1], path.points[i]) : 1;
            if (foreign >= label_noise(labels)) break;
        }
    }
    if (own < n) return own;
    return role == PartRole::head ? 0 : static_cast<int>(0.8 * n); // the root lies in the part itself
}

// Points from the end-effector to where the body begins: as far from the path's outermost junction as the
// body reaches around it, but at least half the way.
int extent_by_junction(const InwardPath& path, const std::vector<int>& degree, const Grid<float>& depth) {
    const int n = static_cast<int>(path.points.size());
    int junction = n - 1;
    for (int i = n - 1; i > 0; --i)
        if (path.vertex[i] >= 0 && degree[path.vertex[i]] >= 3) junction = i;
    const double body_radius = at_nearest(depth, path.points[junction]);
    int extent = junction + 1;
    while (extent > 0 && distance(path.points[extent - 1], path.points[junction]) < body_radius) --extent;
    return std::max(extent, (junction + 1) / 2);
}

} // namespace

double arc_length(const InwardPath& path, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; ++i) sum += distance(path.points[i], path.points[i + 1]);
    return sum;
}

std::vector<Branch> find_branches(const InwardPaths& paths, const SkeletonGraph& graph,
                                  const LabelMap& labels, const Grid<float>& depth,
                                  const ReferenceSkeleton& reference, const Mapping& mapping) {
    const std::vector<int> degree = vertex_degrees(graph);
    std::vector<Branch> branches;
    for (const InwardPath& path : paths.paths) {
        Branch branch{&path, 0, graph.vertices[path.end].label, -1, false, 0};
        for (const EndPair& pair : mapping.pairs)
            if (pair.end == path.end) branch.reference_end = pair.reference_end;
        const bool mapped = branch.reference_end >= 0;
        const Label wanted = mapped ? reference.nodes[branch.reference_end].label : Label::background;
        // The part that the segmentation saw.
        if (role_at(branch.label) != PartRole::trunk)
            branch.extent = extent_by_label(path, role_at(branch.label), labels);
        // Where it saw none and the mapping did, the part is the branch up to the body.
        if (branch.extent < 3 && mapped && role_at(wanted) != PartRole::trunk) {
            branch.extent = extent_by_junction(path, degree, depth);
            branch.label = wanted;
        }
        branch.matched = mapped && wanted == branch.label;
        branch.length = arc_length(path, 0, std::max(0, branch.extent - 1));
        if (branch.extent >= 3) branches.push_back(branch);
    }
    std::stable_sort(branches.begin(), branches.end(), [](const Branch& a, const Branch& b) {
        return a.matched != b.matched ? a.matched : a.length > b.length;
    });
    return branches;
}

} // namespace pantin
