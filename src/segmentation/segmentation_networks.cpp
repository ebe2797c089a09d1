// SPDX-License-Identifier: MIT
// From a weight file to the network of its architecture. Another network is a row here and a file of its own
// that implements SegmentationNetwork.
#include <algorithm>

#include "network/architecture.hpp"
#include "segmentation/compact/compact_network.hpp"
#include "segmentation/sketch_parse/sketch_parse_network.hpp"

namespace pantin::segmentation {
namespace {

constexpr network::Architecture<SegmentationNetwork> architectures[] = {
    {"pantin.segmenter", compact::load_network}, // also when the file does not say
    {"pantin.sketch_parse", sketch_parse::load_segmentation_network},
};

} // namespace

int most_probable(const Tensor& router) {
    return static_cast<int>(std::max_element(router.begin(), router.end()) - router.begin());
}

NetworkResult SegmentationNetwork::forward(const Tensor& ink, const Runtime& runtime, int expert) const {
    const std::unique_ptr<EncodedInput> encoded = encode(ink, runtime);
    if (expert < 0) expert = most_probable(encoded->router);
    Answer answer = encoded->decode(expert, runtime);
    return {std::move(encoded->router), std::move(encoded->type), std::move(answer.pose),
            std::move(answer.parts), expert};
}

std::unique_ptr<SegmentationNetwork> load_segmentation_network(const WeightFile& file) {
    return network::load_network(file, architectures, "segmentation network");
}

} // namespace pantin::segmentation
