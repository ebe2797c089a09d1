// SPDX-License-Identifier: MIT
// Operations on regions of feature maps: RoIAlign and non-maximum suppression, as torchvision defines them.
#pragma once

#include <vector>

#include "pantin/network.hpp"

namespace pantin::network {

// In pixels of the network's input, continuous: a box of one pixel at (x, y) is (x, y, x + 1, y + 1).
struct Region {
    float left = 0, top = 0, right = 0, bottom = 0;
    bool operator==(const Region&) const = default;
};

inline float area(const Region& r) { return (r.right - r.left) * (r.bottom - r.top); }
// Intersection over union; NaN for two empty boxes.
float overlap(const Region& a, const Region& b);

// Indices of the boxes that stay, by descending score (equal scores: by index). A box goes when its overlap
// with one that stays and has the same group is greater than `threshold`.
std::vector<int> non_maximum_suppression(const std::vector<Region>& boxes, const std::vector<float>& scores,
                                         const std::vector<int>& groups, float threshold);

// RoIAlign (He et al. 2017): per region size × size bins of features[0], each the mean of sampling² bilinear
// samples; `scale` is features' pixels per pixel of the input. Half-pixel offset of the later "aligned"
// variant is not applied. A region smaller than one feature pixel counts as one. The result of regions[i]
// goes to entry rows[i] of `output`, [entries][channels][size][size].
void roi_align(const Tensor& features, const std::vector<Region>& regions, const std::vector<int>& rows,
               float scale, int sampling, const Runtime& runtime, Tensor& output);

} // namespace pantin::network
