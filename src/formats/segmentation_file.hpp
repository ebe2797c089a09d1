// SPDX-License-Identifier: MIT
// segmentation.json: what the network said of a character (docs/formats.md).
#pragma once

#include <string>

#include "pantin/segmentation.hpp"

namespace pantin {

std::string segmentation_to_json(const Segmentation& segmentation);
// What later steps need of it. Error(input) names file, place and fact.
TypeProbabilities type_probabilities_from_json(const std::string& text, const std::string& file);

} // namespace pantin
