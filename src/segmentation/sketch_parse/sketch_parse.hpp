// SPDX-License-Identifier: MIT
// SketchParse (Sarvadevabhatla et al. 2017; thesis 4.3, Fig. 4.8) as its authors built it: a dilated
// ResNet-101 (DeepLab, Chen et al. 2018) whose last bottleneck and classifiers belong to an expert, at three
// scales with weights of their own, and a pose head on the fused scores. Tensor names are those of the
// authors' state dictionary; widths and depths are those of the weight file.
//
// Shapes in comments are for the authors' input of 321×321.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "network/residual.hpp"
#include "pantin/network.hpp"

namespace pantin::sketch_parse {

using network::Convolution;
using network::Runtime;
using network::Tensor;
using network::WeightFile;

// What the experts have in common: 7×7 stem, max pooling with ceil mode, layers 1 to 4 (strides 1, 2, 1, 1,
// dilations 1, 1, 2, 4), but for the last bottleneck. Stride 8 in all.
struct Trunk {
    Convolution stem;
    std::vector<std::vector<network::ResidualBlock>> layers;
    Tensor forward(const Tensor& image, const Runtime& runtime) const; // [2048, 41, 41]
};

// The last bottleneck and the sum of four 3×3 classifiers with dilations 6, 12, 18, 24 (atrous spatial
// pyramid).
struct Expert {
    network::ResidualBlock bottleneck;
    std::vector<Convolution> classifiers;
    Tensor forward(const Tensor& shared, const Runtime& runtime) const; // scores [parts, 41, 41]
};

struct Scale {
    Trunk trunk;
    std::vector<Expert> experts;
};

// 3×3 and 3×3, both stride 2, dilation 2, padding 1; 9×9; linear. On the scores of the parts.
struct PoseHead {
    std::vector<Convolution> convs;
    network::Linear linear;
    Tensor forward(const Tensor& scores, const Runtime& runtime) const; // logits [8]
};

// What the experts share of an image.
struct Shared {
    std::vector<Tensor> scales; // features of each scale, [2048, 41, 41] for the first
    Tensor router;              // probabilities of the experts; empty without a router
};

struct Result {
    Tensor router; // as above
    int expert = 0;
    std::vector<Tensor> scales; // scores of each scale, resized to those of the first
    Tensor scores;              // their element-wise maximum
    Tensor pose;                // logits
};

struct Network {
    std::vector<Scale> scales;             // 1, 3/4, 1/2
    std::optional<network::Linear> router; // on the mean of the shared features of the first scale
    std::vector<PoseHead> pose;            // one per expert

    // image: [3, height, width], grey values 0 … 255 three times, as the authors feed a sketch.
    Shared encode(const Tensor& image, const Runtime& runtime) const;
    // But for the router's probabilities. Error(weights) when the pose head does not fit the scores' size.
    Result decode(const Shared& shared, int expert, const Runtime& runtime) const;
    // Both. expert −1: the router decides (Error(weights) without one).
    Result forward(const Tensor& image, const Runtime& runtime, int expert = -1) const;
};

// (size − 1)·share + 1, rounded: 241 and 161 for 321.
int scaled_size(int size, double share);

// Throws Error(weights) naming the file and the fact.
Network load_network(const WeightFile& file);

} // namespace pantin::sketch_parse
