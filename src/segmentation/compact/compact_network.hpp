// SPDX-License-Identifier: MIT
// The compact segmentation network: a two-level network in the manner of SketchParse (Sarvadevabhatla et al.
// 2017, thesis Fig. 4.8): a stem shared by all drawings, a router that chooses one of several experts, an
// expert that labels the parts, and a head that estimates the direction in which the character faces. Where
// it departs from theirs: the stem is four small residual stages (He et al. 2016) instead of a ResNet-101,
// and the expert is a decoder with skip connections (Ronneberger et al. 2015), so that thin limbs survive.
//
// One struct per module; `forward` follows the figure. Arithmetic is that of the weight file
// (network/arithmetic.hpp). Widths come from the weight file's metadata, tensor names are the module names.
// Shapes in comments are for the input of 256×256 and the widths 20, 40, 80, 112.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "network/residual.hpp"
#include "segmentation/segmentation_network.hpp"

namespace pantin::compact {

using network::Runtime;
using network::Tensor;
using network::WeightFile;

// relu(norm(conv(x)))
template <class Arithmetic> struct Block {
    typename Arithmetic::Convolution conv;
    typename Arithmetic::Map forward(const typename Arithmetic::Map& x, const Runtime& runtime) const {
        return conv.forward(x, runtime);
    }
};

// What the stages of the stem see, from fine to coarse.
template <class Arithmetic> struct Features {
    std::vector<typename Arithmetic::Map> stages; // [20, 128, 128], [40, 64, 64], [80, 32, 32], [112, 16, 16]
};

template <class Arithmetic> struct Stem {
    std::vector<Block<Arithmetic>> down;                      // each halves the resolution
    std::vector<network::BasicResidualBlock<Arithmetic>> res; // one after each
    Features<Arithmetic> forward(const Tensor& ink, const Runtime& runtime) const;
};

// The heads' results are probabilities, [outputs, 1, 1].
template <class Arithmetic> struct Router {
    network::Linear linear; // 224 → experts
    Tensor forward(const Features<Arithmetic>& features, const Runtime& runtime) const;
};

template <class Arithmetic> struct PoseHead {
    Block<Arithmetic> conv; // 112 → 64, 8×8
    network::Linear linear; // 64 → 8
    Tensor forward(const Features<Arithmetic>& features, const Runtime& runtime) const;
};

// Of mean and maximum of what a block sees.
template <class Arithmetic> struct PooledHead {
    Block<Arithmetic> conv; // 112 → 64, 8×8
    network::Linear linear; // 128 → 4
    Tensor forward(const Features<Arithmetic>& features, const Runtime& runtime) const;
};

template <class Arithmetic> struct Expert {
    using Residual = network::BasicResidualBlock<Arithmetic>;
    // From coarse to fine: a block on the doubled map and the stem's stage, and what refines it.
    struct Stage {
        Block<Arithmetic> up;
        std::vector<Residual> refine;
    };
    std::vector<Residual> context; // dilated: sees the whole drawing
    std::vector<Stage> decoder;
    typename Arithmetic::TransposedConvolution logits;                                  // [6, 256, 256]
    Tensor forward(const Features<Arithmetic>& features, const Runtime& runtime) const; // probabilities
};

template <class Arithmetic> struct Network : segmentation::SegmentationNetwork {
    Stem<Arithmetic> stem;
    std::optional<Router<Arithmetic>> router;
    std::optional<PoseHead<Arithmetic>> pose;
    // How the character moves (type_names), and how many quarter turns clockwise bring it upright; older
    // files have none of these two.
    std::optional<PooledHead<Arithmetic>> type, turn;
    std::vector<Expert<Arithmetic>> experts;

    std::unique_ptr<segmentation::EncodedInput> encode(const Tensor& ink,
                                                       const Runtime& runtime) const override;
};
extern template struct Network<network::RealArithmetic>;
extern template struct Network<network::IntegerArithmetic>;

// Error(weights) naming the file and the fact.
std::unique_ptr<segmentation::SegmentationNetwork> load_network(const WeightFile& file);

} // namespace pantin::compact
