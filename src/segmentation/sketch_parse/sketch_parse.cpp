// SPDX-License-Identifier: MIT
// An image through SketchParse's scales, router, expert and pose head (sources: sketch_parse.hpp).
#include "segmentation/sketch_parse/sketch_parse.hpp"

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

Shared Network::encode(const Tensor& image, const Runtime& runtime) const {
    Shared shared;
    for (std::size_t s = 0; s < scales.size(); ++s)
        shared.scales.push_back(scales[s].trunk.forward(
            s == 0 ? image
                   : network::resize_corners(image, scaled_size(image.height(), shares[s]),
                                             scaled_size(image.width(), shares[s])),
            runtime));
    if (router)
        shared.router = network::softmax(
            router->forward(network::global_average_pool(shared.scales[0]), runtime), runtime);
    return shared;
}

Result Network::decode(const Shared& shared, int expert, const Runtime& runtime) const {
    Result result;
    result.expert = expert;
    const auto chosen = static_cast<std::size_t>(expert);
    for (std::size_t s = 0; s < scales.size(); ++s) {
        Tensor scores = scales[s].experts[chosen].forward(shared.scales[s], runtime);
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

Result Network::forward(const Tensor& image, const Runtime& runtime, int expert) const {
    Shared shared = encode(image, runtime);
    if (expert < 0 && !router)
        throw Error(ErrorKind::weights,
                    "sketch-parse: the weights have no router, so the expert must be named");
    if (expert < 0)
        expert = static_cast<int>(std::max_element(shared.router.begin(), shared.router.end()) -
                                  shared.router.begin());
    Result result = decode(shared, expert, runtime);
    result.router = std::move(shared.router);
    return result;
}

} // namespace pantin::sketch_parse
