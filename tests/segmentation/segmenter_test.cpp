// SPDX-License-Identifier: MIT
// The whole step on small pictures.
#include <catch2/catch.hpp>

#include <algorithm>

#include "core/file.hpp"
#include "core/random.hpp"
#include "pantin/image.hpp"
#include "pantin/segmentation.hpp"

namespace pantin {
namespace {

const Segmenter& tiny() {
    static const std::vector<unsigned char> bytes = read_file("testdata/segmenter_tiny.safetensors");
    static const Segmenter segmenter(bytes, "testdata/segmenter_tiny.safetensors");
    return segmenter;
}

RgbImage random_drawing(Random& random, int width, int height) {
    RgbImage drawing(width, height, Rgb8{255, 255, 255});
    for (int i = 0; i < 6; ++i) {
        const int x = random.integer(0, width - 1), y = random.integer(0, height - 1);
        for (int j = x; j < std::min(width, x + width / 3); ++j) drawing(j, y) = Rgb8{20, 20, 30};
        for (int j = y; j < std::min(height, y + height / 3); ++j) drawing(x, j) = Rgb8{0, 0, 0};
    }
    return drawing;
}

Mask mask_with_a_hole() {
    Mask mask(90, 60);
    for (int y = 3; y < 57; ++y)
        for (int x = 5; x < 85; ++x) mask(x, y) = (x - 45) * (x - 45) + (y - 30) * (y - 30) > 60;
    return mask;
}

} // namespace

TEST_CASE("Segmentation gives a label to every silhouette pixel, probabilities of the crop and distributions "
          "that sum to 1") {
    Random random(1);
    const RgbImage drawing = random_drawing(random, 90, 60);
    Mask mask(90, 60);
    for (int y = 10; y < 50; ++y)
        for (int x = 10; x < 80; ++x) mask(x, y) = 1;
    const Segmentation result = tiny().segment(ink_of_crop(ink_darkness(drawing)), mask);
    CHECK(result.labels.width() == 90);
    CHECK(result.labels.height() == 60);
    CHECK(*std::max_element(result.labels.begin(), result.labels.end()) < label_count);
    REQUIRE(result.probabilities.size() == label_count);
    CHECK(result.probabilities[0].width() == 48);
    CHECK(result.probabilities[0].height() == 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            double sum = 0;
            for (const auto& plane : result.probabilities) sum += plane(x, y);
            CHECK(sum == Approx(1));
        }
    double routes = 0, poses = 0;
    for (const auto& [name, p] : result.router) routes += p;
    for (const double p : result.pose) poses += p;
    CHECK(routes == Approx(1));
    CHECK(poses == Approx(1));
    CHECK((result.expert == "ground" || result.expert == "winged"));
}

TEST_CASE("An exact mask is the silhouette to the pixel") {
    Random random(7);
    const RgbImage drawing = random_drawing(random, 90, 60);
    const Mask mask = mask_with_a_hole();
    const Segmentation result = tiny().segment(ink_of_crop(ink_darkness(drawing)), mask, {}, true);
    CHECK(foreground(result.labels) == mask);
}

TEST_CASE("Without refinement the detector's mask is the silhouette to the pixel, as an exact one is") {
    Random random(7);
    const RgbImage drawing = random_drawing(random, 90, 60);
    const Mask mask = mask_with_a_hole();
    const GreyImage ink = ink_of_crop(ink_darkness(drawing));
    CHECK_FALSE(foreground(tiny().segment(ink, mask).labels) == mask);
    SegmentationOptions options;
    options.refine_silhouette = false;
    const Segmentation result = tiny().segment(ink, mask, options);
    CHECK(foreground(result.labels) == mask);
    CHECK(result.labels == tiny().segment(ink, mask, {}, true).labels);
}

TEST_CASE("Segmentation is the same for any number of threads") {
    Random random(2);
    for (int round = 0; round < 5; ++round) {
        const int width = random.integer(16, 200), height = random.integer(16, 200);
        const RgbImage drawing = random_drawing(random, width, height);
        const Mask mask(width, height, 1);
        SegmentationOptions options;
        const Segmentation one = tiny().segment(ink_of_crop(ink_darkness(drawing)), mask, options);
        options.threads = 4;
        const Segmentation four = tiny().segment(ink_of_crop(ink_darkness(drawing)), mask, options);
        CHECK(one.labels == four.labels);
        CHECK(one.probabilities == four.probabilities);
        CHECK(one.pose == four.pose);
        CHECK(one.router == four.router);
    }
}

TEST_CASE("Pictures of extreme shape, all white or all black are segmented without a crash") {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {16, 16}, {257, 31}})
        for (const std::uint8_t grey : {0, 255}) {
            const RgbImage drawing(width, height, Rgb8{grey, grey, grey});
            for (const int value : {0, 1}) {
                const Mask mask(width, height, static_cast<std::uint8_t>(value));
                const Segmentation result = tiny().segment(ink_of_crop(ink_darkness(drawing)), mask);
                CHECK(result.labels.width() == width);
                CHECK(result.labels.height() == height);
            }
        }
}

TEST_CASE("The mask may be smaller than the drawing") {
    Random random(3);
    const RgbImage drawing = random_drawing(random, 300, 200);
    const Mask mask(150, 100, 1);
    const Segmentation result = tiny().segment(ink_of_crop(ink_darkness(drawing)), mask);
    CHECK(result.labels.width() == 150);
    CHECK(result.labels.height() == 100);
}

TEST_CASE("A drawing that is turned by a quarter gets the answer of the upright one, turned back") {
    Random random(3);
    const GreyImage ink = ink_of_crop(ink_darkness(random_drawing(random, 48, 48)));
    const TurnProbabilities upright = tiny().find_turn(ink);
    REQUIRE(upright);
    double sum = 0;
    for (const double p : *upright) sum += p;
    CHECK(sum == Approx(1));
    CHECK((*upright)[0] < 0.9);                                           // else one look is enough
    CHECK(*std::max_element(upright->begin(), upright->end()) > 0.25005); // it is not indifferent
    for (int k = 1; k < 4; ++k) {
        const TurnProbabilities found = tiny().find_turn(turned(ink, 90 * k));
        for (std::size_t more = 0; more < 4; ++more)
            CHECK((*found)[more] ==
                  Approx((*upright)[(more + static_cast<std::size_t>(k)) % 4]).margin(1e-7));
    }
}

} // namespace pantin
