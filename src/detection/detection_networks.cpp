// SPDX-License-Identifier: MIT
// From a weight file to the network of its architecture. Another network is a row here and a file of its own
// that implements DetectionNetwork.
#include "detection/detection_network.hpp"
#include "detection/mask_rcnn/mask_rcnn_detector.hpp"
#include "network/architecture.hpp"

namespace pantin::detection {
namespace {

constexpr network::Architecture<DetectionNetwork> architectures[] = {
    // The compact and the full-size one: widths and depths are the file's. Also when the file does not say.
    {"pantin.mask_rcnn", mask_rcnn::load_detection_network},
};

} // namespace

std::unique_ptr<DetectionNetwork> load_detection_network(const network::WeightFile& file) {
    return network::load_network(file, architectures, "detection network");
}

} // namespace pantin::detection
