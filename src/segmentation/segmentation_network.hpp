// SPDX-License-Identifier: MIT
// Internal: what the step needs of a segmentation network, whatever its architecture; views (views.hpp),
// router and silhouette do not care which it is. The metadata of the weight file chooses
// (segmentation_networks.cpp).
//
// The shape is SketchParse's (Sarvadevabhatla et al. 2017; thesis 4.3, Fig. 4.8): what all drawings share, a
// router that chooses one of several experts, the expert's parts, and the direction of the character.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pantin/network.hpp"

namespace pantin::segmentation {

using network::Runtime;
using network::Tensor;
using network::WeightFile;

// What one expert says of one input.
struct Answer {
    Tensor pose;  // probabilities [1, 8, 1, 1], in the order of pose_names
    Tensor parts; // probabilities [1, label_count, input, input], in the order of label_names
};

// An input of which the network has computed what its experts share, so that another expert costs no more
// than itself. Refers to the network.
class EncodedInput {
public:
    virtual ~EncodedInput() = default;
    // Error(weights) when layers do not fit this input.
    virtual Answer decode(int expert, const Runtime& runtime) const = 0;

    Tensor router; // probabilities of the experts, [1, experts, 1, 1]
    Tensor type;   // probabilities [1, 4, 1, 1], in the order of type_names; empty without a type head
    Tensor turn; // probabilities of the quarter turns clockwise that bring it upright, [1, 4, 1, 1]; or empty
};

struct NetworkResult {
    Tensor router, type, pose, parts; // as above
    int expert = 0;                   // the most probable one; the first among equals
    double confidence = 0;            // of several views (views.hpp)
};

class SegmentationNetwork {
public:
    virtual ~SegmentationNetwork() = default;
    // ink: [1, 1, input, input], 0 background, 1 ink. Error(weights) when layers do not fit this input.
    virtual std::unique_ptr<EncodedInput> encode(const Tensor& ink, const Runtime& runtime) const = 0;

    // One pass. expert −1: the router decides.
    NetworkResult forward(const Tensor& ink, const Runtime& runtime, int expert = -1) const;

    int input = 0; // side of the square input in pixels
    std::vector<std::string> expert_names;
};

// The expert; the first among equals.
int most_probable(const Tensor& router);

// The network of the architecture that the file's metadata `model` names; without it the compact one.
// Error(weights) names the file and the fact.
std::unique_ptr<SegmentationNetwork> load_segmentation_network(const WeightFile& file);

} // namespace pantin::segmentation
