// SPDX-License-Identifier: MIT
// skeleton.json: the skeleton graph (docs/formats.md).
// Every double survives the way there and back to the bit. Readers throw Error(input) that names `file`, the
// place and the fact.
#pragma once

#include <string>

#include "pantin/skeletonization.hpp"

namespace pantin {

std::string skeleton_to_json(const SkeletonGraph& graph);
SkeletonGraph skeleton_from_json(const std::string& text, const std::string& file);

} // namespace pantin
