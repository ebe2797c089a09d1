// SPDX-License-Identifier: MIT
// The products of the steps for one character.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "formats/model_file.hpp"
#include "pantin/warnings.hpp"
#include "pipeline/context.hpp"

namespace pantin {

enum class Step { detect, segment, skeletonize, identify, rig, render };
inline constexpr std::array<const char*, 6> step_names = {"detect",   "segment", "skeletonize",
                                                          "identify", "rig",     "render"};
inline const char* name_of(Step step) { return step_names[static_cast<std::size_t>(step)]; }

// In the order of the flow (thesis Fig. 4.1). A folder holds no intermediate products, so what is read from
// one has the labels of the segmentation and the graph of the skeletonization alone.
struct Character {
    Step reached = Step::detect; // the last step whose products are there

    RgbImage drawing;            // 1: the crop, page pixels
    GreyImage ink;               //    the same: what of it is drawn
    Mask mask;                   //    working size
    bool exact_mask = false;     // the mask is the silhouette, to the pixel: the user gave it
    Mask ink_mask, network_mask; // the two silhouettes that detection chooses between, where it ran
    std::optional<LabelMap> given_labels;

    Segmentation segmentation;       // 2
    Skeletonization skeletonization; // 3
    Identification identification;   // 4

    // 5: the reference that it moves like, its rig, and the clips that it can play.
    ReferenceSkeleton reference;
    std::optional<Solid> solid; // of a model's folder: the rig is in space, the texture uncut
    Rig rig;
    RgbaImage texture;
    std::vector<BoneAnimation> animations;

    std::vector<Warning> warnings; // of 5 and 6
};

// A character whose folder has the files of the steps before `step`: what that step takes, read whole.
// Error(input) names the file that is missing, invalid, or does not fit the others.
Character load_character(const std::filesystem::path& folder, Step step, Context& context);

// The reference that identification chose; with --blend mixed with the best one of another type (thesis 6.2).
ReferenceSkeleton choose_reference(const Identification& identification,
                                   const std::vector<ReferenceSkeleton>& references, bool blended);
// Whether the chosen reference is left for right.
bool is_mirrored(const Identification& identification);

// The rig of the pairs in a mapping.json, on the character's surface in space if it has one; without a file
// ends are matched (thesis 4.6).
Rig make_rig(const Character& character, const std::filesystem::path& mapping, Context& context);
// The character's drawing cut to its silhouette; a solid's surface alone says where it ends.
RgbaImage make_texture(const Character& character);
// The clips of the reference in its order, then the recorded motion if the reference can follow it; a motion
// with the name of a clip replaces that clip.
std::vector<BoneAnimation> make_animations(const Rig& rig, const ReferenceSkeleton& reference,
                                           Context& context);

} // namespace pantin
