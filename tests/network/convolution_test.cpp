// SPDX-License-Identifier: MIT
// Convolution, transposed convolution and linear layers against their plain loops, bit for bit, on every
// instruction set and several thread counts; and against values worked out by hand.
#include <catch2/catch.hpp>

#include <cmath>

#include "network/naive_layers.hpp"
#include "pantin/error.hpp"
#include "support/tensors.hpp"

namespace pantin::network {
namespace {

// The layer's result on every supported instruction set with 1 and 3 threads equals `expected`.
template <class Layer>
void check_everywhere(const Layer& layer, const Tensor& input, const Tensor& expected) {
    for (const Simd simd : all_simd) {
        if (!simd_supported(simd)) continue;
        for (const int threads : {1, 3}) {
            const Runtime runtime(threads, simd);
            INFO(name_of(simd) << ", " << threads << " threads");
            CHECK(same_bits(layer.forward(input, runtime), expected));
        }
    }
}

} // namespace

TEST_CASE("A 3×3 convolution of a small image has the values worked out by hand") {
    Filters filters;
    filters.out = filters.in = 1;
    filters.height = filters.width = 3;
    filters.weights = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    filters.bias = {10};
    Tensor image(1, 1, 2, 2);
    image(0, 0, 0, 0) = 1, image(0, 0, 0, 1) = 2, image(0, 0, 1, 0) = 3, image(0, 0, 1, 1) = 4;
    ConvolutionOptions options;
    options.padding = 1;
    const Tensor result = Convolution(filters, options).forward(image, Runtime());
    REQUIRE(result.height() == 2);
    CHECK(result(0, 0, 0, 0) == 10 + 5 * 1 + 6 * 2 + 8 * 3 + 9 * 4);
    CHECK(result(0, 0, 0, 1) == 10 + 4 * 1 + 5 * 2 + 7 * 3 + 8 * 4);
    CHECK(result(0, 0, 1, 0) == 10 + 2 * 1 + 3 * 2 + 5 * 3 + 6 * 4);
    CHECK(result(0, 0, 1, 1) == 10 + 1 * 1 + 2 * 2 + 4 * 3 + 5 * 4);
}

TEST_CASE("A transposed 2×2 convolution of stride 2 paints each pixel as a scaled filter") {
    Filters filters;
    filters.out = filters.in = 1;
    filters.height = filters.width = 2;
    filters.weights = {1, 2, 3, 4};
    filters.bias = {0.5f};
    Tensor image(1, 1, 1, 2);
    image(0, 0, 0, 0) = 1, image(0, 0, 0, 1) = 10;
    ConvolutionOptions options;
    options.stride = 2;
    const Tensor result = TransposedConvolution(filters, options).forward(image, Runtime());
    REQUIRE(result.width() == 4);
    REQUIRE(result.height() == 2);
    const float expected[2][4] = {{1.5f, 2.5f, 10.5f, 20.5f}, {3.5f, 4.5f, 30.5f, 40.5f}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) CHECK(result(0, 0, y, x) == expected[y][x]);
}

TEST_CASE("Convolutions of odd shapes equal the plain loops bit for bit on every instruction set") {
    Random random(7);
    for (int round = 0; round < 60; ++round) {
        ConvolutionOptions options;
        options.stride = random.integer(1, 3);
        options.dilation = random.integer(1, 3);
        options.padding = random.integer(0, 4);
        options.groups = random.integer(1, 3);
        options.relu = random.chance(0.5);
        const int in = options.groups * random.integer(1, 5), out = options.groups * random.integer(1, 15);
        const int kernel_height = random.integer(1, 5), kernel_width = random.integer(1, 5);
        const int least = options.dilation * 4 + 1;
        const int batch = random.integer(1, 2);
        const int height = least + random.integer(0, 12), width = least + random.integer(0, 30);
        const Tensor input = random_tensor(random, batch, in, height, width);
        const Filters filters = random_filters(random, out, in, kernel_height, kernel_width, options.groups);
        INFO("round " << round << ": " << out << "×" << in << "×" << kernel_height << "×" << kernel_width
                      << ", stride " << options.stride << ", dilation " << options.dilation << ", padding "
                      << options.padding << ", groups " << options.groups << ", image " << input.height()
                      << "×" << input.width());
        check_everywhere(Convolution(filters, options), input, naive::convolution(input, filters, options));
    }
}

TEST_CASE("Transposed convolutions of odd shapes equal the plain loops bit for bit") {
    Random random(8);
    for (int round = 0; round < 40; ++round) {
        ConvolutionOptions options;
        options.stride = random.integer(1, 3);
        options.dilation = random.integer(1, 2);
        options.padding = random.integer(0, 2);
        options.groups = random.integer(1, 2);
        options.output_padding = random.integer(0, options.stride - 1);
        const int in = options.groups * random.integer(1, 5), out = options.groups * random.integer(1, 9);
        const int kernel = random.integer(1, 4);
        const int height = random.integer(3, 9), width = random.integer(3, 20);
        const Tensor input = random_tensor(random, 1, in, height, width);
        const Filters filters = random_filters(random, out, in, kernel, kernel, options.groups);
        INFO("round " << round << ": kernel " << kernel << ", stride " << options.stride << ", dilation "
                      << options.dilation << ", padding " << options.padding);
        check_everywhere(TransposedConvolution(filters, options), input,
                         naive::transposed_convolution(input, filters, options));
    }
}

TEST_CASE("A depthwise convolution and one with wide rows equal the plain loops") {
    Random random(9);
    ConvolutionOptions depthwise;
    depthwise.groups = 7;
    depthwise.padding = 1;
    const Filters filters = random_filters(random, 7, 7, 3, 3, 7);
    const Tensor image = random_tensor(random, 1, 7, 9, 33);
    check_everywhere(Convolution(filters, depthwise), image, naive::convolution(image, filters, depthwise));

    ConvolutionOptions wide;
    wide.padding = 1;
    const Filters more = random_filters(random, 20, 4, 3, 3, 1);
    const Tensor large = random_tensor(random, 1, 4, 20, 128);
    check_everywhere(Convolution(more, wide), large, naive::convolution(large, more, wide));
}

TEST_CASE("Linear layers equal the plain loops bit for bit for any batch") {
    Random random(10);
    for (int round = 0; round < 20; ++round) {
        const int out = random.integer(1, 300), channels = random.integer(1, 30);
        const int batch = random.integer(1, 14), height = random.integer(1, 2);
        const Tensor input = random_tensor(random, batch, channels, height, 2);
        const auto in = static_cast<int>(input.channels() * input.plane_size());
        const auto weights = random_floats(random, static_cast<std::size_t>(out) * in);
        const auto bias = random_floats(random, static_cast<std::size_t>(out));
        INFO("round " << round << ": " << out << "×" << in << ", batch " << input.batch());
        check_everywhere(Linear(out, in, weights, bias), input, naive::linear(input, out, weights, bias));
    }
}

TEST_CASE("Negative zero survives in the same places in fast and plain convolution") {
    Random random(11);
    Filters filters = random_filters(random, 3, 2, 3, 3, 1);
    filters.bias = {-0.0f, 0.0f, -0.0f};
    Tensor image(1, 2, 6, 5);
    for (float& value : image) value = random.chance(0.5) ? 0.0f : -0.0f;
    ConvolutionOptions options;
    options.padding = 2;
    check_everywhere(Convolution(filters, options), image, naive::convolution(image, filters, options));
}

TEST_CASE("A folded normalisation equals convolution followed by normalisation") {
    Random random(12);
    const Filters filters = random_filters(random, 5, 3, 3, 3, 1);
    BatchNorm norm;
    norm.gamma = random_floats(random, 5);
    norm.beta = random_floats(random, 5);
    norm.mean = random_floats(random, 5);
    for (int i = 0; i < 5; ++i) norm.variance.push_back(static_cast<float>(random.uniform(0.1, 2)));
    const Tensor image = random_tensor(random, 1, 3, 8, 8);
    const Tensor plain = naive::convolution(image, filters, {});
    const Tensor folded = naive::convolution(image, fold(filters, norm), {});
    for (int c = 0; c < 5; ++c)
        for (std::size_t i = 0; i < plain.plane_size(); ++i) {
            const double expected = (plain.plane(0, c)[i] - norm.mean[c]) /
                                        std::sqrt(norm.variance[c] + norm.epsilon) * norm.gamma[c] +
                                    norm.beta[c];
            CHECK(folded.plane(0, c)[i] == Approx(expected).margin(1e-4));
        }
}

TEST_CASE("Layers whose weights do not fit are refused") {
    Filters filters;
    filters.out = 2, filters.in = 3, filters.height = filters.width = 1;
    filters.weights = {1, 2, 3, 4, 5};
    filters.bias = {0, 0};
    CHECK_THROWS_AS(Convolution(filters, {}), Error);
    filters.weights.push_back(6);
    CHECK_NOTHROW(Convolution(filters, {}));
    ConvolutionOptions grouped;
    grouped.groups = 2;
    CHECK_THROWS_AS(Convolution(filters, grouped), Error);
    CHECK_THROWS_AS(Convolution(filters, {}).forward(Tensor(1, 2, 4, 4), Runtime()), Error);
    CHECK_THROWS_AS(Linear(2, 2, {1, 2, 3}, {0, 0}), Error);
}

} // namespace pantin::network
