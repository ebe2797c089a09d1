// SPDX-License-Identifier: MIT
// In come the similarity costs of the thesis (4.6, Eq. 4.12) and what is known of each end: its label, its
// place, what identification matched it with. Out go the costs of the assignment, and the assigned pairs in
// an order in which no two limbs cross. Our own (ERRATA 19).
#include "rigging/label_aware.hpp"

#include <algorithm>

namespace pantin {
namespace {

constexpr double clearly_below = 0.15; // of the box of the vertices

// Pairs of different labels that make sense: segmentation reads tails and wings as limbs; the wings of a
// figure that moves without wings are its arms; a head that was not found ends in the body.
bool may_stand_for(Label drawn, Label reference, bool reference_has_wings) {
    if (drawn == Label::limb) return reference == Label::tail || reference == Label::wing;
    if (drawn == Label::wing) return reference == Label::limb && !reference_has_wings;
    return drawn == Label::body && reference == Label::head;
}

double squared_distance(Point2d a, Point2d b) { return dot(a - b, a - b); }

// Squared distance of two ends: by their places in the figures' boxes, and beside the trunk, which a long
// neck or a spread arm does not distort.
double place_cost(const EndPlaces& a, const EndPlaces& b, std::size_t i, std::size_t j,
                  const MappingOptions& options) {
    const double in_box = options.position_weight * squared_distance(a.ends[i], b.ends[j]);
    if (a.beside_trunk.empty() || b.beside_trunk.empty()) return in_box;
    return in_box + options.trunk_weight * squared_distance(a.beside_trunk[i], b.beside_trunk[j]);
}

std::vector<int> by_bearing(std::vector<int> items, const EndPlaces& places) {
    std::stable_sort(items.begin(), items.end(),
                     [&places](int a, int b) { return places.bearings[a] < places.bearings[b]; });
    return items;
}

// Legs that all stand below the body.
bool below(const EndPlaces& places, const std::vector<int>& items) {
    return std::all_of(items.begin(), items.end(),
                       [&](int i) { return places.ends[i].y > places.middle.y + clearly_below; });
}

std::vector<int> from_left_to_right(std::vector<int> items, const EndPlaces& places) {
    std::stable_sort(items.begin(), items.end(),
                     [&](int a, int b) { return places.ends[a].x < places.ends[b].x; });
    return items;
}

} // namespace

std::vector<std::vector<double>> label_aware_costs(const std::vector<std::vector<double>>& similarity,
                                                   const LabelledEnds& drawn, const LabelledEnds& reference,
                                                   const std::vector<double>& prominence,
                                                   const Candidate& match, const MappingOptions& options) {
    double mean = 0;
    for (const auto& row : similarity)
        for (const double c : row) mean += c / static_cast<double>(similarity.size() * row.size());
    const bool wings = std::count(reference.labels.begin(), reference.labels.end(), Label::wing) > 0;
    std::vector<std::vector<double>> costs = similarity;
    for (std::size_t i = 0; i < costs.size(); ++i)
        for (std::size_t j = 0; j < costs[i].size(); ++j) {
            const double d2 = squared_distance(drawn.places.ends[i], reference.places.ends[j]);
            const bool same = drawn.labels[i] == reference.labels[j];
            const bool matched = std::count(match.pairs.begin(), match.pairs.end(),
                                            std::pair{drawn.vertices[i], reference.vertices[j]}) > 0;
            double& cost = costs[i][j];
            cost = options.path_weight * (mean > 0 ? cost / mean : 0) +
                   place_cost(drawn.places, reference.places, i, j, options) +
                   options.prominence_weight * (1 - prominence[i]) - (matched ? options.prior_weight : 0) +
                   (same ? 0 : options.label_penalty);
            if (prominence[i] == 0) cost = options.unmatched_cost;
            const bool reachable = d2 <= options.mixed_reach * options.mixed_reach;
            if (!same && !(reachable && may_stand_for(drawn.labels[i], reference.labels[j], wings)))
                cost = options.unmatched_cost;
        }
    return costs;
}

void uncross(Label label, const LabelledEnds& drawn, const LabelledEnds& reference,
             std::vector<int>& partner) {
    std::vector<int> rows, columns;
    for (int i = 0; i < std::ssize(partner); ++i)
        if (partner[i] >= 0 && drawn.labels[i] == label && reference.labels[partner[i]] == label) {
            rows.push_back(i);
            columns.push_back(partner[i]);
        }
    const std::size_t n = rows.size();
    if (n < 2) return;
    if (below(drawn.places, rows) && below(reference.places, columns)) {
        rows = from_left_to_right(std::move(rows), drawn.places);
        columns = from_left_to_right(std::move(columns), reference.places);
        for (std::size_t k = 0; k < n; ++k) partner[rows[k]] = columns[k];
        return;
    }
    rows = by_bearing(std::move(rows), drawn.places);
    columns = by_bearing(std::move(columns), reference.places);
    std::size_t best = 0;
    double best_sum = 0;
    for (std::size_t shift = 0; shift < n; ++shift) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum +=
                squared_distance(drawn.places.ends[rows[k]], reference.places.ends[columns[(k + shift) % n]]);
        if (shift == 0 || sum < best_sum) {
            best = shift;
            best_sum = sum;
        }
    }
    for (std::size_t k = 0; k < n; ++k) partner[rows[k]] = columns[(k + best) % n];
}

} // namespace pantin
