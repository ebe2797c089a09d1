// SPDX-License-Identifier: MIT
// Layers on bytes against plain loops over their definition, on every instruction set and several thread
// counts, and what the loader refuses.
#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "network/integer/layers.hpp"
#include "network/naive_layers.hpp"
#include "pantin/error.hpp"
#include "support/tensors.hpp"

namespace pantin::network::integer {
namespace {

ByteTensor random_bytes(Random& random, int batch, int channels, int height, int width) {
    ByteTensor bytes = ByteTensor::uninitialised(batch, channels, height, width);
    for (std::uint32_t& word : bytes.words) {
        word = 0;
        for (int k = 0; k < 4; ++k)
            word = word << 8 | static_cast<std::uint32_t>(random.chance(0.2) ? 255 : random.integer(0, 255));
    }
    return bytes;
}

// Extreme weights among them. The rescaling brings most results into 0 … 255 and cuts some at each end.
Filters random_filters(Random& random, int out, int in, int height, int width, bool real) {
    Filters filters;
    filters.out = out, filters.in = in, filters.height = height, filters.width = width;
    const int terms = in * height * width;
    for (int i = 0; i < out * terms; ++i) {
        const int weight = random.chance(0.2) ? 63 : random.integer(0, 63);
        filters.weights.push_back(static_cast<std::int8_t>(random.chance(0.5) ? -weight : weight));
    }
    filters.zero = static_cast<std::uint8_t>(random.integer(0, 255));
    Rescaling& rescaling = filters.rescaling;
    rescaling.shift = random.integer(real ? 12 : 24, real ? 30 : 44);
    const double unit = std::ldexp(1.0, rescaling.shift);
    const double spread = 200 / std::sqrt(terms * 64.0 * 64 * 20 * 20);
    for (int o = 0; o < out; ++o) {
        const double factor = std::min(random.uniform(0.2, 1) * spread * unit, 2e9);
        rescaling.multiplier.push_back(static_cast<std::int32_t>(factor));
        rescaling.offset.push_back(static_cast<std::int64_t>(random.uniform(-100, 300) * unit));
    }
    return filters;
}

// Byte of the padded input.
int byte_at(const ByteTensor& input, int n, int c, int y, int x, int zero) {
    if (y < 0 || x < 0 || y >= input.height() || x >= input.width()) return zero;
    return input.byte(n, c, static_cast<std::size_t>(y) * input.width() + x);
}

std::int64_t scaled(const Filters& filters, int o, std::int64_t sum, int added) {
    const Rescaling& r = filters.rescaling;
    return (sum * r.multiplier[static_cast<std::size_t>(o)] + std::int64_t{added} * r.residual +
            r.offset[static_cast<std::size_t>(o)]) >>
           r.shift;
}

std::int64_t naive_sum(const ByteTensor& input, const Filters& filters, const ConvolutionOptions& options,
                       int n, int o, int y, int x) {
    std::int64_t sum = 0;
    std::size_t i = static_cast<std::size_t>(o) * filters.in * filters.height * filters.width;
    for (int c = 0; c < filters.in; ++c)
        for (int ky = 0; ky < filters.height; ++ky)
            for (int kx = 0; kx < filters.width; ++kx)
                sum += filters.weights[i++] *
                       byte_at(input, n, c, y * options.stride - options.padding + ky * options.dilation,
                               x * options.stride - options.padding + kx * options.dilation, filters.zero);
    return sum;
}

int cut(std::int64_t value) { return static_cast<int>(std::clamp<std::int64_t>(value, 0, 255)); }

template <class Check> void everywhere(const Check& check) {
    for (const Simd simd : all_simd) {
        if (!simd_supported(simd)) continue;
        for (const int threads : {1, 3}) {
            INFO(name_of(simd) << ", " << threads << " threads");
            check(Runtime(threads, simd));
        }
    }
}

std::string failure(const Filters& filters) { return fault_of(filters); }

} // namespace

TEST_CASE("Convolutions of bytes of odd shapes equal the plain loops on every instruction set") {
    Random random(11);
    for (int round = 0; round < 60; ++round) {
        ConvolutionOptions options;
        options.stride = random.integer(1, 3);
        options.dilation = random.integer(1, 3);
        options.padding = random.integer(0, 4);
        const int in = random.integer(1, 11), out = random.integer(1, 13), batch = random.integer(1, 2);
        const int kernel_height = random.integer(1, 5), kernel_width = random.integer(1, 6);
        const int least = options.dilation * 5 + 1;
        const ByteTensor input =
            random_bytes(random, batch, in, least + random.integer(0, 12), least + random.integer(0, 30));
        const bool adds = random.chance(0.5), is_real = !adds && random.chance(0.3);
        Filters filters = random_filters(random, out, in, kernel_height, kernel_width, is_real);
        if (adds) filters.rescaling.residual = random.integer(1, 1 << std::min(30, filters.rescaling.shift));
        REQUIRE(fault_of(filters) == "");
        const Convolution layer(filters, options);
        const auto extent = [&](int size, int kernel) {
            return (size + 2 * options.padding - options.dilation * (kernel - 1) - 1) / options.stride + 1;
        };
        const int height = extent(input.height(), kernel_height), width = extent(input.width(), kernel_width);
        const ByteTensor added = random_bytes(random, batch, out, height, width);
        INFO("round " << round << ": " << out << "×" << in << "×" << kernel_height << "×" << kernel_width
                      << ", stride " << options.stride << ", dilation " << options.dilation << ", padding "
                      << options.padding);
        int inside = 0, wrong = 0;
        everywhere([&](const Runtime& runtime) {
            const Tensor real = is_real ? layer.forward_real(input, runtime) : Tensor();
            const ByteTensor bytes = is_real ? ByteTensor()
                                     : adds  ? layer.forward_and_add(input, added, runtime)
                                             : layer.forward(input, runtime);
            for (int n = 0; n < batch; ++n)
                for (int o = 0; o < out; ++o)
                    for (int y = 0; y < height; ++y)
                        for (int x = 0; x < width; ++x) {
                            const std::size_t place = static_cast<std::size_t>(y) * width + x;
                            const std::int64_t value =
                                scaled(filters, o, naive_sum(input, filters, options, n, o, y, x),
                                       adds ? added.byte(n, o, place) : 0);
                            inside += value > 0 && value < 255;
                            wrong += is_real ? real(n, o, y, x) != static_cast<float>(value) / 65536
                                             : bytes.byte(n, o, place) != cut(value);
                        }
        });
        CHECK(wrong == 0);
        if (!is_real && height * width > 20) CHECK(inside > 0);
    }
}

TEST_CASE("Transposed convolutions of bytes paint each pixel as a square") {
    Random random(12);
    for (int round = 0; round < 20; ++round) {
        ConvolutionOptions options;
        options.stride = random.integer(1, 3);
        const int s = options.stride, in = random.integer(1, 9), out = random.integer(1, 9);
        const ByteTensor input =
            random_bytes(random, random.integer(1, 2), in, random.integer(1, 9), random.integer(1, 40));
        Filters filters = random_filters(random, out, in, s, s, false);
        REQUIRE(fault_of(filters, true) == "");
        const TransposedConvolution layer(filters, options);
        int wrong = 0;
        everywhere([&](const Runtime& runtime) {
            const ByteTensor bytes = layer.forward(input, runtime);
            const Tensor real = layer.forward_real(input, runtime);
            REQUIRE(bytes.height() == s * input.height());
            REQUIRE(real.width() == s * input.width());
            for (int n = 0; n < input.batch(); ++n)
                for (int o = 0; o < out; ++o)
                    for (int y = 0; y < bytes.height(); ++y)
                        for (int x = 0; x < bytes.width(); ++x) {
                            std::int64_t sum = 0;
                            for (int c = 0; c < in; ++c)
                                sum += filters.weights[static_cast<std::size_t>(
                                           ((c * out + o) * s + y % s) * s + x % s)] *
                                       byte_at(input, n, c, y / s, x / s, 0);
                            const std::int64_t value = scaled(filters, o, sum, 0);
                            wrong += bytes.byte(n, o, static_cast<std::size_t>(y) * bytes.width() + x) !=
                                     cut(value);
                            wrong += real(n, o, y, x) != static_cast<float>(value) / 65536;
                        }
        });
        CHECK(wrong == 0);
    }
}

TEST_CASE("Linear layers of bytes take their inputs by channel, row and column") {
    Random random(13);
    for (int round = 0; round < 20; ++round) {
        const int channels = random.integer(1, 10), height = random.integer(1, 4),
                  width = random.integer(1, 4);
        const int in = channels * height * width, out = random.integer(1, 20);
        const ByteTensor input = random_bytes(random, random.integer(1, 70), channels, height, width);
        const Filters filters = random_filters(random, out, in, 1, 1, false);
        const Linear layer(filters, height * width);
        int wrong = 0;
        everywhere([&](const Runtime& runtime) {
            const ByteTensor bytes = layer.forward(input, runtime);
            const Tensor real = layer.forward_real(input, runtime);
            for (int n = 0; n < input.batch(); ++n)
                for (int o = 0; o < out; ++o) {
                    std::int64_t sum = 0;
                    for (int i = 0; i < in; ++i)
                        sum += filters.weights[static_cast<std::size_t>(o) * in + i] *
                               input.byte(n, i / (height * width),
                                          static_cast<std::size_t>(i % (height * width)));
                    const std::int64_t value = scaled(filters, o, sum, 0);
                    wrong += bytes.byte(n, o, 0) != cut(value);
                    wrong += real(n, o, 0, 0) != static_cast<float>(value) / 65536;
                }
        });
        CHECK(wrong == 0);
    }
}

TEST_CASE("Doubled bytes are the bilinear values, rounded") {
    Random random(14);
    for (int round = 0; round < 20; ++round) {
        const int channels = random.integer(1, 9), height = random.integer(1, 9),
                  width = random.integer(1, 9);
        const ByteTensor input = random_bytes(random, 1, channels, height, width);
        Tensor values(1, channels, height, width);
        for (int c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < values.plane_size(); ++i) values.plane(0, c)[i] = input.byte(0, c, i);
        const Tensor expected = naive::resize_bilinear(values, 2 * height, 2 * width); // exact: sixteenths
        const ByteTensor result = doubled(input);
        int wrong = 0;
        for (int c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < expected.plane_size(); ++i)
                wrong += result.byte(0, c, i) != static_cast<int>(std::floor(expected.plane(0, c)[i] + 0.5f));
        CHECK(wrong == 0);
    }
}

TEST_CASE("Pooled bytes are those of the real layers") {
    Random random(15);
    for (int round = 0; round < 20; ++round) {
        const int channels = random.integer(1, 9), height = random.integer(3, 9),
                  width = random.integer(3, 20);
        const ByteTensor input = random_bytes(random, 2, channels, height, width);
        Tensor values(2, channels, height, width);
        for (int n = 0; n < 2; ++n)
            for (int c = 0; c < channels; ++c)
                for (std::size_t i = 0; i < values.plane_size(); ++i)
                    values.plane(n, c)[i] = input.byte(n, c, i);
        CHECK(same_bits(global_max_pool(input), network::global_max_pool(values)));
        CHECK(same_bits(global_average_pool(input), network::global_average_pool(values)));
        const Tensor expected = network::max_pool(values, 3, 2, 1);
        const ByteTensor pooled = max_pool(input, 3, 2, 1);
        REQUIRE(pooled.plane_size() == expected.plane_size());
        int wrong = 0;
        for (int n = 0; n < 2; ++n)
            for (int c = 0; c < channels; ++c)
                for (std::size_t i = 0; i < expected.plane_size(); ++i)
                    wrong += pooled.byte(n, c, i) != expected.plane(n, c)[i];
        CHECK(wrong == 0);
    }
}

TEST_CASE("Joined bytes are one after the other, whatever the channels") {
    Random random(16);
    for (int first = 1; first <= 9; ++first)
        for (int second = 1; second <= 9; ++second) {
            const ByteTensor a = random_bytes(random, 2, first, 2, 3),
                             b = random_bytes(random, 2, second, 2, 3);
            const ByteTensor joined = concatenate(a, b);
            REQUIRE(joined.channels == first + second);
            int wrong = 0;
            for (int n = 0; n < 2; ++n)
                for (int c = 0; c < joined.channels; ++c)
                    for (std::size_t i = 0; i < 6; ++i)
                        wrong +=
                            joined.byte(n, c, i) != (c < first ? a.byte(n, c, i) : b.byte(n, c - first, i));
            CHECK(wrong == 0);
        }
    CHECK_THROWS_AS(concatenate(random_bytes(random, 1, 4, 2, 3), random_bytes(random, 1, 4, 3, 2)), Error);
}

TEST_CASE("Filters whose numbers could overflow are refused") {
    Filters good;
    good.out = 2, good.in = 1;
    good.weights = {63, -63};
    good.rescaling = {{1 << 30, 1 << 30}, {0, -5}, 31, 0};
    CHECK(failure(good) == "");
    const auto with = [&](const auto& change) {
        Filters filters = good;
        change(filters);
        return failure(filters);
    };
    CHECK(with([](Filters& f) { f.weights[1] = 64; }) == "a weight beyond 63");
    CHECK(with([](Filters& f) { f.weights[1] = -128; }) == "a weight beyond 63");
    CHECK(with([](Filters& f) { f.weights.pop_back(); }) == "weights that do not fit its shape");
    CHECK(with([](Filters& f) { f.rescaling.offset.pop_back(); }) == "weights that do not fit its shape");
    CHECK(with([](Filters& f) { f.rescaling.shift = 63; }) == "a shift outside 1 to 62");
    CHECK(with([](Filters& f) { f.rescaling.shift = 0; }) == "a shift outside 1 to 62");
    CHECK(with([](Filters& f) { f.rescaling.multiplier[0] = -1; }) == "a negative factor");
    CHECK(with([](Filters& f) { f.rescaling.residual = -1; }) == "a negative factor");
    CHECK(with([](Filters& f) { f.rescaling.offset[1] = std::int64_t{1} << 62; }) ==
          "a rescaling that could overflow");
    CHECK(with([](Filters& f) { f.rescaling.offset[1] = std::numeric_limits<std::int64_t>::min(); }) ==
          "a rescaling that could overflow");
    CHECK(with([](Filters& f) { f.rescaling.shift = 8; }) == "a rescaling that could overflow");
    // 255·63·133674 < 2³¹ ≤ 255·63·133675
    const auto wide = [&](int in) {
        return with([&](Filters& f) {
            f.in = in;
            f.weights.assign(2 * static_cast<std::size_t>(in), 63);
            f.rescaling.multiplier = {1, 1};
        });
    };
    CHECK(wide(133674) == "");
    CHECK(wide(133675) == "sums that could overflow");
}

TEST_CASE("The largest sums are exact on every instruction set") {
    Filters filters;
    filters.out = 4, filters.in = 4000;
    for (int o = 0; o < 4; ++o)
        for (int i = 0; i < 4000; ++i) filters.weights.push_back(static_cast<std::int8_t>(o % 2 ? -63 : 63));
    filters.rescaling = {{1 << 30, 1 << 30, (1 << 30) - 1, 1}, {0, 0, 1, -1}, 30, 0};
    REQUIRE(fault_of(filters) == "");
    ByteTensor input = ByteTensor::uninitialised(1, 4000, 1, 40);
    std::fill(input.words.begin(), input.words.end(), ~std::uint32_t{0});
    const Convolution layer(filters, {});
    const std::int64_t sum = 4000LL * 63 * 255;
    everywhere([&](const Runtime& runtime) {
        const Tensor real = layer.forward_real(input, runtime);
        CHECK(real(0, 0, 0, 39) == static_cast<float>(sum) / 65536);
        CHECK(real(0, 1, 0, 0) == static_cast<float>(-sum) / 65536);
        CHECK(layer.forward(input, runtime).byte(0, 0, 20) == 255);
        CHECK(layer.forward(input, runtime).byte(0, 1, 20) == 0);
    });
}

} // namespace pantin::network::integer
