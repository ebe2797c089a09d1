// SPDX-License-Identifier: MIT
// Internal: which ink makes one character, as Mask R-CNN sees it.
#pragma once

#include "detection/grouping.hpp"

namespace pantin {

// What the network says of each pixel of the page, at the size of the ink that is grouped.
struct Claims {
    Grid<int> owner;            // 0, or the number of the detection (1, 2, …) that claims the pixel most
    std::vector<double> scores; // of the detections
};

// The detections with enough score (`network_score`) and no parts of larger ones (`contained_share`).
std::vector<CharacterFinder::Found> whole_characters(std::vector<CharacterFinder::Found> found,
                                                     const DetectionOptions& options);

// The network says which ink belongs together, the ink says where the border runs:
// 1. A connected piece of ink goes to the detection that claims most of its claimed pixels. A piece of which
//    `shared_claim` or more go to others (characters that touch) is divided, each pixel to the nearest claim.
//    What of it lies farther than `claimed_reach` of the character's diagonal from its claims and goes on
//    beyond `claimed_extent` (a line of grass, the frame of the page; a tail ends before) belongs to nobody.
// 2. A piece that nobody claims goes to the nearest claimed ink within `unclaimed_reach` of that character's
//    diagonal (the mask is coarse, fingers and antennae stick out of it) if no pixel of it is farther than
//    `unclaimed_extent` (a house beside a person is no part of it), else it is no character's.
Grouping group_by_claims(const Mask& ink, const Claims& claims, const DetectionOptions& options);

} // namespace pantin
