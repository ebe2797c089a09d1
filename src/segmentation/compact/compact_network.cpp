// SPDX-License-Identifier: MIT
// A square of ink through the compact network: router, pose and parts (sources: compact_network.hpp).
#include "segmentation/compact/compact_network.hpp"

namespace pantin::compact {

Features Stem::forward(const Tensor& ink, const Runtime& runtime) const {
    Features features;
    for (std::size_t i = 0; i < down.size(); ++i) {
        const Tensor& x = i == 0 ? ink : features.stages.back();
        features.stages.push_back(res[i].forward(down[i].forward(x, runtime), runtime));
    }
    return features;
}

namespace {

// Mean and maximum of each channel, one after the other.
Tensor pooled(const Tensor& x) {
    return network::concatenate(network::global_average_pool(x), network::global_max_pool(x));
}

} // namespace

Tensor Router::forward(const Features& features, const Runtime& runtime) const {
    return network::softmax(linear.forward(pooled(features.stages.back()), runtime), runtime);
}

Tensor PooledHead::forward(const Features& features, const Runtime& runtime) const {
    const Tensor x = conv.forward(features.stages.back(), runtime);
    return network::softmax(linear.forward(pooled(x), runtime), runtime);
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

namespace {

// The stem's stages; the expert decodes them.
struct Encoded : segmentation::EncodedInput {
    const Network& network;
    Features features;

    Encoded(const Network& net, Features stages, const Runtime& runtime)
        : network(net), features(std::move(stages)) {
        router = network.router->forward(features, runtime);
        if (network.type) type = network.type->forward(features, runtime);
        if (network.turn) turn = network.turn->forward(features, runtime);
    }
    segmentation::Answer decode(int expert, const Runtime& runtime) const override {
        return {network.pose->forward(features, runtime),
                network.experts[static_cast<std::size_t>(expert)].forward(features, runtime)};
    }
};

} // namespace

std::unique_ptr<segmentation::EncodedInput> Network::encode(const Tensor& ink, const Runtime& runtime) const {
    return std::make_unique<Encoded>(*this, stem.forward(ink, runtime), runtime);
}

} // namespace pantin::compact
