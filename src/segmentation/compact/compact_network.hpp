// SPDX-License-Identifier: MIT
// The compact segmentation network: a two-level network in the manner of SketchParse (Sarvadevabhatla et al.
// 2017, thesis Fig. 4.8): a stem shared by all drawings, a router that chooses one of several experts, an
// expert that labels the parts, and a head that estimates the direction in which the character faces. Where
// it departs from theirs: the stem is four small residual stages (He et al. 2016) instead of a ResNet-101,
// and the expert is a decoder with skip connections (Ronneberger et al. 2015), so that thin limbs survive.
//
// One struct per module; `forward` follows the figure. Widths come from the weight file's metadata, tensor
// names are the module names. Shapes in comments are for the input of 256×256 and the widths 20, 40, 80, 112.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "network/residual.hpp"
#include "segmentation/segmentation_network.hpp"

namespace pantin::compact {

using network::ResidualBlock;
using network::Runtime;
using network::Tensor;
using network::WeightFile;

// relu(norm(conv(x)))
struct Block {
    network::Convolution conv;
    Tensor forward(const Tensor& x, const Runtime& runtime) const { return conv.forward(x, runtime); }
};

// What the stages of the stem see, from fine to coarse.
struct Features {
    std::vector<Tensor> stages; // [20, 128, 128], [40, 64, 64], [80, 32, 32], [112, 16, 16]
};

struct Stem {
    std::vector<Block> down;        // each halves the resolution
    std::vector<ResidualBlock> res; // one after each
    Features forward(const Tensor& ink, const Runtime& runtime) const;
};

struct Router {
    network::Linear linear;                                                 // 224 → experts
    Tensor forward(const Features& features, const Runtime& runtime) const; // probabilities, [experts, 1, 1]
};

struct PoseHead {
    Block conv;                                                             // 112 → 64, 8×8
    network::Linear linear;                                                 // 64 → 8
    Tensor forward(const Features& features, const Runtime& runtime) const; // probabilities, [8, 1, 1]
};

// Of mean and maximum of what a block sees.
struct PooledHead {
    Block conv;                                                             // 112 → 64, 8×8
    network::Linear linear;                                                 // 128 → 4
    Tensor forward(const Features& features, const Runtime& runtime) const; // probabilities, [4, 1, 1]
};

struct Expert {
    // From coarse to fine: a block on the doubled map and the stem's stage, and what refines it.
    struct Stage {
        Block up;
        std::vector<ResidualBlock> refine;
    };
    std::vector<ResidualBlock> context; // dilated: sees the whole drawing
    std::vector<Stage> decoder;
    network::TransposedConvolution logits;                                  // [6, 256, 256]
    Tensor forward(const Features& features, const Runtime& runtime) const; // probabilities
};

struct Network : segmentation::SegmentationNetwork {
    Stem stem;
    std::optional<Router> router;
    std::optional<PoseHead> pose;
    // How the character moves (type_names), and how many quarter turns clockwise bring it upright; older
    // files have none of these two.
    std::optional<PooledHead> type, turn;
    std::vector<Expert> experts;

    std::unique_ptr<segmentation::EncodedInput> encode(const Tensor& ink,
                                                       const Runtime& runtime) const override;
};

// Error(weights) naming the file and the fact.
std::unique_ptr<segmentation::SegmentationNetwork> load_network(const WeightFile& file);

} // namespace pantin::compact
