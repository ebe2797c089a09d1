// SPDX-License-Identifier: MIT
// The JSON files of a character's folder as text, and back (docs/formats.md). Every double survives the way
// there and back to the bit. Readers throw Error(input) that names `file`, the place and the fact.
#pragma once

#include <string>

#include "pantin/identification.hpp"
#include "pantin/pipeline.hpp"
#include "pantin/rigging.hpp"
#include "pantin/segmentation.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

std::string page_to_json(const Page& page);
Page page_from_json(const std::string& text, const std::string& file);

std::string segmentation_to_json(const Segmentation& segmentation);
std::string contour_to_json(const std::vector<Border>& contour);

std::string skeleton_to_json(const SkeletonGraph& graph);
SkeletonGraph skeleton_from_json(const std::string& text, const std::string& file);

std::string identification_to_json(const Identification& identification);
// Pairs are checked against the skeleton's vertices and the nodes of the references.
Identification identification_from_json(const std::string& text, const std::string& file,
                                        const SkeletonGraph& graph,
                                        const std::vector<ReferenceSkeleton>& references);

std::string mapping_to_json(const Mapping& mapping);
// Pairs and costs; ends are those of the pairs.
Mapping mapping_from_json(const std::string& text, const std::string& file, const SkeletonGraph& graph,
                          const ReferenceSkeleton& reference);
std::string voronoi_to_json(const std::vector<VoronoiEdge>& edges, const std::vector<double>& residuals);

} // namespace pantin
