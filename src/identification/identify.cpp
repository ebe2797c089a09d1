// SPDX-License-Identifier: MIT
// Step 4: which reference skeleton the character moves like (thesis 4.5; readings in ERRATA 8–13). In come
// the skeleton graph, the labels and the references; out go the candidates, each with its distance and score.
#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/suggestion.hpp"
#include "identification/evidence.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

constexpr int most_ends = 24;          // a skeleton with more is a scribble
constexpr double tie = 1e-9;           // distances closer than this are equal
constexpr double head_weight = 2;      // of the head's side against the graph distance
constexpr double smallest_body = 0.15; // share of the silhouette on which a head can nod
constexpr double smallest_part =
    0.02; // share of the silhouette that can move although no skeleton end lies in it

// A reference whose needs are met is chosen before the one that it is like, and changes nothing between
// types.
constexpr double special_bonus = 0.01;

// Of the borders between parts against the root of the silhouette's area. Labelled drawings (1800, a quarter
// of them generated: a wing that is a zigzag on the body has much of it) stay below 8.5.
constexpr double most_inner_border = 10;

[[noreturn]] void reject(const std::string& reason) { throw CharacterRejected("identify", reason); }

// Number of pairs of 4-neighbours that belong to two different parts.
long inner_border(const LabelMap& labels) {
    long count = 0;
    const auto differ = [&](int p, int q) { return p != 0 && q != 0 && p != q; };
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            count += differ(labels(x, y), labels.value_or(x + 1, y, 0)) +
                     differ(labels(x, y), labels.value_or(x, y + 1, 0));
    return count;
}

// A head alone, a blob, a scribble.
void reject_what_cannot_move(const SkeletonGraph& graph, const LabelMap& labels) {
    int ends = 0, moving_ends = 0;
    bool head_end = false;
    for (const SkeletonVertex& v : graph.vertices) {
        ends += v.end;
        moving_ends += v.end && appendages.contains(v.label);
        head_end = head_end || (v.end && v.label == Label::head);
    }
    if (ends > most_ends) reject("a scribble: its skeleton has " + std::to_string(ends) + " ends");
    std::vector<Label> present;
    for (int l = 1; l < label_count; ++l)
        if (!part_region(labels, {static_cast<Label>(l)}).empty()) present.push_back(static_cast<Label>(l));
    if (present.size() == 1) reject("one part only: " + std::string(name_of(present[0])));
    const double area = part_region(labels, all_parts).area;
    const double moving = part_region(labels, appendages).area;
    if (static_cast<double>(inner_border(labels)) > most_inner_border * std::sqrt(area))
        reject("a scribble: its parts are scattered");
    const bool nods = head_end && part_region(labels, {Label::body}).area > smallest_body * area;
    if (moving_ends == 0 && moving < smallest_part * area && !nods)
        reject("no limb, wing or tail, and no head on a body: nothing can move");
}

// Without GLPK our own search serves.
GgdResult solve(const LabelledGraph& a, const LabelledGraph& b, const GgdOptions& ggd,
                const IdentificationOptions& options) {
    if (options.solver == GgdSolver::branch_and_bound || !ilp_available())
        return geometric_graph_distance(a, b, ggd);
    return geometric_graph_distance_ilp(
        a, b, ggd, options.solver == GgdSolver::literal ? IlpFormulation::literal : IlpFormulation::tightened,
        options.ilp);
}

// Mean x of the vertices with the label; false when there is none.
bool mean_x(const LabelledGraph& graph, Label label, double& mean) {
    int count = 0;
    mean = 0;
    for (std::size_t i = 0; i < graph.positions.size(); ++i)
        if (graph.labels[i] == label) {
            mean += graph.positions[i].x;
            ++count;
        }
    if (count > 0) mean /= count;
    return count > 0;
}

// How far the head is to the right of the body, in widths of the figure's box; 0 when one of them is not
// known.
double head_side(const LabelledGraph& graph) {
    double head = 0, body = 0;
    return mean_x(graph, Label::head, head) && mean_x(graph, Label::body, body) ? head - body : 0;
}

// Where the graph distance leaves the two sides close, the head decides: each side also pays how far it puts
// the head from where it is drawn.
bool mirror_is_better(const LabelledGraph& graph, const LabelledGraph& model, double distance,
                      double mirrored_distance) {
    const double drawn = head_side(graph), side = head_side(model);
    return mirrored_distance + head_weight * std::abs(drawn + side) <
           distance + head_weight * std::abs(drawn - side) - tie;
}

