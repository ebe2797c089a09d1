// SPDX-License-Identifier: MIT
// From a weight file to the network of its architecture. Another network is a row here and a file of its own
// that implements DetectionNetwork.
#include "detection/detection_network.hpp"
#include "detection/mask_rcnn/mask_rcnn_detector.hpp"

namespace pantin::detection {
namespace {

struct Architecture {
    const char* model; // metadata of the file
    std::unique_ptr<DetectionNetwork> (*load)(const network::WeightFile&);
};
constexpr Architecture architectures[] = {
    // The compact and the full-size one: widths and depths are the file's. Also when the file does not say.
    {"pantin.mask_rcnn", mask_rcnn::load_detection_network},
};

} // namespace

std::unique_ptr<DetectionNetwork> load_detection_network(const network::WeightFile& file) {
    if (!file.has_metadata("model")) return architectures[0].load(file);
    const std::string& model = file.metadata("model");
    std::string known;
    for (const Architecture& architecture : architectures) {
        if (model == architecture.model) return architecture.load(file);
        known += (known.empty() ? "" : ", ") + std::string(architecture.model);
    }
    file.fail("metadata 'model' is '" + model + "', which is no detection network (" + known + ")");
}

} // namespace pantin::detection
