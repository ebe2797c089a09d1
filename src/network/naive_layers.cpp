// SPDX-License-Identifier: MIT
// Each layer by its definition in PyTorch's documentation, one loop an index: the oracle of the tests.
#include "network/naive_layers.hpp"

#include <algorithm>
#include <cmath>

namespace pantin::network::naive {
namespace {

float pixel_or_zero(const Tensor& image, int n, int c, int y, int x) {
    const bool inside = y >= 0 && x >= 0 && y < image.height() && x < image.width();
    return inside ? image(n, c, y, x) : 0.0f;
}

float activate(float value, bool relu) { return relu && !(value > 0) ? 0.0f : value; }

} // namespace

Tensor convolution(const Tensor& input, const Filters& f, const ConvolutionOptions& o) {
    const int height = (input.height() + 2 * o.padding - o.dilation * (f.height - 1) - 1) / o.stride + 1;
    const int width = (input.width() + 2 * o.padding - o.dilation * (f.width - 1) - 1) / o.stride + 1;
    const int in = f.in / o.groups, out = f.out / o.groups; // per group
    Tensor result(input.batch(), f.out, height, width);
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < f.out; ++c)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    float acc = f.bias[c];
                    const float* weight =
                        f.weights.data() + static_cast<std::size_t>(c) * in * f.height * f.width;
                    for (int i = 0; i < in; ++i)
                        for (int ky = 0; ky < f.height; ++ky)
                            for (int kx = 0; kx < f.width; ++kx)
                                acc = std::fma(*weight++,
                                               pixel_or_zero(input, n, c / out * in + i,
                                                             y * o.stride + ky * o.dilation - o.padding,
                                                             x * o.stride + kx * o.dilation - o.padding),
                                               acc);
                    result(n, c, y, x) = activate(acc, o.relu);
                }
    return result;
}

Tensor transposed_convolution(const Tensor& input, const Filters& f, const ConvolutionOptions& o) {
    const auto extent = [&](int size, int kernel) {
        return std::max(0, (size - 1) * o.stride - 2 * o.padding + o.dilation * (kernel - 1) +
                               o.output_padding + 1);
    };
    Tensor result(input.batch(), f.out, extent(input.height(), f.height), extent(input.width(), f.width));
    const int in = f.in / o.groups, out = f.out / o.groups;
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < f.out; ++c)
            for (int y = 0; y < result.height(); ++y)
                for (int x = 0; x < result.width(); ++x) {
                    float acc = f.bias[c];
                    for (int i = c / out * in; i < (c / out + 1) * in; ++i)
                        for (int ky = 0; ky < f.height; ++ky)
                            for (int kx = 0; kx < f.width; ++kx) {
                                const int row = y + o.padding - ky * o.dilation,
                                          column = x + o.padding - kx * o.dilation;
                                if (row % o.stride != 0 || column % o.stride != 0) continue;
                                const std::size_t filter = static_cast<std::size_t>(i) * out + c % out;
                                acc = std::fma(f.weights[(filter * f.height + ky) * f.width + kx],
                                               pixel_or_zero(input, n, i, row / o.stride, column / o.stride),
                                               acc);
                            }
                    result(n, c, y, x) = activate(acc, o.relu);
                }
    return result;
}

Tensor linear(const Tensor& input, int out, const std::vector<float>& weights,
              const std::vector<float>& bias) {
    const std::size_t in = static_cast<std::size_t>(input.channels()) * input.plane_size();
    Tensor result(input.batch(), out, 1, 1);
    for (int n = 0; n < input.batch(); ++n)
        for (int o = 0; o < out; ++o) {
            float acc = bias[o];
            for (std::size_t i = 0; i < in; ++i)
                acc = std::fma(weights[o * in + i], input.plane(n, 0)[i], acc);
            result(n, o, 0, 0) = acc;
        }
    return result;
}

Tensor resize_bilinear(const Tensor& input, int height, int width) {
    Tensor result(input.batch(), input.channels(), height, width);
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    // Pixel centres at + ½; places before the first centre are clamped to it.
                    const float sy =
                        std::max(0.0f, (static_cast<float>(y) + 0.5f) * (static_cast<float>(input.height()) /
                                                                         static_cast<float>(height)) -
                                           0.5f);
                    const float sx =
                        std::max(0.0f, (static_cast<float>(x) + 0.5f) * (static_cast<float>(input.width()) /
                                                                         static_cast<float>(width)) -
                                           0.5f);
                    const int y0 = std::min(static_cast<int>(sy), input.height() - 1),
                              y1 = std::min(y0 + 1, input.height() - 1);
                    const int x0 = std::min(static_cast<int>(sx), input.width() - 1),
                              x1 = std::min(x0 + 1, input.width() - 1);
                    const float fy = sy - static_cast<float>(y0), fx = sx - static_cast<float>(x0);
                    const float top = input(n, c, y0, x0) * (1 - fx) + input(n, c, y0, x1) * fx;
                    const float bottom = input(n, c, y1, x0) * (1 - fx) + input(n, c, y1, x1) * fx;
                    result(n, c, y, x) = top * (1 - fy) + bottom * fy;
                }
    return result;
}

} // namespace pantin::network::naive
