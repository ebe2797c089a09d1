// SPDX-License-Identifier: MIT
// identification.json: the references that were compared with a skeleton (docs/formats.md).
// Every double survives the way there and back to the bit. Readers throw Error(input) that names `file`, the
// place and the fact.
#pragma once

#include <string>
#include <vector>

#include "pantin/identification.hpp"

namespace pantin {

std::string identification_to_json(const Identification& identification);
// Pairs are checked against the skeleton's vertices and the nodes of the references.
Identification identification_from_json(const std::string& text, const std::string& file,
                                        const SkeletonGraph& graph,
                                        const std::vector<ReferenceSkeleton>& references);
// The chosen reference alone, of a file whose skeleton is not at hand.
std::string reference_from_json(const std::string& text, const std::string& file);

} // namespace pantin
