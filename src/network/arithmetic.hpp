// SPDX-License-Identifier: MIT
// Real numbers or integers: what a network's modules, written once, need of the layers they are made of. The
// weight file says which one its tensors are for (metadata `arithmetic`).
#pragma once

#include "network/integer/byte_tensor.hpp"
#include "network/integer/layer_reader.hpp"
#include "network/integer/layers.hpp"
#include "network/layer_reader.hpp"
#include "network/regions.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

// fp32, PyTorch's layers (thesis 3.1).
struct RealArithmetic {
    using Map = Tensor; // what goes from layer to layer
    using Convolution = network::Convolution;
    using TransposedConvolution = network::TransposedConvolution;
    using Linear = network::Linear;
    using Reader = LayerReader;
    static const Tensor& input(const Tensor& x) { return x; }
};

// Bytes and integers (integer/layers.hpp); the input lies in [0, 1].
struct IntegerArithmetic {
    using Map = integer::ByteTensor;
    using Convolution = integer::Convolution;
    using TransposedConvolution = integer::TransposedConvolution;
    using Linear = integer::Linear;
    using Reader = integer::LayerReader;
    static integer::ByteTensor input(const Tensor& x) { return integer::to_bytes(x); }
};

// Whether the file's layers are integers. Error(weights) when it names another arithmetic.
bool holds_integers(const WeightFile& file);

// relu(layer(x) + shortcut)
inline Tensor add_relu(const Convolution& layer, const Tensor& x, const Tensor& shortcut,
                       const Runtime& runtime) {
    Tensor y = layer.forward(x, runtime);
    add_relu(y, shortcut);
    return y;
}
inline integer::ByteTensor add_relu(const integer::Convolution& layer, const integer::ByteTensor& x,
                                    const integer::ByteTensor& shortcut, const Runtime& runtime) {
    return layer.forward_and_add(x, shortcut, runtime);
}

// layer(x) + y, resized to its size (the feature pyramid's top-down pathway)
inline Tensor add_nearest(const Convolution& layer, const Tensor& x, const Tensor& y,
                          const Runtime& runtime) {
    Tensor sum = layer.forward(x, runtime);
    add_nearest(sum, y);
    return sum;
}
inline integer::ByteTensor add_nearest(const integer::Convolution& layer, const integer::ByteTensor& x,
                                       const integer::ByteTensor& y, const Runtime& runtime) {
    return layer.forward_and_add(x, integer::resize_nearest(y, x.height(), x.width()), runtime);
}

// relu(layer(x))
inline Tensor relu(const Linear& layer, const Tensor& x, const Runtime& runtime) {
    Tensor y = layer.forward(x, runtime);
    relu(y);
    return y;
}
inline integer::ByteTensor relu(const integer::Linear& layer, const integer::ByteTensor& x,
                                const Runtime& runtime) {
    return layer.forward(x, runtime);
}

// Of a layer without activation at the end of a network: real numbers.
template <class Layer> Tensor real(const Layer& layer, const Tensor& x, const Runtime& runtime) {
    return layer.forward(x, runtime);
}
template <class Layer> Tensor real(const Layer& layer, const integer::ByteTensor& x, const Runtime& runtime) {
    return layer.forward_real(x, runtime);
}

// Twice the size, bilinear.
inline Tensor doubled(const Tensor& x, const Runtime& runtime) {
    return resize_bilinear(x, 2 * x.height(), 2 * x.width(), runtime);
}
inline integer::ByteTensor doubled(const integer::ByteTensor& x, const Runtime&) {
    return integer::doubled(x);
}

} // namespace pantin::network
