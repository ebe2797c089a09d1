// SPDX-License-Identifier: MIT
// From a weight file to the network of its architecture. Another network is a row here and a file of its own
// that implements SegmentationNetwork.
#include <algorithm>

#include "segmentation/compact/compact_network.hpp"
#include "segmentation/sketch_parse/sketch_parse_network.hpp"

namespace pantin::segmentation {
namespace {

struct Architecture {
    const char* model; // metadata of the file
    std::unique_ptr<SegmentationNetwork> (*load)(const WeightFile&);
};
constexpr Architecture architectures[] = {
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
    return {std::move(encoded->router), std::move(answer.pose), std::move(answer.parts), expert};
}

std::unique_ptr<SegmentationNetwork> load_segmentation_network(const WeightFile& file) {
    if (!file.has_metadata("model")) return architectures[0].load(file);
    const std::string& model = file.metadata("model");
    std::string known;
    for (const Architecture& architecture : architectures) {
        if (model == architecture.model) return architecture.load(file);
        known += (known.empty() ? "" : ", ") + std::string(architecture.model);
    }
    file.fail("metadata 'model' is '" + model + "', which is no segmentation network (" + known + ")");
}

} // namespace pantin::segmentation
