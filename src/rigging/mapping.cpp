// SPDX-License-Identifier: MIT
// End-effector mapping (thesis 4.6, Algorithms 4.2 and 4.3, Eq. 4.10–4.14).
//
// X. Bai, L. J. Latecki: Path Similarity Skeleton Graph Matching, 2008: the cost of matching two
// end-effectors is the optimal subsequence bijection of their paths to all other end-effectors; the Hungarian
// method assigns. The label-aware form (ERRATA 19) is ours; rigging.hpp says what it adds.
#include <algorithm>

#include "core/math.hpp"
#include "identification/traits.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "rigging/skeleton_paths.hpp"

namespace pantin {
namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr double prong_share = 0.3;    // of the rest of the limb
constexpr double frame_reach = 0.75;   // a place farther than this many boxes outside is told no farther
constexpr double clearly_below = 0.15; // of the box of the vertices
constexpr double least_trunk = 0.04;   // of the silhouette
constexpr double pi = 3.14159265358979323846;

std::vector<int> end_effectors(const SkeletonGraph& graph) {
    std::vector<int> ends;
    for (int i = 0; i < std::ssize(graph.vertices); ++i)
        if (graph.vertices[i].end) ends.push_back(i);
    return ends;
}

Point2d position(const SkeletonVertex& v) { return {v.x, v.y}; }

// Algorithm 4.2 and 4.3: by angle around the centroid of the ends, then by distance, then by index; with y
// pointing down ascending angles run clockwise (ERRATA 16).
std::vector<int> clockwise(const SkeletonGraph& graph, std::vector<int> ends) {
    Point2d centre;
    for (const int e : ends) centre = centre + position(graph.vertices[e]);
    centre = (1.0 / static_cast<double>(std::max<std::size_t>(1, ends.size()))) * centre;
    struct Key {
        double angle, distance;
        int end;
    };
    std::vector<Key> keys;
    for (const int e : ends) {
        const Point2d d = position(graph.vertices[e]) - centre;
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

// A box to say in it where things are; an empty one says nothing.
struct Frame {
    Point2d low, high;
    bool empty() const { return high.x <= low.x || high.y <= low.y; }
    Point2d place(Point2d p) const {
        const auto share = [](double v, double a, double b) {
            return std::clamp((v - a) / (b - a), -frame_reach, 1 + frame_reach);
        };
        return {share(p.x, low.x, high.x), share(p.y, low.y, high.y)};
    }
};

// The box of the body in the drawing, and of the body's nodes in the reference as it is drawn.
Frame trunk_of(const LabelMap& labels) {
    const PartRegion body = part_region(labels, {Label::body});
    const double area = static_cast<double>(labels.size() - std::count(labels.begin(), labels.end(), 0));
    if (body.empty() || body.area < least_trunk * area) return {};
    return {to_double({body.x0, body.y0}), to_double({body.x1, body.y1})};
}
Frame trunk_of(const SkeletonGraph& drawn, const ReferenceSkeleton& reference) {
    Frame frame;
    bool first = true;
    for (std::size_t i = 0; i < reference.nodes.size(); ++i) {
        const ReferenceNode& node = reference.nodes[i];
        if (node.label != Label::body) continue;
        const Point2d c = position(drawn.vertices[i]), r = reference_span * node.r * Point2d{1, 1};
        const Point2d low = c - r, high = c + r;
        frame.low = first ? low : Point2d{std::min(low.x, frame.low.x), std::min(low.y, frame.low.y)};
        frame.high = first ? high : Point2d{std::max(high.x, frame.high.x), std::max(high.y, frame.high.y)};
        first = false;
    }
    return frame;
}

// The ends of one figure in the bounding box of all its vertices, and in that of its trunk.
struct Places {
    std::vector<Point2d> ends;
    std::vector<Point2d> beside_trunk; // the same in the trunk's box; empty without trunk
    Point2d middle;                    // of the body, in the box of the vertices
    std::vector<double> bearings; // clockwise from straight up around the middle of the body, in [0, 2π)
};

// Mean place of the junctions, those of the body where there are any; the middle of the box without
// junctions.
Point2d middle_of(const SkeletonGraph& graph, const LabelledGraph& box) {
    for (const bool body_only : {true, false}) {
        Point2d sum;
        int count = 0;
        for (std::size_t i = 0; i < box.positions.size(); ++i) {
            if (graph.vertices[i].end || (body_only && box.labels[i] != Label::body)) continue;
            sum = sum + box.positions[i];
            ++count;
        }
        if (count > 0) return (1.0 / count) * sum;
    }
    return {0.5, 0.5};
}

Places places_of(const SkeletonGraph& graph, const std::vector<int>& ends, const Frame& trunk) {
    const LabelledGraph box = normalised(to_labelled_graph(graph));
    const Point2d middle = middle_of(graph, box);
    Places places;
    places.middle = middle;
    for (const int e : ends) {
        const Point2d d = box.positions[e] - middle;
        const double angle = math::atan2(d.x, -d.y);
        places.ends.push_back(box.positions[e]);
        places.bearings.push_back(angle < 0 ? angle + 2 * pi : angle);
        if (!trunk.empty()) places.beside_trunk.push_back(trunk.place(position(graph.vertices[e])));
    }
    return places;
}

// Pairs of different labels that make sense: segmentation reads tails and wings as limbs; the wings of a
// figure that moves without wings are its arms; a head that was not found ends in the body.
bool may_stand_for(Label drawn, Label reference, bool reference_has_wings) {
    if (drawn == Label::limb) return reference == Label::tail || reference == Label::wing;
    if (drawn == Label::wing) return reference == Label::limb && !reference_has_wings;
    return drawn == Label::body && reference == Label::head;
}

// One end-effector problem: both figures' ends in clockwise order.
struct Problem {
    std::vector<Label> labels_a, labels_b;
    Places places_a, places_b;
    std::vector<double> prominence; // of the drawing's ends, see below; 0: a prong
};

// Length of the part that an end finishes: along the skeleton to the nearest vertex of another label, to the
// farthest vertex where there is none.
double part_length(const SkeletonGraph& graph, int end) {
    std::vector<double> reached(graph.vertices.size(), -1);
    std::vector<char> done(graph.vertices.size());
    reached[end] = 0;
    double farthest = 0;
    for (;;) {
        int u = -1;
        for (int i = 0; i < std::ssize(reached); ++i)
            if (!done[i] && reached[i] >= 0 && (u < 0 || reached[i] < reached[u])) u = i;
        if (u < 0) return farthest;
        if (graph.vertices[u].label != graph.vertices[end].label) return reached[u];
        done[u] = 1;
        farthest = reached[u];
        for (const SkeletonEdge& edge : graph.edges) {
            if (edge.u != u && edge.v != u) continue;
            const int v = edge.u == u ? edge.v : edge.u;
            const double length = reached[u] + edge.length;
            if (!done[v] && (reached[v] < 0 || length < reached[v])) reached[v] = length;
        }
    }
}

// The only edge of an end.
const SkeletonEdge* edge_of(const SkeletonGraph& graph, int end) {
    for (const SkeletonEdge& edge : graph.edges)
        if (edge.u == end || edge.v == end) return &edge;
    return nullptr;
}

// A finger or a feather: the limb forks late, and another end of the same fork is longer (or comes first).
bool is_prong(const SkeletonGraph& graph, int end, double length) {
    const SkeletonEdge* stem = edge_of(graph, end);
    if (!stem) return false;
    const int fork = stem->u == end ? stem->v : stem->u;
    if (graph.vertices[fork].label != graph.vertices[end].label) return false;
    if (stem->length > prong_share * (length - stem->length)) return false;
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

// Length of the end's part, as a share of the longest part of that label. 0 for a prong, shortest first, as
// long as the drawing has more ends of the label than the reference: legs that grow together are not fingers.
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
            if (spare <= 0 || !is_prong(graph, ends[i], lengths[i])) continue;
            prominence[i] = 0;
            --spare;
        }
    }
    return prominence;
}

Problem make_problem(const SkeletonGraph& a, const std::vector<int>& ends_a, const Frame& trunk_a,
                     const SkeletonGraph& b, const std::vector<int>& ends_b, const Frame& trunk_b) {
    Problem problem;
    for (const int e : ends_a) problem.labels_a.push_back(a.vertices[e].label);
    for (const int e : ends_b) problem.labels_b.push_back(b.vertices[e].label);
    problem.places_a = places_of(a, ends_a, trunk_a);
    problem.places_b = places_of(b, ends_b, trunk_b);
    problem.prominence = prominence_of(a, ends_a, problem.labels_b);
    return problem;
}

double squared_distance(Point2d a, Point2d b) { return dot(a - b, a - b); }

// Squared distance of two ends: by their places in the figures' boxes, and beside the trunk, which a long
// neck or a spread arm does not distort.
double place_cost(const Problem& problem, std::size_t i, std::size_t j, const MappingOptions& options) {
    const Places &a = problem.places_a, &b = problem.places_b;
    const double in_box = options.position_weight * squared_distance(a.ends[i], b.ends[j]);
    if (a.beside_trunk.empty() || b.beside_trunk.empty()) return in_box;
    return in_box + options.trunk_weight * squared_distance(a.beside_trunk[i], b.beside_trunk[j]);
}

// The similarity costs with the evidence of labels, places and identification.
Matrix aware_costs(const Matrix& similarity, const Problem& problem, const std::vector<int>& ends_a,
                   const std::vector<int>& ends_b, const Candidate& match, const MappingOptions& options) {
    double mean = 0;
    for (const auto& row : similarity)
        for (const double c : row) mean += c / static_cast<double>(similarity.size() * row.size());
    const bool wings = std::count(problem.labels_b.begin(), problem.labels_b.end(), Label::wing) > 0;
    Matrix costs = similarity;
    for (std::size_t i = 0; i < costs.size(); ++i)
        for (std::size_t j = 0; j < costs[i].size(); ++j) {
            const double d2 = squared_distance(problem.places_a.ends[i], problem.places_b.ends[j]);
            const bool same = problem.labels_a[i] == problem.labels_b[j];
            const bool matched =
                std::count(match.pairs.begin(), match.pairs.end(), std::pair{ends_a[i], ends_b[j]}) > 0;
            double& cost = costs[i][j];
            cost = options.path_weight * (mean > 0 ? cost / mean : 0) + place_cost(problem, i, j, options) +
                   options.prominence_weight * (1 - problem.prominence[i]) -
                   (matched ? options.prior_weight : 0) + (same ? 0 : options.label_penalty);
            if (problem.prominence[i] == 0) cost = options.unmatched_cost;
            const bool reachable = d2 <= options.mixed_reach * options.mixed_reach;
            if (!same && !(reachable && may_stand_for(problem.labels_a[i], problem.labels_b[j], wings)))
                cost = options.unmatched_cost;
        }
    return costs;
}

std::vector<int> by_bearing(std::vector<int> items, const Places& places) {
    std::stable_sort(items.begin(), items.end(),
                     [&places](int a, int b) { return places.bearings[a] < places.bearings[b]; });
    return items;
}

// Legs that all stand below the body.
bool below(const Places& places, const std::vector<int>& items) {
    return std::all_of(items.begin(), items.end(),
                       [&](int i) { return places.ends[i].y > places.middle.y + clearly_below; });
}

std::vector<int> from_left_to_right(std::vector<int> items, const Places& places) {
    std::stable_sort(items.begin(), items.end(),
                     [&](int a, int b) { return places.ends[a].x < places.ends[b].x; });
    return items;
}

// Puts the pairs of one label into the same cyclic order on both sides, at the rotation with the smallest
// squared distances, or into the same order from left to right where all of them stand below the body: the
// legs of a figure then keep their order from front to hind.
void uncross(Label label, const Problem& problem, std::vector<int>& partner) {
    std::vector<int> rows, columns;
    for (int i = 0; i < std::ssize(partner); ++i)
        if (partner[i] >= 0 && problem.labels_a[i] == label && problem.labels_b[partner[i]] == label) {
            rows.push_back(i);
            columns.push_back(partner[i]);
        }
    const std::size_t n = rows.size();
    if (n < 2) return;
    if (below(problem.places_a, rows) && below(problem.places_b, columns)) {
        rows = from_left_to_right(std::move(rows), problem.places_a);
        columns = from_left_to_right(std::move(columns), problem.places_b);
        for (std::size_t k = 0; k < n; ++k) partner[rows[k]] = columns[k];
        return;
    }
    rows = by_bearing(std::move(rows), problem.places_a);
    columns = by_bearing(std::move(columns), problem.places_b);
    std::size_t best = 0;
    double best_sum = 0;
    for (std::size_t shift = 0; shift < n; ++shift) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum += squared_distance(problem.places_a.ends[rows[k]],
                                    problem.places_b.ends[columns[(k + shift) % n]]);
        if (shift == 0 || sum < best_sum) {
            best = shift;
            best_sum = sum;
        }
    }
    for (std::size_t k = 0; k < n; ++k) partner[rows[k]] = columns[(k + best) % n];
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
    find_similarity(mapping, character, model, options);
    if (!options.label_aware) {
        list_pairs(mapping, hungarian(mapping.costs));
        return mapping;
    }
    const Problem problem = make_problem(graph, mapping.ends, trunk_of(labels), model.graph,
                                         mapping.reference_ends, trunk_of(model.graph, reference));
    mapping.costs = aware_costs(mapping.costs, problem, mapping.ends, mapping.reference_ends, match, options);
    std::vector<int> partner = hungarian(mapping.costs);
    for (std::size_t i = 0; i < partner.size(); ++i)
        if (partner[i] >= 0 && mapping.costs[i][partner[i]] >= options.unmatched_cost) partner[i] = -1;
    for (const Label label : part_labels)
        if (row_of(label).sided) uncross(label, problem, partner);
    list_pairs(mapping, partner);
    return mapping;
}

} // namespace pantin
