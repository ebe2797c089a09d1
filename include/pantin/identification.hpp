// SPDX-License-Identifier: MIT
// Step 4 (thesis 4.5): the reference skeleton that the character moves like.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "pantin/label.hpp"
#include "pantin/point.hpp"
#include "pantin/reference.hpp"
#include "pantin/skeletonization.hpp"
#include "pantin/type_probabilities.hpp"

namespace pantin {

// --- geometric graph distance (Cheong et al. 2009, thesis Eq. 4.3–4.7) -------------------------------------

struct LabelledGraph {
    std::vector<Point2d> positions;
    std::vector<Label> labels;
    std::vector<std::pair<int, int>> edges;
};
// Vertices and edges in the graph's order, positions in pixels. No errors. Thesis 4.5.
LabelledGraph to_labelled_graph(const SkeletonGraph& graph);
// Nodes and edges in the reference's order, positions in [0, 1]. No errors. Thesis 4.5.
LabelledGraph to_labelled_graph(const ReferenceSkeleton& reference);
// Positions per axis to [0, 1] by the bounding box of the vertices; a side of no length goes to 1/2. No
// errors. Thesis 4.5 (ERRATA 11).
LabelledGraph normalised(const LabelledGraph& graph);
// x → 1 − x, for positions in [0, 1]. No errors. Own: a drawing may face either way.
LabelledGraph mirrored(const LabelledGraph& graph);

struct GgdOptions {
    double k_v = 1, k_e = 1, k_l = 5; // thesis ch. 5
    // Value of each label; the label distance is the absolute difference (thesis ch. 5).
    std::array<double, label_count> label_values = label_column(&LabelRow::value);
    long max_nodes = 2'000'000; // of the search tree; beyond it the best matching so far, optimal = false
};
struct GgdResult {
    double distance = 0;                    // recomputed from the matching in a fixed order
    double base = 0;                        // K_e (Σ|e| + Σ|e'|): the distance of the empty matching
    std::vector<std::pair<int, int>> pairs; // (vertex of A, vertex of B), ascending
    bool optimal = true;
};
// Our exact branch and bound; canonical: the lexicographically smallest matching within 1e-9 of the optimum.
// Positions of both graphs in [0, 1], the distance in the same unit. No errors; where the search is cut off,
// `optimal` is false. Cheong et al. 2009; thesis Eq. 4.3 to 4.7.
GgdResult geometric_graph_distance(const LabelledGraph& a, const LabelledGraph& b,
                                   const GgdOptions& options = {});
// Cost of a matching, pairs of (vertex of a, vertex of b); unit as above. Error(internal) when a vertex
// stands in two pairs or is none of its graph. Thesis Eq. 4.7.
double matching_cost(const LabelledGraph& a, const LabelledGraph& b,
                     const std::vector<std::pair<int, int>>& pairs, const GgdOptions& options = {});
// What it is the sum of: the costs (a) to (d) of thesis 4.5.
struct GgdTerms {
    double places = 0, labels = 0;   // of matched vertices: K_v · distance, K_l · label distance
    double lengths = 0;              // K_e · difference of the lengths of matched edges
    double edges_a = 0, edges_b = 0; // K_e · length of the edges without a partner
};
// For pairs as above, with the same errors. Thesis 4.5, Eq. 4.7.
GgdTerms matching_terms(const LabelledGraph& a, const LabelledGraph& b,
                        const std::vector<std::pair<int, int>>& pairs, const GgdOptions& options = {});

enum class IlpFormulation { literal, tightened }; // Eq. 4.6 as printed, or as in ERRATA 12
// Where GLPK stops (ERRATA 48). The defaults are those of thesis ch. 5.
struct IlpLimits {
    double gap = 0.00005;     // ε: relative difference of the best matching and the bound of what is left
    long iterations = 10'000; // subproblems of its branch and bound; 0: no limit
};
inline constexpr IlpLimits exact_ilp{0, 0};
// Whether the program was built with GLPK. No errors. Own.
bool ilp_available();
// The same distance by the integer linear program of the thesis, solved by GLPK; arguments and unit as of
// geometric_graph_distance. `optimal` is false, and the matching the best so far (the empty one, if there is
// none), where the iterations ended before the distance was known to within the gap. Error(usage) without
// GLPK, Error(internal) when it fails. Thesis Eq. 4.3 to 4.7 (ERRATA 12, 48).
GgdResult geometric_graph_distance_ilp(const LabelledGraph& a, const LabelledGraph& b,
                                       const GgdOptions& options, IlpFormulation formulation,
                                       const IlpLimits& limits = exact_ilp);

// --- the step ----------------------------------------------------------------------------------------------

// What finds the distance: our branch and bound, or GLPK by one of two formulations.
enum class GgdSolver { branch_and_bound, literal, tightened };
// Which constant K_n takes the place of when the reference is a quadruped (ERRATA 8).
enum class KnReading { none, k_v, k_e, k_l, all };
// Whether a reference is also tried left for right (ERRATA 11): never; the side of the smaller distance; or
// the distance and the side of the head decide together.
enum class Mirroring { none, distance, head };

struct IdentificationOptions {
    GgdOptions ggd;
    GgdSolver solver = GgdSolver::branch_and_bound; // `thesis`: literal. Without GLPK branch and bound serves
    IlpLimits ilp;                                  // of the other two
    double k_n = 0.38;                              // thesis ch. 5, undefined there
    KnReading k_n_replaces = KnReading::none;       // `thesis`: k_v
    Mirroring mirrored = Mirroring::head;           // `thesis`: none
    bool thesis_score = false;                      // `thesis`: score = ggd
    bool use_evidence = true; // presence and place of parts enter the score (ERRATA 10); false: score = the
                              // divided distance, ggd / (K_e Σ|e'|) (ERRATA 9)
    // What cannot move, as identify() says below, is no character; `thesis`: false.
    bool reject_unmovable = true;
    std::string reference; // decides when not empty, whatever the scores are
};

struct Candidate {
    std::string reference;
    bool mirrored =
        false; // the reference, left for right, is the better side (the head decides close questions)
    double distance = 0; // ggd of that side
    GgdTerms terms;      // what it is the sum of; zero when it was read from a file
    double score = 0;    // what decides; smaller is better; a tie goes to the earlier reference
    // name → contribution to the score, in a fixed order: "graph" (the divided distance), "prior", the traits
    // of docs/identification.md, then "seen" (the network's type head, if there is one). Empty unless
    // `use_evidence`. They add up to the score.
    std::vector<std::pair<std::string, double>> evidence;
    bool optimal = true;
    std::vector<std::pair<int, int>> pairs; // (skeleton vertex, reference node), ascending
};
struct Identification {
    std::string reference;
    std::string
        type; // what the reference is like, or its own name: "humanoid", "quadruped", "flying", "fish", …
    // exp(−score of the best) / Σ exp(−score) over the candidates that stand on their own (a reference that
    // is like another has that one's): with evidence the probability that the fitted model gives its decision
    // (equal priors of the three types), times 1 − the probability of `other` where a type head has seen the
    // picture; else a plain soft minimum.
    double confidence = 0;
    std::vector<Candidate> candidates; // from best to worst
};

// Step 4 (thesis 4.5, ERRATA 8 to 13). `labels` has the size of the graph, 0 outside the silhouette.
// Throws CharacterRejected("identify", …) for what cannot move: a skeleton without an edge, more than 24 ends
// (a scribble), one label only, or neither an end nor 2 % of the silhouette that is limb, wing or tail, and
// no head that ends a body of 15 % (a head alone); when `options.reference` says what it moves like,
// for a skeleton without an edge only; without `options.reject_unmovable` never. Error(input) when
// `options.reference` is none of the references. `seen`: what the segmentation network says of the type, a
// part of the evidence.
Identification identify(const SkeletonGraph& graph, const LabelMap& labels,
                        const std::vector<ReferenceSkeleton>& references,
                        const IdentificationOptions& options = {}, const TypeProbabilities& seen = {});

} // namespace pantin
