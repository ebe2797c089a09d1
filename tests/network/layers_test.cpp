// SPDX-License-Identifier: MIT
// The layers without weights against their definitions.
#include <catch2/catch.hpp>

#include <cmath>

#include "network/naive_layers.hpp"
#include "pantin/error.hpp"
#include "support/tensors.hpp"

namespace pantin::network {

TEST_CASE("Pooling takes the maximum and the mean of the taps inside the image") {
    Tensor image(1, 1, 3, 3);
    for (int i = 0; i < 9; ++i) image.data()[i] = static_cast<float>(i) - 10;
    const Tensor largest = max_pool(image, 3, 2, 1);
    REQUIRE(largest.width() == 2);
    CHECK(largest(0, 0, 0, 0) == -6);
    CHECK(largest(0, 0, 1, 1) == -2);
    const Tensor mean = average_pool(image, 2, 1, 0);
    CHECK(mean(0, 0, 0, 0) == -8);
    CHECK(average_pool(image, 3, 2, 1)(0, 0, 0, 0) == -8); // 4 taps, not 9
    CHECK(global_average_pool(image)(0, 0, 0, 0) == -6);
    CHECK(global_max_pool(image)(0, 0, 0, 0) == -2);
    CHECK_THROWS_AS(max_pool(image, 5, 1, 0), Error);
    CHECK_THROWS_AS(max_pool(image, 2, 1, 2), Error);
}

TEST_CASE("Bilinear resizing equals its definition bit for bit") {
    Random random(3);
    for (int round = 0; round < 30; ++round) {
        const int from_height = random.integer(1, 12), from_width = random.integer(1, 12);
        const Tensor image = random_tensor(random, 1, 2, from_height, from_width);
        const int height = random.integer(1, 30), width = random.integer(1, 30);
        INFO(image.height() << "×" << image.width() << " to " << height << "×" << width);
        const Tensor expected = naive::resize_bilinear(image, height, width);
        CHECK(resize_bilinear(image, height, width, Runtime(1)) == expected);
        CHECK(resize_bilinear(image, height, width, Runtime(3)) == expected);
    }
}

TEST_CASE("Bilinear doubling weighs neighbours by three quarters and one quarter") {
    Tensor image(1, 1, 1, 2);
    image(0, 0, 0, 1) = 8;
    const Tensor doubled = resize_bilinear(image, 2, 4, Runtime());
    const float expected[] = {0, 2, 6, 8};
    for (int x = 0; x < 4; ++x) {
        CHECK(doubled(0, 0, 0, x) == expected[x]);
        CHECK(doubled(0, 0, 1, x) == expected[x]);
    }
}

TEST_CASE("Nearest resizing repeats pixels") {
    Tensor image(1, 1, 1, 2);
    image(0, 0, 0, 1) = 1;
    const Tensor wide = resize_nearest(image, 2, 5);
    const float expected[] = {0, 0, 0, 1, 1};
    for (int x = 0; x < 5; ++x) CHECK(wide(0, 0, 1, x) == expected[x]);
    Tensor sum(1, 1, 2, 5, 3.0f);
    add_nearest(sum, image);
    for (int x = 0; x < 5; ++x) CHECK(sum(0, 0, 1, x) == 3 + expected[x]);
}

TEST_CASE("Softmax sums to one, keeps the order and survives large logits") {
    Tensor logits(1, 3, 1, 2);
    logits(0, 0, 0, 0) = 1000, logits(0, 1, 0, 0) = 999, logits(0, 2, 0, 0) = -1000;
    const Tensor p = softmax(logits, Runtime(2));
    CHECK(p(0, 0, 0, 0) == Approx(1 / (1 + std::exp(-1.0))));
    CHECK(p(0, 1, 0, 0) == Approx(1 / (1 + std::exp(1.0))));
    CHECK(p(0, 2, 0, 0) == 0);
    CHECK(p(0, 0, 0, 1) == Approx(1.0 / 3));
}

TEST_CASE("Joining and adding keep every plane in its place") {
    Random random(4);
    Tensor a = random_tensor(random, 2, 1, 2, 3);
    const Tensor b = random_tensor(random, 2, 2, 2, 3), joined = concatenate(a, b);
    for (int n = 0; n < 2; ++n)
        for (int x = 0; x < 3; ++x) {
            CHECK(joined(n, 0, 1, x) == a(n, 0, 1, x));
            CHECK(joined(n, 2, 0, x) == b(n, 1, 0, x));
        }
    CHECK_THROWS_AS(add(a, b), Error);
    Tensor sum = a;
    add_relu(sum, a);
    Tensor positive = a;
    add(positive, a);
    relu(positive);
    CHECK(sum == positive);
    CHECK(*std::min_element(sum.begin(), sum.end()) >= 0);
}

} // namespace pantin::network
