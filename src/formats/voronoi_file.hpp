// SPDX-License-Identifier: MIT
// trace/voronoi.json: the edges of the Voronoi diagram with their residuals (docs/formats.md). Only written.
#pragma once

#include <string>
#include <vector>

#include "pantin/skeletonization.hpp"

namespace pantin {

std::string voronoi_to_json(const std::vector<VoronoiEdge>& edges, const std::vector<double>& residuals);

} // namespace pantin
