// SPDX-License-Identifier: MIT
// The folder of a character (docs/formats.md, "A character's folder"): what each step writes there, and what
// the steps after it read. A folder's files may have been corrected by hand, so readers check that they fit
// each other: Error(input) names the file and what is wrong. Writers: Error(output).
#pragma once

#include <filesystem>
#include <vector>

#include "formats/pictures.hpp"
#include "pantin/animation.hpp"
#include "pantin/identification.hpp"
#include "pantin/rigging.hpp"
#include "pantin/segmentation.hpp"
#include "pantin/skeletonization.hpp"

namespace pantin {

// --- one function a step, in the order of the flow; with `trace` the intermediate products, too ------------

void save_detected(const std::filesystem::path& folder, const RgbImage& drawing, const GreyImage& ink,
                   const Mask& mask);
// Of labels that were given instead of found there is only the picture.
void save_segmentation(const std::filesystem::path& folder, const Segmentation& segmentation, bool trace);
void save_skeletonization(const std::filesystem::path& folder, const Skeletonization& skeletonization,
                          bool trace);
void save_identification(const std::filesystem::path& folder, const Identification& identification);
// Mapping, mesh, weights and character.glb, which plays the animations.
void save_rig(const std::filesystem::path& folder, const Rig& rig, const RgbaImage& texture,
              const std::vector<BoneAnimation>& animations);

// --- and back (drawing, mask and labels: pictures.hpp) -----------------------------------------------------

// Of the labels' size.
SkeletonGraph read_skeleton(const std::filesystem::path& folder, const LabelMap& labels);
// Of segmentation.json; nothing where there is none, or none of a network with a type head.
TypeProbabilities read_type_probabilities(const std::filesystem::path& folder);
Identification read_identification(const std::filesystem::path& folder, const SkeletonGraph& graph,
                                   const std::vector<ReferenceSkeleton>& references);
Mapping read_mapping(const std::filesystem::path& file, const SkeletonGraph& graph,
                     const ReferenceSkeleton& reference);
std::vector<VertexWeights> read_weights(const std::filesystem::path& folder, const Rig& rig);

} // namespace pantin
