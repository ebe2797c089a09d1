// SPDX-License-Identifier: MIT
// Ink, part labels and rig to how far several drawn legs are one limb to the rig, because the space between
// them is filled (docs/warnings.md). Own.
#include <algorithm>
#include <cmath>
#include <set>

#include "pantin/image.hpp"
#include "pantin/warnings.hpp"

namespace pantin {

namespace {

constexpr double least_piece = 0.03; // of the silhouette's area
constexpr float inked = 0.35F;       // darkness
constexpr int outline_reach = 2;     // pixels: the outer half of a pen's stroke lies outside of the piece
constexpr int runs_of_one_leg = 2;   // its left and its right outline

// Indices of joints that step.
std::set<int> stepping_joints(const ReferenceSkeleton& reference) {
    std::set<int> joints;
    for (const ReferenceClip& clip : reference.clips)
        for (const ReferenceTrack& track : clip.tracks)
            if (track.kind == TrackKind::step) joints.insert(track.joint);
    return joints;
}

// Where the outermost bone of each leg ends.
std::vector<Point2d> feet_of(const Rig& rig, const ReferenceSkeleton& reference) {
    const std::set<int> stepping = stepping_joints(reference);
    std::vector<Point2d> feet;
    for (std::size_t b = 0; b < rig.bones.size(); ++b) {
        const Bone& bone = rig.bones[b];
        if (stepping.count(bone.reference_joint) == 0) continue;
        const bool goes_on = std::any_of(rig.bones.begin(), rig.bones.end(), [&](const Bone& other) {
            return other.parent == static_cast<int>(b) && other.segment == bone.segment + 1;
        });
        if (!goes_on) feet.push_back(bone.tail);
    }
    return feet;
}

// Legs of each piece of the limbs' mask, by the piece's id.
std::vector<int> count_legs(const std::vector<Point2d>& feet, const Mask& limbs, const Components& pieces) {
    std::vector<int> legs(pieces.list.size() + 1, 0);
    const Grid<int> nearest = nearest_seed(limbs);
    for (const Point2d foot : feet) {
        const int x = std::clamp(static_cast<int>(std::rint(foot.x)), 0, limbs.width() - 1),
                  y = std::clamp(static_cast<int>(std::rint(foot.y)), 0, limbs.height() - 1);
        if (nearest(x, y) >= 0) ++legs[pieces.ids.data()[nearest(x, y)]];
    }
    return legs;
}

// Runs of ink in a row of the piece.
int runs_in_row(const Grid<float>& ink, const Components& pieces, const Component& piece, int y) {
    const auto near_piece = [&](int x) {
        for (int d = -outline_reach; d <= outline_reach; ++d)
            if (pieces.ids.value_or(x + d, y, 0) == piece.id) return true;
        return false;
    };
    int runs = 0;
    bool inside = false;
    for (int x = piece.box.x - outline_reach; x < piece.box.x + piece.box.width + outline_reach; ++x) {
        const bool is_ink = ink.value_or(x, y, 0) >= inked && near_piece(x);
        runs += is_ink && !inside;
        inside = is_ink;
    }
    return runs;
}

double share_of_crossed_rows(const Grid<float>& ink, const Components& pieces, const Component& piece,
                             int legs) {
    int crossed = 0;
    for (int y = piece.box.y; y < piece.box.y + piece.box.height; ++y)
        crossed += runs_in_row(ink, pieces, piece, y) >= runs_of_one_leg * (legs + 1);
    return static_cast<double>(crossed) / piece.box.height;
}

} // namespace

double joined_limbs(const Grid<float>& ink, const LabelMap& labels, const Rig& rig,
                    const ReferenceSkeleton& reference) {
    Mask limbs(labels.width(), labels.height());
    std::transform(labels.begin(), labels.end(), limbs.begin(), [](std::uint8_t label) -> std::uint8_t {
        return label == static_cast<std::uint8_t>(Label::limb);
    });
    const Components pieces = connected_components(limbs);
    const std::vector<int> legs = count_legs(feet_of(rig, reference), limbs, pieces);
    const auto paper = std::count(labels.begin(), labels.end(), 0);
    const double least = least_piece * (static_cast<double>(labels.size()) - static_cast<double>(paper));
    double most = 0;
    for (const Component& piece : pieces.list)
        if (legs[piece.id] > 0 && piece.area >= least)
            most = std::max(most, share_of_crossed_rows(ink, pieces, piece, legs[piece.id]));
    return most;
}

} // namespace pantin
