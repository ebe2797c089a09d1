// SPDX-License-Identifier: MIT
// The residual block of He et al. 2016, Fig. 2 (thesis Fig. 4.4), whatever is in its branch.
#pragma once

#include <optional>
#include <vector>

#include "network/arithmetic.hpp"

namespace pantin::network {

// relu(shortcut(x) + branch(x)). The branch's last layer has no activation of its own; the shortcut is the
// identity or a 1×1 convolution.
template <class Arithmetic> struct BasicResidualBlock {
    using Map = typename Arithmetic::Map;
    std::vector<typename Arithmetic::Convolution> branch;
    std::optional<typename Arithmetic::Convolution> downsample;

    Map forward(const Map& x, const Runtime& runtime) const {
        Map y;
        const Map* last = &x;
        for (std::size_t i = 0; i + 1 < branch.size(); ++i) {
            y = branch[i].forward(*last, runtime);
            last = &y;
        }
        if (downsample) return add_relu(branch.back(), *last, downsample->forward(x, runtime), runtime);
        return add_relu(branch.back(), *last, x, runtime);
    }
    int out_channels() const { return branch.back().out_channels(); }
};
using ResidualBlock = BasicResidualBlock<RealArithmetic>;

// One after the other; none: x.
template <class Arithmetic>
typename Arithmetic::Map forward(const std::vector<BasicResidualBlock<Arithmetic>>& blocks,
                                 const typename Arithmetic::Map& x, const Runtime& runtime) {
    if (blocks.empty()) return x;
    typename Arithmetic::Map y = blocks[0].forward(x, runtime);
    for (std::size_t i = 1; i < blocks.size(); ++i) y = blocks[i].forward(y, runtime);
    return y;
}

} // namespace pantin::network
