// SPDX-License-Identifier: MIT
// The layers as plain loops over their definition, kept as the oracle of the tests: the fast ones return the
// same bits.
#pragma once

#include "pantin/network.hpp"

namespace pantin::network::naive {

Tensor convolution(const Tensor& input, const Filters& filters, const ConvolutionOptions& options);
Tensor transposed_convolution(const Tensor& input, const Filters& filters, const ConvolutionOptions& options);
// weights [out][in], result [batch][out][1][1].
Tensor linear(const Tensor& input, int out, const std::vector<float>& weights,
              const std::vector<float>& bias);
Tensor resize_bilinear(const Tensor& input, int height, int width);

} // namespace pantin::network::naive
