// SPDX-License-Identifier: MIT
// mapping.json: ends of the character and ends of the reference, paired (docs/formats.md).
// Every double survives the way there and back to the bit. Readers throw Error(input) that names `file`, the
// place and the fact.
#pragma once

#include <string>

#include "pantin/rigging.hpp"

namespace pantin {

std::string mapping_to_json(const Mapping& mapping);
// Pairs and costs; ends are those of the pairs.
Mapping mapping_from_json(const std::string& text, const std::string& file, const SkeletonGraph& graph,
                          const ReferenceSkeleton& reference);

} // namespace pantin
