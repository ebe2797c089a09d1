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
constexpr double graph_weight = 3.110;
// The type head's probability p adds −seen_weight · ln(p + seen_floor): however sure it is, it can be
// overruled.
constexpr double seen_weight = 1.0, seen_floor = 0.02;
constexpr std::array<Row, 3> table = {{
    {"humanoid",
     2.726,
     {-2.135, 1.343, 0.670, -0.264, -1.540, 1.154, -2.932, -0.577, -1.996, -0.492, 0.950, -1.844, -1.967,
      -1.648}},
    {"quadruped",
     -0.999,
     {1.882, 1.613, -0.174, -3.280, 0.290, -1.664, -1.208, 0.916, 1.815, -0.909, 2.124, 2.710, 1.377, 0.772}},
    {"flying",
     -1.726,
     {0.253, -2.956, -0.497, 3.545, 1.250, 0.510, 4.140, -0.339, 0.181, 1.400, -3.074, -0.866, 0.590, 0.876}},
}};

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
        terms.emplace_back("seen", -seen_weight * math::log(probability + seen_floor));
    }
    return terms;
}

} // namespace pantin
