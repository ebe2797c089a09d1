// Constants of the evidence. Fitted by tools/identification/fit_evidence.py (multinomial logistic regression
// with a ridge) on true labels of real drawings; the command and the figures stand in docs/identification.md.
#include "identification/evidence.hpp"

#include <algorithm>

namespace pantin {
namespace {

struct Row {
    std::string_view type;
    double prior;
    Traits weights; // per trait, in the order of Trait
};

// Score = graph_weight · divided distance + prior + Σ weight · trait, one row per type; smaller is better.
constexpr double graph_weight = 3.485;
constexpr std::array<Row, 3> table = {{
    {"humanoid",
     2.919,
     {-2.550, 2.024, 0.678, 0.057, -1.436, 1.896, -3.546, -0.920, -2.700, -0.498, 1.080, -2.431, -2.146,
      -2.080}},
    {"quadruped",
     -1.289,
     {2.220, 1.851, -0.167, -4.195, 0.207, -2.221, -2.499, 1.502, 2.687, -1.146, 2.555, 3.525, 1.383, 0.944}},
    {"flying",
     -1.630,
     {0.330, -3.875, -0.512, 4.138, 1.229, 0.325, 6.045, -0.581, 0.014, 1.644, -3.634, -1.094, 0.763, 1.135}},
}};

const Row* find_row(const std::string& type) {
    const auto row =
        std::find_if(table.begin(), table.end(), [&type](const Row& r) { return r.type == type; });
    return row == table.end() ? nullptr : row;
}

} // namespace

bool has_evidence(const std::string& type) { return find_row(type) != nullptr; }

std::vector<std::pair<std::string, double>> evidence_terms(const std::string& type, double divided_distance,
                                                           const Traits& traits) {
    std::vector<std::pair<std::string, double>> terms = {{"graph", graph_weight * divided_distance}};
    const Row* row = find_row(type);
    if (!row) return terms;
    terms.emplace_back("prior", row->prior);
    for (int i = 0; i < trait_count; ++i) terms.emplace_back(trait_names[i], row->weights[i] * traits[i]);
    return terms;
}

} // namespace pantin
