// SPDX-License-Identifier: MIT
// The compact network on integers against an independent pass in exact arithmetic, byte for byte, on a small
// one with random weights (tools/train/quantize.py --fixture).
#include <catch2/catch.hpp>

#include "compare_torch/trace.hpp"
#include "core/file.hpp"
#include "pantin/error.hpp"
#include "pantin/segmentation.hpp"
#include "segmentation/compact/compact_network.hpp"
#include "support/bytes.hpp"
#include "support/tensors.hpp"
#include "support/weight_files.hpp"

namespace pantin::compact {
namespace {

using Bytes = std::vector<unsigned char>;
using Integers = Network<network::IntegerArithmetic>;
using network::integer::ByteTensor;
using network::integer::wrong_bytes;

const Bytes& weights() {
    static const Bytes bytes = read_file("testdata/segmenter_tiny_integer.safetensors");
    return bytes;
}
const WeightFile& expected() {
    static const Bytes bytes = read_file("testdata/segmenter_tiny_integer_expected.safetensors");
    static const WeightFile file(bytes, "expected");
    return file;
}
const Integers& tiny_network() {
    static const auto network = load_network(WeightFile(weights(), "tiny"));
    return dynamic_cast<const Integers&>(*network);
}

std::string failure(const Bytes& bytes) {
    return failure_of([&] { Segmenter(bytes, "w"); });
}

} // namespace

TEST_CASE("Every stage of the integer network has the bytes of exact arithmetic") {
    const Integers& net = tiny_network();
    const Tensor ink = compare::read_tensor(expected(), "input");
    CHECK(wrong_bytes(expected(), "bytes.input", network::integer::to_bytes(ink)) == 0);
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        const Runtime runtime(2, simd);
        INFO(name_of(simd));
        const auto features = net.stem.forward(ink, runtime);
        for (std::size_t i = 0; i < features.stages.size(); ++i)
            CHECK(wrong_bytes(expected(), "bytes.stem.res" + std::to_string(i + 1) + ".b.conv",
                              features.stages[i]) == 0);
        const ByteTensor& coarse = features.stages.back();
        CHECK(wrong_bytes(expected(), "bytes.pose.conv.conv", net.pose->conv.forward(coarse, runtime)) == 0);
        CHECK(wrong_bytes(expected(), "bytes.kind.conv.conv", net.type->conv.forward(coarse, runtime)) == 0);
        CHECK(wrong_bytes(expected(), "bytes.turn.conv.conv", net.turn->conv.forward(coarse, runtime)) == 0);
        for (std::size_t e = 0; e < net.experts.size(); ++e) {
            const ByteTensor context = network::forward(net.experts[e].context, coarse, runtime);
            CHECK(wrong_bytes(expected(), "bytes.experts." + net.expert_names[e] + ".context.1.b.conv",
                              context) == 0);
        }
    }
}

TEST_CASE("The integer network's probabilities are those of exact arithmetic") {
    const Integers& net = tiny_network();
    const Tensor ink = compare::read_tensor(expected(), "input");
    REQUIRE(ink.width() == net.input);
    const auto encoded = net.encode(ink, Runtime());
    const auto off = [&](const Tensor& ours, const std::string& name) {
        return network::largest_difference(ours, compare::read_tensor(expected(), name));
    };
    CHECK(off(encoded->router, "router") < 1e-5);
    CHECK(off(encoded->type, "type") < 1e-5);
    CHECK(off(encoded->turn, "turn") < 1e-5);
    for (std::size_t e = 0; e < net.expert_names.size(); ++e) {
        const segmentation::Answer answer = encoded->decode(static_cast<int>(e), Runtime());
        CHECK(off(answer.pose, "pose") < 1e-5);
        // The logits are exact: what is left is the rounding of the softmax.
        CHECK(off(answer.parts, "probabilities." + net.expert_names[e]) < 1e-6);
    }
}

TEST_CASE("An integer weight file that does not fit is refused by name") {
    CHECK(failure(with_text(weights(), "\"arithmetic\":\"integer\"", "\"arithmetic\":\"intejer\"")) ==
          "w: metadata 'arithmetic' is 'intejer', not 'integer'");
    // Read as real numbers, the layers are of the wrong type.
    CHECK(failure(with_text(weights(), "\"arithmetic\":\"integer\"", "\"arithmetik\":\"integer\"")) ==
          "w: tensor 'stem.down1.conv.weight' is I8, not F32 or F16");
    CHECK(failure(with_text(weights(), "\"stem.res1.b.conv.shift\"", "\"stem.res1.b.conv.shaft\"")) ==
          "w: tensor 'stem.res1.b.conv.shift' is missing");
    CHECK(failure(with_text(weights(), "\"stem.res1.b.conv.residual\"", "\"stem.res1.b.conv.residuum\"")) ==
          "w: tensor 'stem.res1.b.conv.residual' is missing");
    CHECK(failure(with_header(weights(), "\"experts\":\"ground,winged\"", "\"experts\":\"ground,ground\"")) ==
          "w: metadata 'experts' names one twice");
}

} // namespace pantin::compact
