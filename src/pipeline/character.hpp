// SPDX-License-Identifier: MIT
// A character on its way through the steps: what the steps before have made, in memory or else in its folder.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "pipeline/solid.hpp"
#include "pipeline/workshop.hpp"

namespace pantin {

struct Character {
    std::filesystem::path folder;
    std::optional<RgbImage> drawing;
    std::optional<Mask> mask;
    std::optional<LabelMap> labels;
    std::optional<Segmentation> segmentation;       // when the workshop keeps intermediate products
    std::optional<Skeletonization> skeletonization; // likewise
    std::optional<SkeletonGraph> skeleton;
    std::optional<Identification> identification;
    std::optional<ReferenceSkeleton> blended; // with --blend
    std::optional<Rig> rig;
    std::shared_ptr<const Solid> solid; // of a model's folder
};

// What a step needs, read from the folder when it is not in memory. Error(input) names the file that is
// missing, invalid, or does not fit the others.
const RgbImage& drawing_of(Character& character);
const Mask& mask_of(Character& character);              // working size
const LabelMap& labels_of(Character& character);        // of the mask's size
const SkeletonGraph& skeleton_of(Character& character); // of the labels' size
const Identification& identification_of(Character& character, Workshop& workshop);
// The reference that identification chose; with --blend mixed with the best one of another type.
const ReferenceSkeleton& reference_of(Character& character, Workshop& workshop);
// Whether the chosen reference is left for right.
bool is_mirrored(const Identification& identification);
// Rigged anew from skeleton, labels, identification and mapping (a matter of milliseconds); the weights are
// those of weights.txt, so that mapping and weights can be corrected by hand.
const Rig& rig_of(Character& character, Workshop& workshop);
// The model of a folder with strokes.json; null for a drawing.
const Solid* solid_of(Character& character, Workshop& workshop);
// A rig made from the pictures; of a model its bones in space and its surface.
Rig in_its_space(Rig rig, Character& character, Workshop& workshop);
RgbaImage texture_of(Character& character, Workshop& workshop);
// Error(input): a label map has a value that is none; two pictures that belong together have different sizes.
void check_labels(const LabelMap& labels, const std::filesystem::path& file);
[[noreturn]] void fail_size(const std::filesystem::path& file, int width, int height,
                            const std::string& other, int other_width, int other_height);
// The rig for the pairs of a mapping.json.
Rig rig_from_mapping(Character& character, Workshop& workshop, const std::filesystem::path& file);

// Masks have 0 and 255 in files.
GreyImage to_grey(const Mask& mask);

// The weights of weights.txt for a rig of these bones and this many vertices.
std::vector<VertexWeights> weights_from_text(const std::string& text, const std::string& file,
                                             const Rig& rig);

} // namespace pantin
