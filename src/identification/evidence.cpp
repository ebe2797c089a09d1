// SPDX-License-Identifier: MIT
// Constants of the evidence. Fitted by tools/identification/fit_evidence.py (multinomial logistic regression
// with a ridge) on true labels of real drawings; the command and the figures stand in docs/identification.md.
#include "identification/evidence.hpp"

#include <algorithm>

#include "core/math.hpp"

namespace pantin {
namespace {

struct Row {
    std::string_view type;
    double prior;
    Traits weights; // per trait, in the order of Trait
};

// Score = graph_weight · divided distance + prior + Σ weight · trait, one row per type; smaller is better.
constexpr double graph_weight = 2.262;
constexpr std::array<Row, 3> table = {{
    {"humanoid",
     3.170,
     {-1.129, 0.505, 0.165, -0.472, -2.731, 1.371, -0.903, -0.157, -1.517, -0.513, 0.560, -2.417, -2.486,
      -0.581}},
    {"quadruped",
     -2.145,
     {2.015, 2.472, 0.302, -4.469, 1.777, -3.022, 0.206, 2.050, 0.569, -0.989, 2.330, 4.069, 1.198, 0.692}},
    {"flying",
     -1.025,
     {-0.886, -2.977, -0.466, 4.941, 0.954, 1.650, 0.697, -1.893, 0.948, 1.503, -2.890, -1.652, 1.287,
      -0.111}},
}};

// Where the network's type head has seen the picture, its probability p adds −seen_weight · ln(p +
// seen_floor): however sure it is, it can be overruled. It knows much of what the rest of the evidence says,
// which then counts rest_weight times (tools/identification/fit_seen.py).
constexpr double seen_weight = 1.92, seen_floor = 0.02, rest_weight = 0.16;

const Row* find_row(const std::string& type) {
    const auto row =
        std::find_if(table.begin(), table.end(), [&type](const Row& r) { return r.type == type; });
    return row == table.end() ? nullptr : row;
}

} // namespace

bool has_evidence(const std::string& type) { return find_row(type) != nullptr; }

std::vector<std::pair<std::string, double>> evidence_terms(const std::string& type, double divided_distance,
                                                           const Traits& traits,
                                                           const TypeProbabilities& seen) {
    std::vector<std::pair<std::string, double>> terms = {{"graph", graph_weight * divided_distance}};
    const Row* row = find_row(type);
    if (!row) return terms;
    terms.emplace_back("prior", row->prior);
    for (int i = 0; i < trait_count; ++i) terms.emplace_back(trait_names[i], row->weights[i] * traits[i]);
    if (seen) {
        for (auto& [name, contribution] : terms) contribution *= rest_weight;
        terms.emplace_back("seen", -seen_weight * math::log(probability_of(*seen, type) + seen_floor));
    }
    return terms;
}

} // namespace pantin
