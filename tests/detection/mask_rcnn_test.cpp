// SPDX-License-Identifier: MIT
// Mask R-CNN: module by module against a pass of torchvision on a small network (tools/compare_torch.py), its
// region operations against brute force, and weight files that do not fit.
#include <catch2/catch.hpp>

#include <cmath>

#include "compare_torch/trace.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "detection/mask_rcnn/mask_rcnn.hpp"
#include "pantin/detection.hpp"
#include "pantin/error.hpp"
#include "pantin/image.hpp"
#include "support/weight_files.hpp"

namespace pantin::mask_rcnn {
namespace {

using Bytes = std::vector<unsigned char>;

const Bytes& weights() {
    static const Bytes bytes = read_file("testdata/mask_rcnn_tiny.safetensors");
    return bytes;
}

std::string failure(const Bytes& bytes) {
    return failure_of([&] { load_network(WeightFile(bytes, "w")); });
}

Region random_region(Random& random, double extent) {
    const double x = random.uniform(-5, extent), y = random.uniform(-5, extent);
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x + random.uniform(0, extent)),
            static_cast<float>(y + random.uniform(0, extent))};
}

// Bilinear value with the image's border continued outwards by less than a pixel, 0 beyond.
double value_at(const Tensor& image, int channel, double x, double y) {
    if (x < -1 || y < -1 || x > image.width() || y > image.height()) return 0;
    x = std::clamp(x, 0.0, image.width() - 1.0);
    y = std::clamp(y, 0.0, image.height() - 1.0);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, image.width() - 1), y1 = std::min(y0 + 1, image.height() - 1);
    return (1 - (y - y0)) *
               ((1 - (x - x0)) * image(0, channel, y0, x0) + (x - x0) * image(0, channel, y0, x1)) +
           (y - y0) * ((1 - (x - x0)) * image(0, channel, y1, x0) + (x - x0) * image(0, channel, y1, x1));
}

} // namespace

TEST_CASE("Every module of Mask R-CNN computes what torchvision's computes") {
    const Bytes bytes = read_file("testdata/mask_rcnn_tiny_trace.safetensors");
    for (const int threads : {1, 2}) {
        const std::vector<compare::Difference> differences =
            compare::compare_mask_rcnn(WeightFile(weights(), "weights"), WeightFile(bytes, "trace"), threads);
        CHECK(differences.size() == 29);
        for (const compare::Difference& d : differences) {
            INFO(d.what << " " << d.shape << ": absolute " << d.absolute << ", relative " << d.relative);
            CHECK(d.agrees());
        }
    }
}

TEST_CASE("Mask R-CNN gives the same bits for any number of threads and instruction set") {
    const Bytes bytes = read_file("testdata/mask_rcnn_tiny_trace.safetensors");
    const Tensor image = compare::read_tensor(WeightFile(bytes, "trace"), "image");
    const Network net = load_network(WeightFile(weights(), "weights"));
    const std::vector<Detection> first = net.forward(image, Runtime(1, network::Simd::baseline));
    REQUIRE(first.size() == 10);
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        const std::vector<Detection> other = net.forward(image, Runtime(3, simd));
        REQUIRE(other.size() == first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            CHECK(other[i].box == first[i].box);
            CHECK(other[i].score == first[i].score);
            CHECK(other[i].mask == first[i].mask);
        }
    }
}

TEST_CASE("RoIAlign is the mean of bilinear samples") {
    Random random(3);
    Tensor image(1, 3, 9, 13);
    for (float& value : image) value = static_cast<float>(random.uniform(-1, 1));
    for (int k = 0; k < 50; ++k) {
        const Region region = random_region(random, 60);
        const float scale = 0.25f;
        Tensor pooled(1, 3, 4, 4);
        network::roi_align(image, {region}, {0}, scale, 2, Runtime(1), pooled);
        const double x0 = region.left * scale, y0 = region.top * scale;
        const double bin_x = std::max(1.0, (region.right - region.left) * 0.25) / 4,
                     bin_y = std::max(1.0, (region.bottom - region.top) * 0.25) / 4;
        for (int c = 0; c < 3; ++c)
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    double sum = 0;
                    for (const double v : {0.25, 0.75})
                        for (const double h : {0.25, 0.75})
                            sum += value_at(image, c, x0 + (column + h) * bin_x, y0 + (row + v) * bin_y);
                    CHECK(pooled(0, c, row, column) == Approx(sum / 4).margin(2e-5));
                }
    }
}

TEST_CASE("Non-maximum suppression keeps what no better box of its group covers") {
    Random random(4);
    for (int round = 0; round < 40; ++round) {
        std::vector<Region> boxes;
        std::vector<float> scores;
        std::vector<int> groups;
        for (int i = 0; i < 40; ++i) {
            boxes.push_back(random_region(random, 20));
            scores.push_back(static_cast<float>(random.integer(0, 7))); // with ties
            groups.push_back(static_cast<int>(random.integer(0, 1)));
        }
        const std::vector<int> kept = network::non_maximum_suppression(boxes, scores, groups, 0.3f);
        std::vector<char> is_kept(boxes.size(), 0);
        for (const int i : kept) is_kept[static_cast<std::size_t>(i)] = 1;
        const auto before = [&](std::size_t a, std::size_t b) {
            return scores[a] > scores[b] || (scores[a] == scores[b] && a < b);
        };
        for (std::size_t i = 0; i + 1 < kept.size(); ++i)
            CHECK(before(static_cast<std::size_t>(kept[i]), static_cast<std::size_t>(kept[i + 1])));
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            bool covered = false;
            for (std::size_t j = 0; j < boxes.size(); ++j)
                covered |= is_kept[j] && groups[i] == groups[j] && before(j, i) &&
                           network::overlap(boxes[i], boxes[j]) > 0.3f;
            CHECK(covered == !is_kept[i]);
        }
    }
}

