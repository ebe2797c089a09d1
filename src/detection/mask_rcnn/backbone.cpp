// SPDX-License-Identifier: MIT
// Residual network and feature pyramid.
#include "detection/mask_rcnn/mask_rcnn.hpp"

namespace pantin::mask_rcnn {

std::vector<Tensor> ResNet::forward(const Tensor& image, const Runtime& runtime) const {
    const Tensor x = network::max_pool(stem.forward(image, runtime), 3, 2, 1); // [64, height/4, width/4]
    std::vector<Tensor> stages; // [256, /4], [512, /8], [1024, /16], [2048, /32]
    for (const std::vector<network::ResidualBlock>& layer : layers)
        stages.push_back(network::forward(layer, stages.empty() ? x : stages.back(), runtime));
    return stages;
}

std::vector<Tensor> FeaturePyramid::forward(std::vector<Tensor> stages, const Runtime& runtime) const {
    std::vector<Tensor> levels(stages.size()); // [256, …] each
    Tensor merged;
    for (std::size_t i = stages.size(); i-- > 0;) {
        Tensor lateral = inner[i].forward(stages[i], runtime);
        stages[i] = {}; // a large network's stages take much memory
        if (i + 1 < stages.size()) network::add_nearest(lateral, merged);
        merged = std::move(lateral);
        levels[i] = layer[i].forward(merged, runtime);
    }
    levels.push_back(network::max_pool(levels.back(), 1, 2));
    return levels;
}

} // namespace pantin::mask_rcnn
