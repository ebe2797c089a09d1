// SPDX-License-Identifier: MIT
// Several views of a drawing, on the small network with random weights.
#include <catch2/catch.hpp>

#include <cmath>

#include "core/file.hpp"
#include "core/random.hpp"
#include "segmentation/views.hpp"
#include "support/tensors.hpp"

namespace pantin::segmentation {

using network::largest_difference;

namespace {

const SegmentationNetwork& tiny_network() {
    static const std::vector<unsigned char> bytes = read_file("testdata/segmenter_tiny.safetensors");
    static const auto network = load_segmentation_network(WeightFile(bytes, "tiny"));
    return *network;
}

// A thick bar of ink that lies askew in the square.
Tensor bar(int side) {
    Tensor ink(1, 1, side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            ink(0, 0, y, x) =
                std::abs(y - side / 2 - (x - side / 2) / 4) < 4 && x > 5 && x < side - 9 ? 1.0f : 0.0f;
    return ink;
}

} // namespace

TEST_CASE("A drawing and its mirror image get mirrored answers when both are viewed") {
    const SegmentationNetwork& net = tiny_network();
    Random random(5);
    Tensor ink(1, 1, net.input, net.input);
    for (float& value : ink) value = static_cast<float>(random.uniform());
    const Tensor image = network::mirrored(ink);
    CHECK(same_bits(network::mirrored(image), ink));
    CHECK(image(0, 0, 3, 1) == ink(0, 0, 3, net.input - 2));
    const ViewOptions both{true, 0, 30};
    const NetworkResult one = segment_views(net, ink, both, Runtime()),
                        other = segment_views(net, image, both, Runtime());
    CHECK(one.expert == other.expert);
    CHECK(largest_difference(network::mirrored(one.parts), other.parts) < 1e-6);
    CHECK(one.pose(0, 0, 0, 0) == Approx(other.pose(0, 4, 0, 0))); // E and W
    CHECK(one.pose(0, 2, 0, 0) == Approx(other.pose(0, 2, 0, 0))); // N
    CHECK(one.pose(0, 1, 0, 0) == Approx(other.pose(0, 3, 0, 0))); // NE and NW
    CHECK(largest_difference(net.forward(ink, Runtime(), one.expert).parts, one.parts) > 1e-3);
}

TEST_CASE("One view is the network's own answer") {
    const SegmentationNetwork& net = tiny_network();
    const Tensor ink = bar(net.input);
    const NetworkResult one = segment_views(net, ink, {}, Runtime()), plain = net.forward(ink, Runtime());
    CHECK(one.expert == plain.expert);
    CHECK(same_bits(one.parts, plain.parts));
    CHECK(same_bits(one.router, plain.router));
}

TEST_CASE("A tilted drawing fills the square, and straightening brings it back") {
    const int side = 64;
    const Tensor ink = bar(side);
    for (const double degrees : {-30.0, -20.0, 7.0, 20.0}) {
        CAPTURE(degrees);
        const Tilt tilt = tilt_of(ink, degrees);
        const Tensor view = tilted(ink, tilt);
        int left = side, right = -1, top = side, bottom = -1;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (view(0, 0, y, x) > 0.5f)
                    left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
                    bottom = std::max(bottom, y);
        CHECK(std::max(right - left, bottom - top) + 1 >= 0.9 * side);
        CHECK(left >= 0);
        CHECK(std::abs(left + right - side + 1) <= 2);
        CHECK(std::abs(top + bottom - side + 1) <= 2);
        Tensor parts(1, 2, side, side);
        for (std::size_t i = 0; i < parts.plane_size(); ++i) {
            parts.plane(0, 1)[i] = view.plane(0, 0)[i];
            parts.plane(0, 0)[i] = 1 - view.plane(0, 0)[i];
        }
        const Tensor back = straightened(parts, tilt);
        int wrong = 0;
        for (std::size_t i = 0; i < parts.plane_size(); ++i) {
            CHECK(back.plane(0, 0)[i] + back.plane(0, 1)[i] == Approx(1).margin(1e-5));
            wrong += (back.plane(0, 1)[i] > 0.5f) != (ink.plane(0, 0)[i] > 0.5f);
        }
        CHECK(wrong < 40); // of some 350 pixels of ink, at their border
    }
}

TEST_CASE("A page without ink is not tilted") {
    const Tilt tilt = tilt_of(Tensor(1, 1, 16, 16), 20);
    CHECK(tilt.cosine == 1);
    CHECK(tilt.sine == 0);
    CHECK(tilt.shift_x == 0);
}

TEST_CASE("The views' bits depend neither on threads nor on the instruction set") {
    const SegmentationNetwork& net = tiny_network();
    const ViewOptions options{true, 20, 30};
    const NetworkResult first =
        segment_views(net, bar(net.input), options, Runtime(1, network::Simd::baseline));
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        const NetworkResult result = segment_views(net, bar(net.input), options, Runtime(3, simd));
        CHECK(same_bits(result.parts, first.parts));
        CHECK(same_bits(result.pose, first.pose));
    }
}

} // namespace pantin::segmentation
