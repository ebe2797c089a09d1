// SPDX-License-Identifier: MIT
#include "segmentation/model.hpp"

#include <algorithm>

namespace pantin::segmentation {

int most_probable(const Tensor& router) {
    return static_cast<int>(std::max_element(router.begin(), router.end()) - router.begin());
}

Features Stem::forward(const Tensor& ink, const Runtime& runtime) const {
    Features features;
    for (std::size_t i = 0; i < down.size(); ++i) {
        const Tensor& x = i == 0 ? ink : features.stages.back();
        features.stages.push_back(res[i].forward(down[i].forward(x, runtime), runtime));
    }
    return features;
}

Tensor Router::forward(const Features& features, const Runtime& runtime) const {
    const Tensor& coarsest = features.stages.back();
    const Tensor pooled = network::concatenate(network::global_average_pool(coarsest), // [224, 1, 1]
                                               network::global_max_pool(coarsest));
    const Tensor scores = linear.forward(pooled, runtime);
    return network::softmax(scores, runtime);
}

Tensor PoseHead::forward(const Features& features, const Runtime& runtime) const {
    const Tensor x = conv.forward(features.stages.back(), runtime);
    const Tensor scores = linear.forward(network::global_average_pool(x), runtime);
    return network::softmax(scores, runtime);
}

Tensor Expert::forward(const Features& features, const Runtime& runtime) const {
    Tensor x = network::forward(context, features.stages.back(), runtime);
    for (std::size_t i = 0; i < decoder.size(); ++i) {
        const Tensor& skip = features.stages[features.stages.size() - 2 - i];
        const Tensor doubled = network::resize_bilinear(x, 2 * x.height(), 2 * x.width(), runtime);
        x = decoder[i].up.forward(network::concatenate(doubled, skip), runtime);
        x = network::forward(decoder[i].refine, x, runtime);
    }
    return network::softmax(logits.forward(x, runtime), runtime);
}

NetworkResult Network::forward(const Tensor& ink, const Runtime& runtime, int expert) const {
    NetworkResult result;
    const Features features = stem.forward(ink, runtime);
    result.router = router->forward(features, runtime);
    result.pose = pose->forward(features, runtime);
    result.expert = expert;
    if (expert < 0) result.expert = most_probable(result.router);
    result.parts = experts[static_cast<std::size_t>(result.expert)].forward(features, runtime);
    return result;
}

} // namespace pantin::segmentation
