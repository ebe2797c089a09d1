// SPDX-License-Identifier: MIT
// Mask R-CNN on integers against an independent pass in exact arithmetic, byte for byte, on a small one with
// random weights (tools/train/quantize.py --fixture).
#include <catch2/catch.hpp>

#include <cmath>

#include "compare_torch/trace.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "detection/mask_rcnn/mask_rcnn.hpp"
#include "support/bytes.hpp"
#include "support/tensors.hpp"
#include "support/weight_files.hpp"

namespace pantin::mask_rcnn {
namespace {

using Bytes = std::vector<unsigned char>;
using Integers = BasicNetwork<network::IntegerArithmetic>;
using network::integer::ByteTensor;
using network::integer::wrong_bytes;

const Bytes& weights() {
    static const Bytes bytes = read_file("testdata/mask_rcnn_tiny_integer.safetensors");
    return bytes;
}
const WeightFile& trace() {
    static const Bytes bytes = read_file("testdata/mask_rcnn_tiny_integer_trace.safetensors");
    static const WeightFile file(bytes, "trace");
    return file;
}
Tensor tensor(const std::string& name) { return compare::read_tensor(trace(), name); }

std::vector<Region> regions_of(const Tensor& boxes) {
    std::vector<Region> regions;
    for (int i = 0; i < boxes.batch(); ++i)
        regions.push_back({boxes(i, 0, 0, 0), boxes(i, 1, 0, 0), boxes(i, 2, 0, 0), boxes(i, 3, 0, 0)});
    return regions;
}

} // namespace

TEST_CASE("Every module of the integer Mask R-CNN has the numbers of exact arithmetic") {
    const Integers net = load_network<network::IntegerArithmetic>(WeightFile(weights(), "weights"));
    const Transformed input = transform(tensor("image"), net.options.transform, Runtime());
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        INFO(name_of(simd));
        const Runtime runtime(2, simd);
        const std::vector<ByteTensor> stages =
            net.backbone.forward(network::integer::to_bytes(tensor("transformed")), runtime);
        for (std::size_t i = 0; i < stages.size(); ++i)
            CHECK(wrong_bytes(trace(), "stage" + std::to_string(i), stages[i]) == 0);
        const std::vector<ByteTensor> levels = net.pyramid.forward(stages, runtime);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const std::string number = std::to_string(i);
            CHECK(wrong_bytes(trace(), "level" + number, levels[i]) == 0);
            const Objectness seen = net.proposal_head.forward(levels[i], runtime);
            CHECK(network::same_bits(seen.logits, tensor("objectness" + number)));
            CHECK(network::same_bits(seen.displacements, tensor("displacements" + number)));
        }
        // A mean of bytes that lies at a half may be rounded to the other side.
        const DetectionOptions& heads = net.options.detection;
        const ByteTensor pooled = pool_regions(levels, regions_of(tensor("proposals")), heads.box_pool,
                                               net.box_head.fc6.zero(), input.size, heads, runtime);
        CHECK(wrong_bytes(trace(), "box_pooled", pooled) <= static_cast<int>(pooled.words.size()) / 500);
    }
}

TEST_CASE("The integer Mask R-CNN finds what exact arithmetic finds, with the same bits everywhere") {
    const Integers net = load_network<network::IntegerArithmetic>(WeightFile(weights(), "weights"));
    const std::vector<Detection> first = net.forward(tensor("image"), Runtime(1, network::Simd::baseline));
    const Tensor boxes = tensor("boxes");
    REQUIRE(static_cast<int>(first.size()) == boxes.batch());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Region& box = first[i].box;
        const float sides[] = {box.left, box.top, box.right, box.bottom};
        for (int k = 0; k < 4; ++k)
            CHECK(sides[k] == Approx(boxes(static_cast<int>(i), k, 0, 0)).margin(0.05));
    }
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        const std::vector<Detection> other = net.forward(tensor("image"), Runtime(3, simd));
        REQUIRE(other.size() == first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            CHECK(other[i].box == first[i].box);
            CHECK(other[i].score == first[i].score);
            CHECK(other[i].mask == first[i].mask);
        }
    }
}

TEST_CASE("RoIAlign of bytes is that of their numbers, rounded") {
    Random random(5);
    for (int k = 0; k < 50; ++k) {
        const int channels = random.integer(1, 9), zero = random.integer(0, 255);
        ByteTensor bytes = ByteTensor::uninitialised(1, channels, 9, 13);
        for (std::uint32_t& word : bytes.words) {
            word = 0;
            for (int b = 0; b < 4; ++b) word = word << 8 | static_cast<std::uint32_t>(random.integer(0, 255));
        }
        Tensor values(1, channels, 9, 13);
        for (int c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < values.plane_size(); ++i)
                values.plane(0, c)[i] = static_cast<float>(bytes.byte(0, c, i) - zero);
        const double x = random.uniform(-9, 60), y = random.uniform(-9, 40);
        const Region region{static_cast<float>(x), static_cast<float>(y),
                            static_cast<float>(x + random.uniform(0, 60)),
                            static_cast<float>(y + random.uniform(0, 60))};
        Tensor pooled(1, channels, 4, 4);
        network::roi_align(values, {region}, {0}, 0.25f, 2, Runtime(1), pooled);
        ByteTensor result = ByteTensor::uninitialised(1, channels, 4, 4);
        network::roi_align(bytes, {region}, {0}, 0.25f, 2, static_cast<std::uint8_t>(zero), Runtime(1),
                           result);
        for (int c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < 16; ++i)
                CHECK(std::abs(result.byte(0, c, i) - (pooled.plane(0, c)[i] + static_cast<float>(zero))) <=
                      0.5001);
    }
}

TEST_CASE("An integer detector that does not fit is refused by name") {
    const auto failure = [](const Bytes& bytes) {
        return failure_of([&] { load_network<network::IntegerArithmetic>(WeightFile(bytes, "w")); });
    };
    CHECK(failure(with_text(weights(), "\"backbone.fpn.inner_blocks.0.0.residual\"",
                            "\"backbone.fpn.inner_blocks.0.0.residuum\"")) ==
          "w: tensor 'backbone.fpn.inner_blocks.0.0.residual' is missing");
    CHECK(failure(with_text(weights(), "\"arithmetic\":\"integer\"", "\"arithmetik\":\"integer\"")) ==
          "w: the layers are of another arithmetic");
    CHECK(failure_of([] { load_network(WeightFile(weights(), "w")); }) ==
          "w: the layers are of another arithmetic");
}

} // namespace pantin::mask_rcnn
