// SPDX-License-Identifier: MIT
// Which network a weight file makes, and SketchParse as a network of the pipeline, on the small ones with
// random weights.
#include <catch2/catch.hpp>

#include <cmath>

#include "core/file.hpp"
#include "core/random.hpp"
#include "pantin/label.hpp"
#include "segmentation/sketch_parse/sketch_parse.hpp"
#include "segmentation/views.hpp"
#include "support/tensors.hpp"
#include "support/weight_files.hpp"

namespace pantin::segmentation {
namespace {

using Bytes = std::vector<unsigned char>;
using Names = std::vector<std::string>;

const Bytes& compact_weights() {
    static const Bytes bytes = read_file("testdata/segmenter_tiny.safetensors");
    return bytes;
}
const Bytes& sketch_parse_weights() {
    static const Bytes bytes = read_file("testdata/sketch_parse_tiny.safetensors");
    return bytes;
}
std::unique_ptr<SegmentationNetwork> loaded(const Bytes& bytes) {
    return load_segmentation_network(WeightFile(bytes, "w"));
}
std::string failure(const Bytes& bytes) {
    return failure_of([&] { loaded(bytes); });
}
std::string failure(const std::string& from, const std::string& to) {
    return failure(with_header(sketch_parse_weights(), from, to));
}

Tensor random_ink(int side) {
    Random random(7);
    Tensor ink(1, 1, side, side);
    for (float& value : ink) value = random.chance(0.2) ? static_cast<float>(random.uniform()) : 0.0f;
    return ink;
}

// Softmax over the channels of one pixel.
std::vector<double> softmax_at(const Tensor& scores, int y, int x) {
    std::vector<double> values;
    double sum = 0;
    for (int c = 0; c < scores.channels(); ++c) {
        values.push_back(std::exp(static_cast<double>(scores(0, c, y, x))));
        sum += values.back();
    }
    for (double& value : values) value /= sum;
    return values;
}

} // namespace

TEST_CASE("The metadata of the weight file chooses the segmentation network") {
    CHECK(loaded(compact_weights())->expert_names == Names{"ground", "winged"});
    CHECK(loaded(sketch_parse_weights())->expert_names == Names{"land", "air"});
    CHECK(loaded(sketch_parse_weights())->input == 97);
    const auto silent = loaded(with_header(compact_weights(), "\"model\":\"pantin.segmenter\",", ""));
    CHECK(silent->expert_names == Names{"ground", "winged"});
    CHECK(failure(with_header(compact_weights(), "pantin.segmenter", "unet")) ==
          "w: metadata 'model' is 'unet', which is no segmentation network (pantin.segmenter, "
          "pantin.sketch_parse)");
    CHECK(failure("pantin.sketch_parse", "pantin.mask_rcnn") ==
          "w: metadata 'model' is 'pantin.mask_rcnn', which is no segmentation network (pantin.segmenter, "
          "pantin.sketch_parse)");
}

TEST_CASE("SketchParse in the pipeline: black on white, its scores as probabilities of our labels") {
    const auto net = loaded(sketch_parse_weights());
    const sketch_parse::Network modules = sketch_parse::load_network(WeightFile(sketch_parse_weights(), "w"));
    const Tensor ink = random_ink(net->input);
    Tensor image(1, 3, net->input, net->input);
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < ink.size(); ++i) image.plane(0, c)[i] = 255 * (1 - ink.data()[i]);
    // The labels of the channels and the order of the directions, as the metadata says them.
    const std::vector<std::vector<int>> labels = {{0, 1, 2, 3, 4, 5}, {0, 2, 1, 3, 5}};
    const int poses[] = {2, 4, 3, 1, 6, 0, 7, 5}; // N, W, NW, NE, S, E, SE, SW
    for (const int expert : {0, 1}) {
        CAPTURE(expert);
        const NetworkResult result = net->forward(ink, Runtime(), expert);
        const sketch_parse::Result direct = modules.forward(image, Runtime(), expert);
        CHECK(network::same_bits(result.router, direct.router));
        const Tensor scores = network::resize_corners(direct.scores, net->input, net->input);
        REQUIRE(result.parts.channels() == label_count);
        for (const int y : {0, 40, 96})
            for (const int x : {0, 31, 96}) {
                const std::vector<double> values = softmax_at(scores, y, x);
                std::vector<double> expected(label_count, 0.0);
                for (std::size_t c = 0; c < values.size(); ++c)
                    expected[static_cast<std::size_t>(labels[static_cast<std::size_t>(expert)][c])] +=
                        values[c];
                for (int l = 0; l < label_count; ++l)
                    CHECK(result.parts(0, l, y, x) ==
                          Approx(expected[static_cast<std::size_t>(l)]).margin(1e-6));
            }
        const std::vector<double> directions = softmax_at(direct.pose, 0, 0);
        for (std::size_t i = 0; i < 8; ++i)
            CHECK(result.pose(0, poses[i], 0, 0) == Approx(directions[i]).margin(1e-6));
    }
    const NetworkResult routed = net->forward(ink, Runtime());
    CHECK(routed.expert == most_probable(routed.router));
}

