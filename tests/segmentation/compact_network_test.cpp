// SPDX-License-Identifier: MIT
// The compact network against PyTorch, on a small one with random weights (tools/train/export.py --fixture).
#include <catch2/catch.hpp>

#include <cmath>

#include "core/file.hpp"
#include "core/random.hpp"
#include "pantin/error.hpp"
#include "pantin/segmentation.hpp"
#include "segmentation/compact/compact_network.hpp"
#include "support/tensors.hpp"
#include "support/weight_files.hpp"

namespace pantin::compact {

using network::largest_difference;
using segmentation::NetworkResult;
using segmentation::SegmentationNetwork;

namespace {

using Bytes = std::vector<unsigned char>;

const Bytes& weights() {
    static const Bytes bytes = read_file("testdata/segmenter_tiny.safetensors");
    return bytes;
}
const SegmentationNetwork& tiny_network() {
    static const auto network = load_network(WeightFile(weights(), "tiny"));
    return *network;
}

Tensor tensor_of(const WeightFile& file, const std::string& name) {
    const auto shape = file.shape(name);
    const auto extent = [&](std::size_t i) { return i < shape.size() ? static_cast<int>(shape[i]) : 1; };
    Tensor tensor(extent(0), extent(1), extent(2), extent(3));
    const std::vector<float> values = file.read(name, shape);
    std::copy(values.begin(), values.end(), tensor.begin());
    return tensor;
}

Bytes with_header_text(const std::string& from, const std::string& to) {
    return with_text(weights(), from, to);
}

std::string failure(const Bytes& bytes) {
    return failure_of([&] { Segmenter(bytes, "w"); });
}

} // namespace

TEST_CASE("The segmentation network computes what PyTorch computes") {
    const Bytes bytes = read_file("testdata/segmenter_tiny_expected.safetensors");
    const WeightFile expected(bytes, "expected");
    const SegmentationNetwork& net = tiny_network();
    const Tensor ink = tensor_of(expected, "input");
    REQUIRE(ink.width() == net.input);
    for (std::size_t expert = 0; expert < net.expert_names.size(); ++expert) {
        const NetworkResult result = net.forward(ink, Runtime(), static_cast<int>(expert));
        CHECK(largest_difference(result.router, tensor_of(expected, "router")) < 1e-4);
        CHECK(largest_difference(result.pose, tensor_of(expected, "pose")) < 1e-4);
        CHECK(largest_difference(result.type, tensor_of(expected, "type")) < 1e-4);
        const Tensor parts = tensor_of(expected, "probabilities." + net.expert_names[expert]);
        CHECK(largest_difference(result.parts, parts) < 1e-4);
    }
}

TEST_CASE("The head of turns computes what PyTorch computes") {
    const Bytes bytes = read_file("testdata/segmenter_tiny_expected.safetensors");
    const WeightFile expected(bytes, "expected");
    const auto encoded = tiny_network().encode(tensor_of(expected, "input"), Runtime());
    CHECK(largest_difference(encoded->turn, tensor_of(expected, "turn")) < 1e-4);
}

TEST_CASE("The network's bits depend neither on threads nor on the instruction set") {
    const SegmentationNetwork& net = tiny_network();
    Random random(2);
    Tensor ink(1, 1, net.input, net.input);
    for (float& value : ink) value = static_cast<float>(random.uniform());
    const NetworkResult first = net.forward(ink, Runtime(1, network::Simd::baseline));
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        for (const int threads : {1, 2, 5}) {
            INFO(network::name_of(simd) << ", " << threads << " threads");
            const NetworkResult result = net.forward(ink, Runtime(threads, simd));
            CHECK(same_bits(result.router, first.router));
            CHECK(same_bits(result.pose, first.pose));
            CHECK(same_bits(result.type, first.type));
            CHECK(same_bits(result.parts, first.parts));
        }
    }
}

TEST_CASE("The router chooses the more probable expert") {
    const SegmentationNetwork& net = tiny_network();
    const NetworkResult result = net.forward(Tensor(1, 1, net.input, net.input), Runtime());
    REQUIRE(result.router.channels() == 2);
    CHECK(result.expert == (result.router(0, 1, 0, 0) > result.router(0, 0, 0, 0) ? 1 : 0));
    CHECK(result.router(0, 0, 0, 0) + result.router(0, 1, 0, 0) == Approx(1));
}

TEST_CASE("A weight file without a type head says nothing of the type") {
    const Bytes older = with_header_text("\"types\"", "\"notes\"");
    const auto network = load_network(WeightFile(older, "older"));
    const Tensor ink(1, 1, network->input, network->input);
    CHECK(network->forward(ink, Runtime()).type.size() == 0);
    CHECK(network->forward(ink, Runtime()).router.size() == 2);
    const Bytes held = with_header_text("\"turns\"", "\"notes\"");
    CHECK(load_network(WeightFile(held, "older"))->encode(ink, Runtime())->turn.size() == 0);
}

TEST_CASE("A weight file for another network is refused with the fact") {
    CHECK(failure(weights()).empty());
    CHECK(failure(with_header_text("pantin.segmenter", "pantin.detector!")) ==
          "w: metadata 'model' is 'pantin.detector!', which is no segmentation network (pantin.segmenter, "
          "pantin.sketch_parse)");
    CHECK(failure(with_header_text("head,body", "body,head")) ==
          "w: metadata 'labels' is 'background,body,head,limb,tail,wing', not "
          "'background,head,body,limb,tail,wing'");
    CHECK(failure(with_header_text("\"4,6,8,10\"", "\"4,6,8,99\"")).find("has another shape") !=
          std::string::npos);
    CHECK(failure(with_header_text("\"4,6,8,10\"", "\"4,6,8,1x\"")) ==
          "w: metadata 'widths' has the impossible value '1x'");
    CHECK(failure(with_header_text("\"4,6,8,10\"", "\"4,6,8;10\"")) ==
          "w: metadata 'widths' needs 4 numbers");
    CHECK(failure(with_header_text("\"48\"", "\"50\"")) == "w: metadata 'input' is no multiple of 16");
    CHECK(failure(with_header_text("ground,winged", "ground,finned")) ==
          "w: tensor 'experts.finned.logits.weight' is missing");
    CHECK(failure(with_header_text("quadruped,flying", "flying,quadruped")) ==
          "w: metadata 'types' is 'humanoid,flying,quadruped,other', not "
          "'humanoid,quadruped,flying,other'");
    CHECK(failure(Bytes(weights().begin(), weights().end() - 1)).rfind("w: tensor '", 0) == 0);
    CHECK(failure({}) == "w: the weight file is empty");
}

} // namespace pantin::compact
