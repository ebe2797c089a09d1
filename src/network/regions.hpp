// SPDX-License-Identifier: MIT
// Operations on regions of feature maps: RoIAlign and non-maximum suppression, as torchvision defines them.
#pragma once

#include <vector>

#include "network/integer/byte_tensor.hpp"
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

// Four neighbours of a sample of RoIAlign in a feature map, and their weights; all weights 0 outside of it.
struct RegionSample {
    std::size_t at[4] = {0, 0, 0, 0};
    float weight[4] = {0, 0, 0, 0};
};
// Samples of all size × size bins of a region on a map of width × height: bins in raster order, sampling²
// samples of a bin in raster order.
std::vector<RegionSample> samples_of(const Region& region, float scale, int size, int sampling, int width,
                                     int height);

// RoIAlign (He et al. 2017): per region size × size bins of features[0], each the mean of sampling² bilinear
// samples; `scale` is features' pixels per pixel of the input. Half-pixel offset of the later "aligned"
// variant is not applied. A region smaller than one feature pixel counts as one. The result of regions[i]
// goes to entry rows[i] of `output`, [entries][channels][size][size].
void roi_align(const Tensor& features, const std::vector<Region>& regions, const std::vector<int>& rows,
               float scale, int sampling, const Runtime& runtime, Tensor& output);
// The same on bytes: means of (byte − zero) in the order of the sum above, plus zero, rounded to the nearest
// byte; a sample outside of the map counts as zero.
void roi_align(const integer::ByteTensor& features, const std::vector<Region>& regions,
               const std::vector<int>& rows, float scale, int sampling, std::uint8_t zero,
               const Runtime& runtime, integer::ByteTensor& output);

} // namespace pantin::network