TEST_CASE("SketchParse without a router takes the expert that the metadata names") {
    const Bytes without = with_header(sketch_parse_weights(), "\"router.weight\"", "\"router.width\"");
    const auto net = loaded(with_header(without, "\"input\"", "\"expert\":\"air\",\"input\""));
    const Tensor ink = random_ink(net->input);
    const NetworkResult result = net->forward(ink, Runtime());
    CHECK(result.expert == 1);
    CHECK(result.router(0, 0, 0, 0) == 0);
    CHECK(result.router(0, 1, 0, 0) == 1);
    CHECK(network::same_bits(result.parts, loaded(sketch_parse_weights())->forward(ink, Runtime(), 1).parts));
}

TEST_CASE("Channels of one label add up") {
    const Tensor ink = random_ink(97);
    const NetworkResult apart = loaded(sketch_parse_weights())->forward(ink, Runtime(), 1);
    const NetworkResult together =
        loaded(with_header(sketch_parse_weights(), "background,body,head,limb,wing",
                           "background,body,limb,limb,wing"))
            ->forward(ink, Runtime(), 1);
    for (const int x : {3, 50, 90}) {
        CHECK(together.parts(0, 1, 48, x) == 0);
        CHECK(together.parts(0, 3, 48, x) ==
              Approx(apart.parts(0, 1, 48, x) + apart.parts(0, 3, 48, x)).margin(1e-6));
    }
}

TEST_CASE("Views of SketchParse: mirrored drawings get mirrored answers, the same bits everywhere") {
    const auto net = loaded(sketch_parse_weights());
    const Tensor ink = random_ink(net->input), image = network::mirrored(ink);
    const ViewOptions both{true, 0, 30};
    const NetworkResult one = segment_views(*net, ink, both, Runtime(1, network::Simd::baseline)),
                        other = segment_views(*net, image, both, Runtime());
    CHECK(one.expert == other.expert);
    CHECK(network::largest_difference(network::mirrored(one.parts), other.parts) < 1e-5);
    CHECK(one.pose(0, 0, 0, 0) == Approx(other.pose(0, 4, 0, 0))); // E and W
    for (const int threads : {1, 3}) {
        const NetworkResult again = segment_views(*net, ink, both, Runtime(threads));
        CHECK(network::same_bits(again.parts, one.parts));
        CHECK(network::same_bits(again.pose, one.pose));
    }
}

TEST_CASE("SketchParse whose metadata does not fit is refused with the fact") {
    CHECK(failure(sketch_parse_weights()).empty());
    CHECK(failure("\"experts\":\"land,air\"", "\"names\":\"\"") == "w: metadata 'experts' is missing");
    CHECK(failure("land,air", "land") == "w: metadata 'experts' needs 2 names");
    CHECK(failure("tail,wing;background", "tail,wing,background") ==
          "w: metadata 'parts' needs 2 lists, one for each expert, separated by semicolons");
    CHECK(failure("head,limb,wing", "head,limb") ==
          "w: metadata 'parts' needs 5 labels, background among them, for expert 1");
    CHECK(failure("background,body,head", "wing,body,head") ==
          "w: metadata 'parts' needs 5 labels, background among them, for expert 1");
    CHECK(failure("head,limb,wing", "head,wheel,wing") == "w: metadata 'parts' has the unknown name 'wheel'");
    CHECK(failure("\"input\":\"97\"", "\"input\":\"0\"") ==
          "w: metadata 'input' has the impossible value '0'");
    CHECK(failure("\"input\":\"97\"", "\"poses\":\"N,W\"") ==
          "w: metadata 'poses' needs all eight directions");
    CHECK(failure("\"input\":\"97\"", "\"poses\":\"N,N\"") == "w: metadata 'poses' has 'N' twice");
    CHECK(failure("\"router.weight\"", "\"router.width\"") ==
          "w: neither tensor 'router.weight' nor metadata 'expert' chooses between the experts");
    CHECK(failure("\"input\":\"97\"", "\"expert\":\"sea\"") ==
          "w: metadata 'expert' has the unknown name 'sea'");
    // Without `input` it is the authors' 321, which this small pose head does not fit.
    const auto large = loaded(with_header(sketch_parse_weights(), "\"input\":\"97\",", ""));
    CHECK(large->input == 321);
    CHECK_THROWS_AS(large->forward(random_ink(321), Runtime(), 0), Error);
}

} // namespace pantin::segmentation
