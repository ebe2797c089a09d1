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
constexpr double graph_weight = 1.318;
constexpr std::array<Row, 3> table = {{
    {"humanoid",
     3.582,
     {-1.069, 0.180, -0.013, -1.347, -4.036, 0.559, -1.790, 0.408, -1.285, -0.511, 0.366, -1.321, -3.841,
      -0.170}},
    {"quadruped",
     -2.984,
     {1.949, 2.389, 0.693, -3.719, 1.951, -2.201, -0.534, 1.735, 0.543, -1.111, 2.530, 3.920, 1.363, 0.942}},
    {"flying",
     -0.597,
     {-0.880, -2.570, -0.680, 5.066, 2.084, 1.642, 2.323, -2.143, 0.742, 1.622, -2.896, -2.599, 2.478,
      -0.772}},
}};

// Where the network's type head has seen the picture, its probability p adds −seen_weight · ln(p +
// seen_floor): however sure it is, it can be overruled. It knows much of what the rest of the evidence says,
// which then counts rest_weight times (tools/identification/fit_seen.py).
constexpr double seen_weight = 1.333, seen_floor = 0.02, rest_weight = 0.412;

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
        const auto index = std::find(type_names.begin(), type_names.end(), type) - type_names.begin();
        const double probability = (*seen)[static_cast<std::size_t>(index)];
        for (auto& [name, contribution] : terms) contribution *= rest_weight;
        terms.emplace_back("seen", -seen_weight * math::log(probability + seen_floor));
    }
    return terms;
}

} // namespace pantin
