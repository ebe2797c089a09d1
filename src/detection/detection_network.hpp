// SPDX-License-Identifier: MIT
// Internal: what the step needs of a detection network, whatever its architecture. The metadata of the weight
// file chooses (detection_networks.cpp).
#pragma once

#include <memory>
#include <vector>

#include "pantin/detection.hpp"
#include "pantin/network.hpp"

namespace pantin::detection {

class DetectionNetwork {
public:
    virtual ~DetectionNetwork() = default;
    // As CharacterFinder::find. Error(weights) when layers do not fit together.
    virtual std::vector<CharacterFinder::Found> find(const RgbImage& page, const Grid<float>& ink,
                                                     const network::Runtime& runtime) const = 0;
};

// The network of the architecture that the file's metadata `model` names; without it Mask R-CNN.
// Error(weights) names the file and the fact.
std::unique_ptr<DetectionNetwork> load_detection_network(const network::WeightFile& file);

} // namespace pantin::detection