TEST_CASE("Anchors are torchvision's: rounded, centred on the corners of the grid") {
    const std::vector<Region> anchors = make_anchors(32, {0.5f, 1, 2}, 2, 1, 4, 8);
    REQUIRE(anchors.size() == 6);
    CHECK(anchors[0] == Region{-23, -11, 23, 11});
    CHECK(anchors[1] == Region{-16, -16, 16, 16});
    CHECK(anchors[2] == Region{-11, -23, 11, 23});
    CHECK(anchors[3] == Region{-19, -11, 27, 11});
}

TEST_CASE("The page is resized as torchvision resizes it, quirks of fp32 included") {
    const auto size = [](int width, int height) {
        TransformOptions options;
        options.mean = options.deviation = {1};
        const InputSize s = transform(Tensor(1, 1, height, width), options, Runtime(1)).size;
        return std::vector<int>{s.clip_width, s.clip_height, s.width, s.height};
    };
    CHECK(size(640, 480) == std::vector<int>{1066, 800, 1088, 800});
    CHECK(size(500, 333) == std::vector<int>{1201, 799, 1216, 800});
    CHECK(size(97, 211) == std::vector<int>{612, 1333, 640, 1344});
}

TEST_CASE("A pasted mask lies in its box and is cut at the page") {
    Detection detection{{-2, 3, 6, 11}, 1, 1, Tensor(1, 1, 28, 28, 1.0f)};
    const Grid<float> page = paste_mask(detection, 10, 12);
    CHECK(page(0, 6) == 1);
    CHECK(page(4, 9) == 1);
    CHECK(page(8, 6) == 0);
    CHECK(page(3, 0) == 0);
    double inside = 0;
    for (const float p : page) inside += p > 0.5f;
    CHECK(inside == 7 * 10); // torchvision counts both end pixels: columns −2 … 6, rows 2 … 11
}

TEST_CASE("A Mask R-CNN weight file that does not fit is refused with the fact") {
    CHECK(failure(weights()).empty());
    CHECK(failure(with_text(weights(), "backbone.body.conv1.weight", "backbone.body.conv9.weight")) ==
          "w: tensor 'backbone.body.conv1.weight' is missing");
    CHECK(failure(with_text(weights(), "\"anchor_ratios\":\"0.5,1.0,2.0\"",
                            "\"anchor_ratios\":\"0.5,1.0,-20\"")) ==
          "w: metadata 'anchor_ratios' must be positive");
    CHECK(failure(with_text(weights(), "\"anchor_ratios\":\"0.5,1.0,2.0\"",
                            "\"anchor_ratios\":\"0.5,1.00002\"")) ==
          "w: the proposal head has another number of anchors than metadata 'anchor_ratios'");
    CHECK(failure(with_text(weights(), "\"min_size\":\"96\"", "\"min_size\":\"9x\"")) ==
          "w: metadata 'min_size' is no list of numbers");
    CHECK(failure(with_text(weights(), "\"min_size\":\"96\"", "\"min_size\":\"-6\"")) ==
          "w: metadata 'min_size' has the impossible value '-6'");
    CHECK(failure(Bytes(weights().begin(), weights().end() - 1)).rfind("w: ", 0) == 0);
}

TEST_CASE("The metadata of the weight file chooses the detection network") {
    const auto refused = [](const Bytes& bytes) { return failure_of([&] { CharacterFinder(bytes, "w"); }); };
    CHECK(refused(weights()) == "");
    CHECK(refused(with_header(weights(), "\"model\":\"pantin.mask_rcnn\",", "")) == "");
    CHECK(refused(with_header(weights(), "pantin.mask_rcnn", "detr")) ==
          "w: metadata 'model' is 'detr', which is no detection network (pantin.mask_rcnn)");
    // One channel of the file's first layer cannot take three colours.
    CHECK(refused(with_header(with_header(weights(), "\"image_mean\":\"0\"", "\"image_mean\":\"0,0,0\""),
                              "\"image_std\":\"1\"", "\"image_std\":\"1,1,1\""))
              .starts_with("w: tensor 'backbone.body.conv1.weight' has shape"));
}

TEST_CASE("A finder's characters are the network's on the ink of the page") {
    RgbImage page(200, 130, Rgb8{255, 255, 255});
    for (int y = 30; y < 90; ++y)
        for (int x = 40; x < 110; ++x) page(x, y) = Rgb8{30, 30, 30};
    const CharacterFinder finder(weights(), "w");
    const auto found = finder.find(page, ink_darkness(page));
    // 160 is the file's max_size, so the page is averaged down to it.
    const Network net = load_network(WeightFile(weights(), "w"));
    const Grid<float> ink = resize(ink_darkness(page), 160, 104);
    Tensor image(1, 1, 104, 160);
    std::copy(ink.begin(), ink.end(), image.begin());
    const std::vector<Detection> direct = net.forward(image, Runtime());
    REQUIRE(found.size() == direct.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].score == direct[i].score);
        CHECK(found[i].left == direct[i].box.left * 1.25);
        CHECK(found[i].bottom == direct[i].box.bottom * 1.25);
        CHECK(std::equal(found[i].mask.begin(), found[i].mask.end(), direct[i].mask.begin()));
    }
}

} // namespace pantin::mask_rcnn
