// SPDX-License-Identifier: MIT
// SketchParse: module by module against a pass of PyTorch on a small network (tools/compare_torch.py), and
// weight files that do not fit.
#include <catch2/catch.hpp>

#include "compare_torch/trace.hpp"
#include "core/file.hpp"
#include "segmentation/sketch_parse/sketch_parse.hpp"
#include "support/tensors.hpp"
#include "support/weight_files.hpp"

namespace pantin::sketch_parse {
namespace {

using Bytes = std::vector<unsigned char>;

const Bytes& weights() {
    static const Bytes bytes = read_file("testdata/sketch_parse_tiny.safetensors");
    return bytes;
}

std::string failure(const Bytes& bytes) {
    return failure_of([&] { load_network(WeightFile(bytes, "w")); });
}

} // namespace

TEST_CASE("Every module of SketchParse computes what PyTorch's computes") {
    const Bytes bytes = read_file("testdata/sketch_parse_tiny_trace.safetensors");
    const std::vector<compare::Difference> differences =
        compare::compare_sketch_parse(WeightFile(weights(), "weights"), WeightFile(bytes, "trace"), 2);
    CHECK(differences.size() == 12);
    for (const compare::Difference& d : differences) {
        INFO(d.what << " " << d.shape << ": absolute " << d.absolute << ", relative " << d.relative);
        CHECK(d.agrees());
    }
}

TEST_CASE("SketchParse takes the named expert, and its fused scores are the largest of the scales") {
    const Bytes bytes = read_file("testdata/sketch_parse_tiny_trace.safetensors");
    const Tensor image = compare::read_tensor(WeightFile(bytes, "trace"), "image");
    const Network net = load_network(WeightFile(weights(), "weights"));
    REQUIRE(net.scales.size() == 3);
    REQUIRE(net.pose.size() == 2);
    const int parts[] = {6, 5};
    for (const int expert : {0, 1}) {
        const Result result = net.forward(image, Runtime(1), expert);
        CHECK(result.expert == expert);
        CHECK(result.scores.channels() == parts[expert]);
        CHECK(result.pose.channels() == 8);
        REQUIRE(result.scales.size() == 3);
        for (std::size_t i = 0; i < result.scores.size(); ++i)
            CHECK(result.scores.data()[i] == std::max({result.scales[0].data()[i], result.scales[1].data()[i],
                                                       result.scales[2].data()[i]}));
        const Result again = net.forward(image, Runtime(3, network::Simd::baseline), expert);
        CHECK(network::same_bits(again.scores, result.scores));
    }
}

TEST_CASE("The three scales of an input of 321 are the authors'") {
    CHECK(scaled_size(321, 1) == 321);
    CHECK(scaled_size(321, 0.75) == 241);
    CHECK(scaled_size(321, 0.5) == 161);
}

TEST_CASE("A SketchParse weight file that does not fit is refused with the fact") {
    CHECK(failure(weights()).empty());
    CHECK(failure(with_text(weights(), "Scale1.conv1.weight", "Scale1.conv7.weight")) ==
          "w: tensor 'Scale1.conv1.weight' is missing");
    CHECK(failure(with_text(weights(), "Scale2.layer4_5_r1.0.conv1.weight",
                            "Scale2.layer4_5_r7.0.conv1.weight")) == "w: the scales have different experts");
    CHECK(failure(with_text(weights(), "pose_r1.PoseC2.0.weight", "pose_r1.PoseC2.9.weight")) ==
          "w: tensor 'pose_r1.PoseC2.0.weight' is missing");
    CHECK(failure(Bytes(weights().begin(), weights().end() - 1)).rfind("w: ", 0) == 0);
}

} // namespace pantin::sketch_parse
