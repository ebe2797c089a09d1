// SPDX-License-Identifier: MIT
// segmentation.json: what the network said of a character (docs/formats.md). Only written.
#pragma once

#include <string>

#include "pantin/segmentation.hpp"

namespace pantin {

std::string segmentation_to_json(const Segmentation& segmentation);

} // namespace pantin
