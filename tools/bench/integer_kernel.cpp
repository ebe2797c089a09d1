// SPDX-License-Identifier: MIT
// The kernel on bytes: the plain loops that define a convolution, the kernel of real numbers and that of
// bytes on every instruction set.
#include <cstdio>

#include "bench.hpp"
#include "core/random.hpp"
#include "network/integer/layers.hpp"

namespace pantin::bench {

namespace {

using network::integer::ByteTensor;

ByteTensor random_bytes(int channels, int side, Random& random) {
    ByteTensor bytes = ByteTensor::uninitialised(1, channels, side, side);
    for (std::uint32_t& word : bytes.words)
        word = static_cast<std::uint32_t>(random.integer(0, 0xffff)) << 16 |
               static_cast<std::uint32_t>(random.integer(0, 0xffff));
    return bytes;
}

network::integer::Filters random_filters(int out, int in, Random& random) {
    network::integer::Filters filters;
    filters.out = out, filters.in = in, filters.height = filters.width = 3;
    for (int i = 0; i < out * in * 9; ++i)
        filters.weights.push_back(static_cast<std::int8_t>(random.integer(-63, 63)));
    filters.rescaling.multiplier.assign(static_cast<std::size_t>(out), 1 << 20);
    filters.rescaling.offset.assign(static_cast<std::size_t>(out), std::int64_t{100} << 34);
    filters.rescaling.shift = 34;
    return filters;
}

// Σ weight·byte at every place, as the definition says.
std::int64_t plain_loops(const ByteTensor& input, const network::integer::Filters& filters) {
    std::int64_t all = 0;
    for (int o = 0; o < filters.out; ++o)
        for (int y = 0; y < input.height(); ++y)
            for (int x = 0; x < input.width(); ++x) {
                std::int32_t sum = 0;
                const std::int8_t* weight =
                    filters.weights.data() + static_cast<std::size_t>(o) * filters.in * 9;
                for (int c = 0; c < filters.in; ++c)
                    for (int ky = y - 1; ky <= y + 1; ++ky)
                        for (int kx = x - 1; kx <= x + 1; ++kx, ++weight)
                            if (ky >= 0 && kx >= 0 && ky < input.height() && kx < input.width())
                                sum += *weight *
                                       input.byte(0, c, static_cast<std::size_t>(ky) * input.width() + kx);
                all += sum;
            }
    return all;
}

} // namespace

void bench_integer_kernel(int rounds) {
    Random random(2);
    constexpr int channels = 64, side = 128;
    network::ConvolutionOptions options;
    options.padding = 1;
    const ByteTensor input = random_bytes(channels, side, random);
    const network::integer::Filters filters = random_filters(channels, channels, random);
    const network::integer::Convolution convolution(filters, options);
    const double products = 9.0 * channels * channels * side * side;
    volatile std::int64_t keep = 0;
    const double plain = least_time([&] { keep = plain_loops(input, filters); }, 1);
    std::printf("\nconvolution of bytes 3x3, %d to %d channels, %dx%d, one thread\n", channels, channels,
                side, side);
    std::printf("  %-10s %8.1f billion products/s\n", "plain loops", products / plain / 1e6);
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        const network::Runtime runtime(1, simd);
        const double time = least_time([&] { convolution.forward(input, runtime); }, 10 * rounds);
        const double speed = products / time / 1e6, peak = dot_product_peak(simd);
        std::printf("  %-10s %8.1f billion products/s", std::string(network::name_of(simd)).c_str(), speed);
        if (peak > 0) std::printf(", %.0f %% of the %.1f of registers alone", 100 * speed / peak, peak);
        std::printf("\n");
    }
}

} // namespace pantin::bench
