// SPDX-License-Identifier: MIT
// The network kernel: the plain loops that define a convolution beside the vectorised one on every
// instruction set.
#include <cstdio>

#include "bench.hpp"
#include "core/random.hpp"
#include "network/naive_layers.hpp"
#include "pantin/network.hpp"

namespace pantin::bench {

namespace {

network::Tensor random_tensor(int channels, int side, Random& random) {
    network::Tensor tensor(1, channels, side, side);
    for (float& value : tensor) value = static_cast<float>(random.normal());
    return tensor;
}

network::Filters random_filters(int out, int in, Random& random) {
    network::Filters filters{out, in, 3, 3, {}, {}};
    for (int i = 0; i < out * in * 9; ++i) filters.weights.push_back(static_cast<float>(random.normal()));
    for (int i = 0; i < out; ++i) filters.bias.push_back(static_cast<float>(random.normal()));
    return filters;
}

// Beside what the arithmetic units could do at most.
void bench_throughput(int rounds, Random& random) {
    constexpr int channels = 64, side = 128;
    const network::Tensor input = random_tensor(channels, side, random);
    network::ConvolutionOptions options;
    options.padding = 1;
    const network::Convolution convolution(random_filters(channels, channels, random), options);
    std::printf("\nconvolution 3x3, %d to %d channels, %dx%d, one thread\n", channels, channels, side, side);
    for (const network::Simd simd : {network::Simd::avx2, network::Simd::avx512}) {
        if (!network::simd_supported(simd)) continue;
        const network::Runtime runtime(1, simd);
        const double time = least_time([&] { convolution.forward(input, runtime); }, 10 * rounds);
        const double speed = 2e-6 * static_cast<double>(convolution.operations(side, side)) / time;
        const double peak = fma_peak(simd);
        std::printf("  %-10s %8.1f GFLOP/s, %.0f %% of the %.1f GFLOP/s of registers alone\n",
                    std::string(network::name_of(simd)).c_str(), speed, 100 * speed / peak, peak);
    }
}

} // namespace

void bench_kernel(int rounds) {
    Random random(1);
    constexpr int channels = 40, side = 64;
    const network::Tensor input = random_tensor(channels, side, random);
    const network::Filters filters = random_filters(channels, channels, random);
    network::ConvolutionOptions options;
    options.padding = 1;
    const network::Convolution convolution(filters, options);
    std::vector<Contender> contenders = {
        {"plain loops", [&] { network::naive::convolution(input, filters, options); }}};
    for (const network::Simd simd : network::all_simd) {
        if (!network::simd_supported(simd)) continue;
        contenders.push_back({std::string(network::name_of(simd)),
                              [&, simd] { convolution.forward(input, network::Runtime(1, simd)); }});
    }
    char title[120];
    std::snprintf(title, sizeof title,
                  "convolution 3x3, %d to %d channels, %dx%d, %.0f million multiply-adds", channels, channels,
                  side, side, static_cast<double>(convolution.operations(side, side)) / 1e6);
    compare(title, contenders, rounds);
    bench_throughput(rounds, random);
}

} // namespace pantin::bench
