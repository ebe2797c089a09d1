// SPDX-License-Identifier: MIT
// The residual block of He et al. 2016, whatever is in its branch.
#pragma once

#include <optional>
#include <vector>

#include "pantin/network.hpp"

namespace pantin::network {

// relu(shortcut(x) + branch(x)). The branch's last layer has no activation of its own; the shortcut is the
// identity or a 1×1 convolution.
struct ResidualBlock {
    std::vector<Convolution> branch;
    std::optional<Convolution> downsample;

    Tensor forward(const Tensor& x, const Runtime& runtime) const;
    int out_channels() const { return branch.back().out_channels(); }
};

Tensor forward(const std::vector<ResidualBlock>& blocks, const Tensor& x, const Runtime& runtime); // none: x

} // namespace pantin::network
