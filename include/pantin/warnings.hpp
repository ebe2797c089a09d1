// SPDX-License-Identifier: MIT
// What a person would see at once in a result and the status "ok" does not say (docs/warnings.md). Own.
//
// Every measure is a pure function of the products of the steps; nothing is rendered. Thresholds were set on
// real drawings, so that few results that look right are marked.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "pantin/animation.hpp"
#include "pantin/grid.hpp"
#include "pantin/identification.hpp"
#include "pantin/rigging.hpp"

namespace pantin {

// --- kinds -------------------------------------------------------------------------------------------------

enum class WarningKind {
    filled_crop,       // the silhouette fills its crop: the board was cut out, not what is on it
    lost_ink,          // ink of the character lies outside its silhouette
    lost_mask,         // the silhouette leaves out some of the mask that the user gave
    hanging_head,      // the head hangs upside down or below the body, which the drawing's does not
    still_limbs,       // limbs do not move in a walk
    joined_limbs,      // several legs move as a block, because the space between them is filled
    small_figure,      // the figure is small in its film
    unsure_type,       // another type is nearly as likely
    unproven_distance, // the graph distance decides, and is not known to be the smallest
    count
};
inline constexpr int warning_count = static_cast<int>(WarningKind::count);

struct WarningRow {
    WarningKind kind = WarningKind::count;
    std::string_view name; // in page.json and the reports
    double threshold = 0;  // of the measure
    bool below = false;    // a smaller value is marked, else a larger one
};

// clang-format off
inline constexpr std::array<WarningRow, warning_count> warning_table = {{
    {WarningKind::filled_crop,  "filled_crop",  0.72, false},
    {WarningKind::lost_ink,     "lost_ink",     0.10, false},
    {WarningKind::lost_mask,    "lost_mask",    0.05, false},
    {WarningKind::hanging_head, "hanging_head", 0.75, false},
    {WarningKind::still_limbs,  "still_limbs",  0.45, false},
    {WarningKind::joined_limbs, "joined_limbs", 0.60, false},
    {WarningKind::small_figure, "small_figure", 0.25, true},
    {WarningKind::unsure_type,  "unsure_type",  0.50, true},
    {WarningKind::unproven_distance, "unproven_distance", 0, false},
}};
// clang-format on

// The row of the kind, which is not `count`. No error. Own.
inline constexpr const WarningRow& row_of(WarningKind kind) {
    return warning_table[static_cast<std::size_t>(kind)];
}

// Whether the value of the measure lies beyond the threshold. No error. Own.
inline constexpr bool is_marked(WarningKind kind, double value) {
    const WarningRow& row = row_of(kind);
    return row.below ? value < row.threshold : value > row.threshold;
}

struct Warning {
    WarningKind kind = WarningKind::count;
    double value = 0; // of the measure
    std::string text; // for people: what is seen, and what to try
};

// --- measures ----------------------------------------------------------------------------------------------
//
// `labels`, `mask` and `ink` have the size of the rig's crop; the silhouette is where labels ≠ 0. `ink`:
// darkness as of ink_darkness(), at that size.

// Share of the crop's pixels inside the silhouette, 0 to 1; 0 of an empty crop. No error. Own.
double filled_crop(const LabelMap& labels);

// Share of the character's ink, weighted by darkness, that lies farther outside of the silhouette than mesh
// and texture reach (ink_margin()), 0 to 1. The character's ink: 8-connected pieces of pixels at least 0.2
// dark which overlap the mask, or which the crop does not cut (those that it cuts may be a neighbour's). 0
// without ink. No error. Own.
double lost_ink(const Grid<float>& ink, const Mask& mask, const LabelMap& labels);

// Share of the mask's pixels as far outside of the silhouette, 0 to 1. Only of a mask that the user gave:
// from a detected one the step after it rightly cuts what is paper. 0 of an empty mask. No error. Own.
double lost_mask(const Mask& mask, const LabelMap& labels);

// The mesh at a few evenly spaced times of a clip, the first of them its start; world units.
struct PosedClip {
    std::string name;
    std::vector<std::vector<Vec3>> poses; // [time][vertex]
};
// As many times as `samples`, ≥ 1. No error. Own.
PosedClip posed(const Rig& rig, const BoneAnimation& animation, int samples = 8);

// Share of the poses, 0 to 1, in which the centre of the head's vertices is below that of the body's, or the
// head is turned over: by more than a quarter, in the plane, from how it is drawn. 0 when there is no head or
// no body, or the drawn head's centre is not above the body's. No error. Own.
double hanging_head(const Rig& rig, const LabelMap& labels, const PosedClip& clip);

// Share of the limbs, 0 to 1, which hardly move: no vertex gets farther than 5 % of the limb's diagonal from
// where it would be if it followed the body stiffly in the plane. Limbs are the 8-connected pieces of the
// label of at least 1 % of the silhouette. 0 without limbs or body. No error. Own.
double still_limbs(const Rig& rig, const LabelMap& labels, const PosedClip& clip);

// How far several drawn legs are one limb to the rig, 0 to 1: the share of a piece's rows of pixels (pieces
// as above, of at least 3 %) that cross the outlines of one leg more than end in it, that is at least 2k + 2
// runs of ink (at least 0.35 dark) for k legs; of the piece where it is largest. A leg: a bone that a `step`
// track of the reference moves. No error. Own.
double joined_limbs(const Grid<float>& ink, const LabelMap& labels, const Rig& rig,
                    const ReferenceSkeleton& reference);

// Figure against frame: the longer side of the posed mesh's bounding box over the longer side of the view,
// mean over the poses; 1 without vertices. No error. Own.
double figure_size(const PosedClip& clip, const View& view);

// The type that comes next to the identified one. "" when there is none, when the confidence is no
// probability (without evidence), or when the decision does not rest on it: it was made by hand, or the
// reference is like any (a fish, a bust). `references` are those of the candidates. No error. Own.
std::string second_type(const Identification& identification,
                        const std::vector<ReferenceSkeleton>& references);

// Share of the references, 0 to 1, whose graph distance is not proven to be the smallest (`optimal`), where
// the distance alone decides (no evidence); else 0. No error. Own.
double unproven_distance(const Identification& identification);
// The text of that warning, with the references' names; "" when all are proven. No error. Own.
std::string unproven_line(const Identification& identification);

// --- all of them -------------------------------------------------------------------------------------------

struct ShownClip {
    const BoneAnimation& animation;
    View view;
};
// The products of one character, which must outlive the call.
struct ResultToCheck {
    const RgbImage& drawing; // the crop, at the page's resolution
    const Mask& mask;
    const LabelMap& labels;
    const Identification& identification;
    const std::vector<ReferenceSkeleton>& references;
    const ReferenceSkeleton& reference; // the one that was rigged
    const Rig& rig;
    std::vector<ShownClip> clips;
    bool mask_given = false, reference_given = false; // by the user
};

// Warnings in the order of the table, each kind at most once, of the clip where it is worst; limbs are judged
// in clips in which the reference steps. No error. Own.
std::vector<Warning> find_warnings(const ResultToCheck& result);

} // namespace pantin
