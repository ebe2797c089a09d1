// SPDX-License-Identifier: MIT
// weights.txt: the skin weights (thesis ch. 5; docs/formats.md). Written by to_weights_text (export.hpp).
#pragma once

#include <string>
#include <vector>

#include "pantin/rigging.hpp"

namespace pantin {

// The weights for a rig of these bones and this many vertices: the bones must be the rig's, and every vertex
// needs its line. Error(input) names `file`, the line and the fact.
std::vector<VertexWeights> weights_from_text(const std::string& text, const std::string& file,
                                             const Rig& rig);

} // namespace pantin
