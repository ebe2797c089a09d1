// SPDX-License-Identifier: MIT
// A square of ink through the compact network: router, pose and parts (sources: compact_network.hpp).
#include "segmentation/compact/compact_network.hpp"

namespace pantin::compact {

template <class A> Features<A> Stem<A>::forward(const Tensor& ink, const Runtime& runtime) const {
    Features<A> features;
    const typename A::Map& input = A::input(ink);
    for (std::size_t i = 0; i < down.size(); ++i) {
        const typename A::Map& x = i == 0 ? input : features.stages.back();
        features.stages.push_back(res[i].forward(down[i].forward(x, runtime), runtime));
    }
    return features;
}

namespace {

// Mean and maximum of each channel, one after the other.
template <class Map> Tensor pooled(const Map& x) {
    return network::concatenate(global_average_pool(x), global_max_pool(x));
}

} // namespace

template <class A> Tensor Router<A>::forward(const Features<A>& features, const Runtime& runtime) const {
    return network::softmax(linear.forward(pooled(features.stages.back()), runtime), runtime);
}

template <class A> Tensor PooledHead<A>::forward(const Features<A>& features, const Runtime& runtime) const {
    const typename A::Map x = conv.forward(features.stages.back(), runtime);
    return network::softmax(linear.forward(pooled(x), runtime), runtime);
}

template <class A> Tensor PoseHead<A>::forward(const Features<A>& features, const Runtime& runtime) const {
    const typename A::Map x = conv.forward(features.stages.back(), runtime);
    const Tensor scores = linear.forward(global_average_pool(x), runtime);
    return network::softmax(scores, runtime);
}

template <class A> Tensor Expert<A>::forward(const Features<A>& features, const Runtime& runtime) const {
    typename A::Map x = network::forward(context, features.stages.back(), runtime);
    for (std::size_t i = 0; i < decoder.size(); ++i) {
        const typename A::Map& skip = features.stages[features.stages.size() - 2 - i];
        x = decoder[i].up.forward(concatenate(network::doubled(x, runtime), skip), runtime);
        x = network::forward(decoder[i].refine, x, runtime);
    }
    return network::softmax(network::real(logits, x, runtime), runtime);
}

namespace {

// The stem's stages; the expert decodes them.
template <class A> struct Encoded : segmentation::EncodedInput {
    const Network<A>& network;
    Features<A> features;

    Encoded(const Network<A>& net, Features<A> stages, const Runtime& runtime)
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

template <class A>
std::unique_ptr<segmentation::EncodedInput> Network<A>::encode(const Tensor& ink,
                                                               const Runtime& runtime) const {
    return std::make_unique<Encoded<A>>(*this, stem.forward(ink, runtime), runtime);
}

template struct Network<network::RealArithmetic>;
template struct Network<network::IntegerArithmetic>;

} // namespace pantin::compact
