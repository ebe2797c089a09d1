// SPDX-License-Identifier: MIT
// The terms of Eq. 4.7 that both solvers share.
#pragma once

#include <utility>

#include "pantin/identification.hpp"

namespace pantin {

double edge_length(const LabelledGraph& graph, std::pair<int, int> edge);
// K_v |uv| + K_l lbl_dist(u, v): the price of matching vertex u of a with vertex v of b.
double vertex_cost(const LabelledGraph& a, int u, const LabelledGraph& b, int v, const GgdOptions& options);
// K_e (Σ|e| + Σ|e'|): delete all edges of a, insert all edges of b.
double empty_matching_cost(const LabelledGraph& a, const LabelledGraph& b, const GgdOptions& options);

} // namespace pantin