// K_e Σ|e'|: what a drawing without any edge in common would pay for the reference (ERRATA 9).
double reference_cost(const ReferenceSkeleton& reference, const GgdOptions& ggd) {
    const LabelledGraph model = normalised(to_labelled_graph(reference));
    double sum = 0;
    for (const auto& [u, v] : model.edges) sum += distance(model.positions[u], model.positions[v]);
    return ggd.k_e * sum;
}

// The type whose evidence a reference shares: its own, or that of the compiled-in reference nearest to it.
std::string type_of(const ReferenceSkeleton& reference) {
    if (has_evidence(reference.name)) return reference.name;
    const LabelledGraph graph = normalised(to_labelled_graph(reference));
    std::string nearest;
    double smallest = 0;
    for (const ReferenceSkeleton& known : load_references()) {
        if (!has_evidence(known.name)) continue;
        const double d = geometric_graph_distance(graph, normalised(to_labelled_graph(known))).distance;
        const double divided = d / reference_cost(known, {});
        if (!nearest.empty() && divided >= smallest) continue;
        nearest = known.name;
        smallest = divided;
    }
    return nearest;
}

// K_n where the reference is a quadruped, by name, by what it is like, or by what it is nearest to (ERRATA
// 8).
GgdOptions options_for(const ReferenceSkeleton& reference, const IdentificationOptions& options) {
    GgdOptions ggd = options.ggd;
    const KnReading reading = options.k_n_replaces;
    if (reading == KnReading::none) return ggd;
    if ((reference.like.empty() ? type_of(reference) : reference.like) != "quadruped") return ggd;
    if (reading == KnReading::k_v || reading == KnReading::all) ggd.k_v = options.k_n;
    if (reading == KnReading::k_e || reading == KnReading::all) ggd.k_e = options.k_n;
    if (reading == KnReading::k_l || reading == KnReading::all) ggd.k_l = options.k_n;
    return ggd;
}

// The better side of a reference; the drawn side on a tie.
Candidate compare(const LabelledGraph& graph, const ReferenceSkeleton& reference,
                  const IdentificationOptions& options) {
    const GgdOptions ggd = options_for(reference, options);
    const LabelledGraph model = normalised(to_labelled_graph(reference));
    GgdResult best = solve(graph, model, ggd, options);
    Candidate candidate;
    candidate.reference = reference.name;
    if (options.mirrored != Mirroring::none) {
        GgdResult other = solve(graph, mirrored(model), ggd, options);
        candidate.mirrored = options.mirrored == Mirroring::head
                                 ? mirror_is_better(graph, model, best.distance, other.distance)
                                 : other.distance < best.distance - tie;
        if (candidate.mirrored) best = std::move(other);
    }
    candidate.distance = best.distance;
    candidate.optimal = best.optimal;
    candidate.pairs = std::move(best.pairs);
    candidate.terms =
        matching_terms(graph, candidate.mirrored ? mirrored(model) : model, candidate.pairs, ggd);
    return candidate;
}

// What the decision rests on beside the graph.
struct Observations {
    Traits traits;
    TypeProbabilities seen;
};

void score(Candidate& candidate, const ReferenceSkeleton& reference, const Observations& observed,
           const IdentificationOptions& options) {
    if (options.thesis_score) {
        candidate.score = candidate.distance;
        return;
    }
    const double divided = candidate.distance / reference_cost(reference, options.ggd);
    if (!options.use_evidence) {
        candidate.score = divided;
        return;
    }
    candidate.evidence = evidence_terms(type_of(reference), divided, observed.traits, observed.seen);
    for (const auto& [name, contribution] : candidate.evidence) candidate.score += contribution;
}

bool with_evidence(const IdentificationOptions& options) {
    return options.use_evidence && !options.thesis_score;
}

bool stands_alone(const ReferenceSkeleton& reference) { return reference.like.empty(); }

bool needs_met(const ReferenceSkeleton& reference, const SkeletonGraph& graph, const Traits& traits) {
    return std::all_of(reference.needs.begin(), reference.needs.end(), [&](const ReferenceNeed& need) {
        const double value = quantity(need.quantity, graph, traits);
        return value >= need.low && value <= need.high;
    });
}

// The candidate that the reference is like; the best one for "any". Null when there is none.
const Candidate* model_of(const ReferenceSkeleton& reference, const std::vector<Candidate>& independent) {
    if (reference.like == "any") return &independent.front();
    const auto found = std::find_if(independent.begin(), independent.end(),
                                    [&](const Candidate& c) { return c.reference == reference.like; });
    return found == independent.end() ? nullptr : &*found;
}

