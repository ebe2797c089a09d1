// SPDX-License-Identifier: MIT
// The evidence that decides between the reference skeletons, in the default preset.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "identification/traits.hpp"
#include "pantin/type_probabilities.hpp"

namespace pantin {

// How well a reference explains the drawing: contributions to its score (smaller is better), named, in a
// fixed order: first "graph" (the divided distance), then a constant "prior", then one per trait, then "seen"
// where a type head has seen the picture. `type` is a row of the table: "humanoid", "quadruped" or "flying".
std::vector<std::pair<std::string, double>> evidence_terms(const std::string& type, double divided_distance,
                                                           const Traits& traits,
                                                           const TypeProbabilities& seen);
// Whether the table has a row for this reference.
bool has_evidence(const std::string& type);

} // namespace pantin
