// SPDX-License-Identifier: MIT
// End-effector mapping (thesis 4.6, Algorithms 4.2 and 4.3, Eq. 4.10–4.14).
//
// X. Bai, L. J. Latecki: Path Similarity Skeleton Graph Matching, 2008: the cost of matching two
// end-effectors is the optimal subsequence bijection of their paths to all other end-effectors; the Hungarian
// method assigns. The label-aware form (ERRATA 19) is ours; rigging.hpp says what it adds.
#include <algorithm>

#include "core/math.hpp"
#include "pantin/image.hpp"
#include "rigging/label_aware.hpp"
#include "rigging/path_distance.hpp"
#include "rigging/prominence.hpp"
#include "rigging/reference_shape.hpp"

namespace pantin {
namespace {

std::vector<int> end_effectors(const SkeletonGraph& graph) {
    std::vector<int> ends;
    for (int i = 0; i < std::ssize(graph.vertices); ++i)
        if (graph.vertices[i].end) ends.push_back(i);
    return ends;
}

// Algorithm 4.2 and 4.3: by angle around the centroid of the ends, then by distance, then by index; with y
// pointing down ascending angles run clockwise (ERRATA 16).
std::vector<int> clockwise(const SkeletonGraph& graph, std::vector<int> ends) {
    Point2d centre;
    for (const int e : ends) centre = centre + position_of(graph.vertices[e]);
    centre = (1.0 / static_cast<double>(std::max<std::size_t>(1, ends.size()))) * centre;
    struct Key {
        double angle, distance;
        int end;
    };
    std::vector<Key> keys;
    for (const int e : ends) {
        const Point2d d = position_of(graph.vertices[e]) - centre;
        keys.push_back({math::atan2(d.y, d.x), length(d), e});
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
        if (a.angle != b.angle) return a.angle < b.angle;
        return a.distance != b.distance ? a.distance < b.distance : a.end < b.end;
    });
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = keys[k].end;
    return ends;
}

// paths[i][k]: from end i to the k-th of the others, cyclically from the one after i.
std::vector<std::vector<PathSamples>> all_paths(const Figure& figure, const std::vector<int>& ends,
                                                const MappingOptions& options) {
    std::vector<std::vector<PathSamples>> paths(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t k = 1; k < ends.size(); ++k) {
            const int other = ends[(i + k) % ends.size()];
            paths[i].push_back(sample_path(figure, shortest_path(figure.graph, ends[i], other),
                                           options.samples, options.length_in_pixels));
        }
    return paths;
}

EndComparison compare(const std::vector<PathSamples>& from_u, const std::vector<PathSamples>& from_v,
                      const MappingOptions& options) {
    EndComparison result;
    for (const PathSamples& p : from_u) {
        std::vector<double>& row = result.distances.emplace_back();
        for (const PathSamples& q : from_v) row.push_back(path_distance(p, q, options.alpha));
    }
    result.osb = optimal_subsequence_bijection(result.distances, options.osb);
    return result;
}

// c(G_A, G_B) of the thesis, and all that leads to it.
void find_similarity(Mapping& mapping, const Figure& a, const Figure& b, const MappingOptions& options) {
    mapping.paths = all_paths(a, mapping.ends, options);
    mapping.reference_paths = all_paths(b, mapping.reference_ends, options);
    for (const auto& from_u : mapping.paths) {
        std::vector<EndComparison>& row = mapping.comparisons.emplace_back();
        std::vector<double>& costs = mapping.costs.emplace_back();
        for (const auto& from_v : mapping.reference_paths) {
            row.push_back(compare(from_u, from_v, options));
            costs.push_back(row.back().osb.cost);
        }
    }
}

LabelledEnds labelled(const SkeletonGraph& graph, const std::vector<int>& ends, const Frame& trunk) {
    LabelledEnds labelled{ends, {}, places_of(graph, ends, trunk)};
    for (const int e : ends) labelled.labels.push_back(graph.vertices[e].label);
    return labelled;
}

void list_pairs(Mapping& mapping, const std::vector<int>& partner) {
    for (std::size_t i = 0; i < mapping.ends.size(); ++i) {
        if (partner[i] >= 0)
            mapping.pairs.push_back(
                {mapping.ends[i], mapping.reference_ends[partner[i]], mapping.costs[i][partner[i]]});
        else
            mapping.unmatched_ends.push_back(mapping.ends[i]);
    }
    std::sort(mapping.pairs.begin(), mapping.pairs.end(),
              [](const EndPair& a, const EndPair& b) { return a.end < b.end; });
    std::sort(mapping.unmatched_ends.begin(), mapping.unmatched_ends.end());
}

} // namespace

Mapping map_end_effectors(const SkeletonGraph& graph, const LabelMap& labels,
                          const ReferenceSkeleton& reference, const Candidate& match,
                          const MappingOptions& options) {
    const Figure character = make_figure(graph, foreground(labels));
    const Figure model = draw_reference(reference, match.mirrored);
    Mapping mapping;
    mapping.ends = clockwise(graph, end_effectors(graph));
    mapping.reference_ends = clockwise(model.graph, end_effectors(model.graph));
    // Eq. 4.9 to 4.14: the costs of the thesis, and its assignment.
    find_similarity(mapping, character, model, options);
    if (!options.label_aware) {
        list_pairs(mapping, hungarian(mapping.costs));
        return mapping;
    }
    // ERRATA 19: the same with labels, places and what identification matched.
    const LabelledEnds drawn = labelled(graph, mapping.ends, trunk_of(labels));
    const LabelledEnds modelled =
        labelled(model.graph, mapping.reference_ends, trunk_of(model.graph, reference));
    mapping.costs = label_aware_costs(mapping.costs, drawn, modelled,
                                      prominence_of(graph, mapping.ends, modelled.labels), match, options);
    std::vector<int> partner = hungarian(mapping.costs);
    for (std::size_t i = 0; i < partner.size(); ++i)
        if (partner[i] >= 0 && mapping.costs[i][partner[i]] >= options.unmatched_cost) partner[i] = -1;
    for (const Label label : part_labels)
        if (row_of(label).sided) uncross(label, drawn, modelled, partner);
    list_pairs(mapping, partner);
    return mapping;
}

} // namespace pantin
