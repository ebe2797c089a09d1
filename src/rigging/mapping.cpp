// End-effector mapping (thesis 4.6, Algorithms 4.2 and 4.3, Eq. 4.10–4.14).
//
// X. Bai, L. J. Latecki: Path Similarity Skeleton Graph Matching, 2008: the cost of matching two
// end-effectors is the optimal subsequence bijection of their paths to all other end-effectors; the Hungarian
// method assigns. The label-aware form (ERRATA 19) is ours; rigging.hpp says what it adds.
#include <algorithm>

#include "core/math.hpp"
#include "pantin/error.hpp"
#include "rigging/skeleton_paths.hpp"

namespace pantin {
namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr double pi = 3.14159265358979323846;
constexpr double forbidden = 1e6; // above every sum of allowed costs

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

// c(G_A, G_B) of the thesis.
Matrix similarity_costs(const Figure& a, const std::vector<int>& ends_a, const Figure& b,
                        const std::vector<int>& ends_b, const MappingOptions& options) {
    const auto paths_a = all_paths(a, ends_a, options), paths_b = all_paths(b, ends_b, options);
    Matrix costs;
    for (const auto& from_u : paths_a) {
        std::vector<double> row;
        for (const auto& from_v : paths_b) {
            Matrix distances; // Eq. 4.11
            for (const PathSamples& p : from_u) {
                distances.emplace_back();
                for (const PathSamples& q : from_v)
                    distances.back().push_back(path_distance(p, q, options.alpha));
            }
            row.push_back(optimal_subsequence_bijection(distances, options.osb).cost);
        }
        costs.push_back(std::move(row));
    }
    return costs;
}

// Where the ends are in the bounding box of all vertices of their figure.
std::vector<Point2d> box_positions(const SkeletonGraph& graph, const std::vector<int>& ends) {
    const LabelledGraph box = normalised(to_labelled_graph(graph));
    std::vector<Point2d> out;
    for (const int e : ends) out.push_back(box.positions[e]);
    return out;
}

// Labels that segmentation mixes up at the end of a thin part.
bool may_be_mixed_up(Label drawn, Label reference) {
    const auto thin = [](Label l) { return l == Label::limb || l == Label::tail || l == Label::wing; };
    return (thin(drawn) && thin(reference)) || (drawn == Label::body && reference == Label::head);
}

// One end-effector problem: both figures' ends in clockwise order.
struct Problem {
    std::vector<Label> labels_a, labels_b;
    std::vector<Point2d> places_a, places_b; // in their figure's box
};

Problem make_problem(const SkeletonGraph& a, const std::vector<int>& ends_a, const SkeletonGraph& b,
                     const std::vector<int>& ends_b) {
    Problem problem;
    for (const int e : ends_a) problem.labels_a.push_back(a.vertices[e].label);
    for (const int e : ends_b) problem.labels_b.push_back(b.vertices[e].label);
    problem.places_a = box_positions(a, ends_a);
    problem.places_b = box_positions(b, ends_b);
    return problem;
}

double squared_distance(Point2d a, Point2d b) { return dot(a - b, a - b); }

// The similarity costs with the evidence of labels, places and identification.
Matrix aware_costs(const Matrix& similarity, const Problem& problem, const std::vector<int>& ends_a,
                   const std::vector<int>& ends_b, const Candidate& match, const MappingOptions& options) {
    double mean = 0;
    for (const auto& row : similarity)
        for (const double c : row) mean += c / static_cast<double>(similarity.size() * row.size());
    Matrix costs = similarity;
    for (std::size_t i = 0; i < costs.size(); ++i)
        for (std::size_t j = 0; j < costs[i].size(); ++j) {
            const double d2 = squared_distance(problem.places_a[i], problem.places_b[j]);
            const bool same = problem.labels_a[i] == problem.labels_b[j];
            const bool matched =
                std::count(match.pairs.begin(), match.pairs.end(), std::pair{ends_a[i], ends_b[j]}) > 0;
            double& cost = costs[i][j];
            cost = options.path_weight * (mean > 0 ? cost / mean : 0) + options.position_weight * d2 -
                   (matched ? options.prior_weight : 0) + (same ? 0 : options.label_penalty);
            const bool reachable = d2 <= options.mixed_reach * options.mixed_reach;
            if (!same && !(reachable && may_be_mixed_up(problem.labels_a[i], problem.labels_b[j])))
                cost = forbidden;
        }
    return costs;
}

// Clockwise angle from straight up around the centre of the figure's box, in [0, 2π).
double bearing(Point2d place) {
    const double angle = math::atan2(place.x - 0.5, 0.5 - place.y);
    return angle < 0 ? angle + 2 * pi : angle;
}

std::vector<int> by_bearing(std::vector<int> items, const std::vector<Point2d>& places) {
    std::stable_sort(items.begin(), items.end(),
                     [&places](int a, int b) { return bearing(places[a]) < bearing(places[b]); });
    return items;
}

// Puts the pairs of one label into the same cyclic order on both sides, at the rotation with the smallest
// squared distances: the legs of a figure then keep their order from front to hind.
void uncross(Label label, const Problem& problem, std::vector<int>& partner) {
    std::vector<int> rows, columns;
    for (int i = 0; i < std::ssize(partner); ++i)
        if (partner[i] >= 0 && problem.labels_a[i] == label && problem.labels_b[partner[i]] == label) {
            rows.push_back(i);
            columns.push_back(partner[i]);
        }
    const std::size_t n = rows.size();
    if (n < 2) return;
    rows = by_bearing(std::move(rows), problem.places_a);
    columns = by_bearing(std::move(columns), problem.places_b);
    std::size_t best = 0;
    double best_sum = 0;
    for (std::size_t shift = 0; shift < n; ++shift) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum += squared_distance(problem.places_a[rows[k]], problem.places_b[columns[(k + shift) % n]]);
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

Mapping map_end_effectors(const SkeletonGraph& graph, const Mask& silhouette,
                          const ReferenceSkeleton& reference, const Candidate& match,
                          const MappingOptions& options) {
    const Figure character = make_figure(graph, silhouette);
    const Figure model = draw_reference(reference, match.mirrored);
    Mapping mapping;
    mapping.ends = clockwise(graph, end_effectors(graph));
    mapping.reference_ends = clockwise(model.graph, end_effectors(model.graph));
    mapping.costs = similarity_costs(character, mapping.ends, model, mapping.reference_ends, options);
    if (!options.label_aware) {
        list_pairs(mapping, hungarian(mapping.costs));
        return mapping;
    }
    const Problem problem = make_problem(graph, mapping.ends, model.graph, mapping.reference_ends);
    mapping.costs = aware_costs(mapping.costs, problem, mapping.ends, mapping.reference_ends, match, options);
    std::vector<int> partner = hungarian(mapping.costs);
    for (std::size_t i = 0; i < partner.size(); ++i)
        if (partner[i] >= 0 && mapping.costs[i][partner[i]] >= forbidden) partner[i] = -1;
    for (const Label label : {Label::limb, Label::wing}) uncross(label, problem, partner);
    list_pairs(mapping, partner);
    return mapping;
}

} // namespace pantin
