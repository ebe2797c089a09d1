// SPDX-License-Identifier: MIT
// Residual network and feature pyramid.
#include "detection/mask_rcnn/mask_rcnn.hpp"

namespace pantin::mask_rcnn {

template <class A>
std::vector<typename A::Map> ResNet<A>::forward(const Map& image, const Runtime& runtime) const {
    const Map x = max_pool(stem.forward(image, runtime), 3, 2, 1); // [64, height/4, width/4]
    std::vector<Map> stages; // [256, /4], [512, /8], [1024, /16], [2048, /32]
    for (const auto& layer : layers)
        stages.push_back(network::forward(layer, stages.empty() ? x : stages.back(), runtime));
    return stages;
}

template <class A>
std::vector<typename A::Map> FeaturePyramid<A>::forward(std::vector<Map> stages,
                                                        const Runtime& runtime) const {
    std::vector<Map> levels(stages.size()); // [256, …] each
    Map merged;
    for (std::size_t i = stages.size(); i-- > 0;) {
        merged = i + 1 < stages.size() ? network::add_nearest(inner[i], stages[i], merged, runtime)
                                       : inner[i].forward(stages[i], runtime);
        stages[i] = {}; // a large network's stages take much memory
        levels[i] = layer[i].forward(merged, runtime);
    }
    levels.push_back(max_pool(levels.back(), 1, 2, 0));
    return levels;
}

template struct ResNet<network::RealArithmetic>;
template struct ResNet<network::IntegerArithmetic>;
template struct FeaturePyramid<network::RealArithmetic>;
template struct FeaturePyramid<network::IntegerArithmetic>;

} // namespace pantin::mask_rcnn