// exp(−score) / Σ exp(−score): the posterior of the fitted model under equal priors.
double confidence_of(const Candidate& model, const std::vector<Candidate>& independent) {
    double sum = 0;
    for (const Candidate& c : independent) sum += math::exp(model.score - c.score);
    return 1 / sum;
}

void sort_by_score(std::vector<Candidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
}

const ReferenceSkeleton& named(const std::vector<ReferenceSkeleton>& references, const std::string& name) {
    const auto found =
        std::find_if(references.begin(), references.end(), [&](auto& r) { return r.name == name; });
    if (found == references.end()) {
        std::vector<std::string> names;
        for (const ReferenceSkeleton& reference : references) names.push_back(reference.name);
        throw Error(ErrorKind::input, "there is no reference '" + name + "'" + did_you_mean(name, names));
    }
    return *found;
}

// The references that stand on their own, by their scores.
std::vector<Candidate> independent_candidates(const LabelledGraph& drawn, const Observations& observed,
                                              const std::vector<ReferenceSkeleton>& references,
                                              const IdentificationOptions& options) {
    std::vector<Candidate> candidates;
    for (const ReferenceSkeleton& reference : references) {
        if (!stands_alone(reference)) continue;
        candidates.push_back(compare(drawn, reference, options));
        score(candidates.back(), reference, observed, options);
    }
    if (candidates.empty()) throw Error(ErrorKind::input, "every reference skeleton is like another one");
    sort_by_score(candidates);
    return candidates;
}

// A reference that is like another one: with evidence it has that one's, and goes before it.
Candidate dependent_candidate(const LabelledGraph& drawn, const Observations& observed,
                              const ReferenceSkeleton& reference, const Candidate& model,
                              const IdentificationOptions& options) {
    Candidate candidate = compare(drawn, reference, options);
    score(candidate, reference, observed, options);
    if (with_evidence(options)) {
        candidate.evidence = model.evidence;
        candidate.evidence.emplace_back("special", -special_bonus);
        candidate.score = model.score - special_bonus;
    }
    return candidate;
}

// Type and confidence of the reference that was chosen.
// A character that the network takes for none of the types has little, whatever it is nearest to.
void describe(Identification& result, const ReferenceSkeleton& chosen,
              const std::vector<Candidate>& independent, const IdentificationOptions& options,
              const TypeProbabilities& seen) {
    if (stands_alone(chosen)) {
        result.type = has_evidence(chosen.name) ? chosen.name : type_of(chosen);
        const auto own = std::find_if(independent.begin(), independent.end(),
                                      [&](auto& c) { return c.reference == chosen.name; });
        result.confidence = confidence_of(*own, independent);
    } else {
        result.type = chosen.like == "any" ? chosen.name : chosen.like;
        const Candidate* model = model_of(chosen, independent);
        result.confidence = model ? confidence_of(*model, independent) : 0;
    }
    if (seen && with_evidence(options) && chosen.like != "any")
        result.confidence *= 1 - probability_of(*seen, "other");
}

} // namespace

Identification identify(const SkeletonGraph& graph, const LabelMap& labels,
                        const std::vector<ReferenceSkeleton>& references,
                        const IdentificationOptions& options, const TypeProbabilities& seen) {
    if (references.empty()) throw Error(ErrorKind::input, "there is no reference skeleton to compare with");
    if (graph.edges.empty() && options.reject_unmovable) reject("a blob: its skeleton has no edge");
    if (options.reference.empty() && options.reject_unmovable) reject_what_cannot_move(graph, labels);
    const LabelledGraph drawn = normalised(to_labelled_graph(graph));
    const Observations observed{measure_traits(graph, labels), seen};
    // The references that stand on their own …
    const std::vector<Candidate> independent = independent_candidates(drawn, observed, references, options);
    Identification result;
    result.candidates = independent;
    // … and those that are like one of them, where their needs are met or they are asked for.
    for (const ReferenceSkeleton& reference : references) {
        const Candidate* model = stands_alone(reference) ? nullptr : model_of(reference, independent);
        const bool wanted = reference.name == options.reference;
        if (model && (wanted || (with_evidence(options) && needs_met(reference, graph, observed.traits))))
            result.candidates.push_back(dependent_candidate(drawn, observed, reference, *model, options));
    }
    sort_by_score(result.candidates);
    // The best one, unless the options decide.
    result.reference = options.reference.empty() ? result.candidates.front().reference : options.reference;
    describe(result, named(references, result.reference), independent, options, seen);
    return result;
}

} // namespace pantin
