// SPDX-License-Identifier: MIT
#include "segmentation/sketch_parse/model.hpp"

#include <algorithm>
#include <cmath>

#include "pantin/error.hpp"

namespace pantin::sketch_parse {
namespace {

constexpr double shares[] = {1, 0.75, 0.5}; // of the input, per scale

void take_maximum(Tensor& a, const Tensor& b) {
    std::transform(a.begin(), a.end(), b.begin(), a.begin(), [](float x, float y) { return std::max(x, y); });
}

} // namespace

int scaled_size(int size, double share) { return static_cast<int>(std::floor((size - 1) * share + 1.5)); }

Tensor Trunk::forward(const Tensor& image, const Runtime& runtime) const {
    Tensor x = network::max_pool(stem.forward(image, runtime), 3, 2, 1, true); // [64, 81, 81]
    for (const std::vector<network::ResidualBlock>& layer : layers) x = network::forward(layer, x, runtime);
    return x;
}

Tensor Expert::forward(const Tensor& shared, const Runtime& runtime) const {
    const Tensor x = bottleneck.forward(shared, runtime);
    Tensor scores = classifiers[0].forward(x, runtime);
    for (std::size_t i = 1; i < classifiers.size(); ++i)
        network::add(scores, classifiers[i].forward(x, runtime));
    return scores;
}

Tensor PoseHead::forward(const Tensor& scores, const Runtime& runtime) const {
    Tensor x = convs[0].forward(scores, runtime);                                    // [128, 20, 20]
    for (std::size_t i = 1; i < convs.size(); ++i) x = convs[i].forward(x, runtime); // [64, 9, 9], [32, 1, 1]
    return linear.forward(x, runtime);
}

Result Network::forward(const Tensor& image, const Runtime& runtime, int expert) const {
    Result result;
    Tensor shared = scales[0].trunk.forward(image, runtime);
    if (router)
        result.router =
            network::softmax(router->forward(network::global_average_pool(shared), runtime), runtime);
    else if (expert < 0)
        throw Error(ErrorKind::weights,
                    "sketch-parse: the weights have no router, so the expert must be named");
    result.expert = expert;
    if (expert < 0)
        result.expert = static_cast<int>(std::max_element(result.router.begin(), result.router.end()) -
                                         result.router.begin());

    const auto chosen = static_cast<std::size_t>(result.expert);
    for (std::size_t s = 0; s < scales.size(); ++s) {
        if (s > 0)
            shared =
                scales[s].trunk.forward(network::resize_corners(image, scaled_size(image.height(), shares[s]),
                                                                scaled_size(image.width(), shares[s])),
                                        runtime);
        Tensor scores = scales[s].experts[chosen].forward(shared, runtime);
        if (s > 0) scores = network::resize_corners(scores, result.scores.height(), result.scores.width());
        result.scales.push_back(scores);
        if (s == 0)
            result.scores = scores;
        else
            take_maximum(result.scores, scores);
    }
    if (!pose.empty()) result.pose = pose[chosen].forward(result.scores, runtime);
    return result;
}

} // namespace pantin::sketch_parse
