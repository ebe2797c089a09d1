// SPDX-License-Identifier: MIT
// A residual block: relu(branch(x) + shortcut(x)) (He et al. 2016, Fig. 2; thesis Fig. 4.4).
#include "network/residual.hpp"

namespace pantin::network {

Tensor ResidualBlock::forward(const Tensor& x, const Runtime& runtime) const {
    Tensor y = branch[0].forward(x, runtime);
    for (std::size_t i = 1; i < branch.size(); ++i) y = branch[i].forward(y, runtime);
    if (downsample)
        add_relu(y, downsample->forward(x, runtime));
    else
        add_relu(y, x);
    return y;
}

Tensor forward(const std::vector<ResidualBlock>& blocks, const Tensor& x, const Runtime& runtime) {
    if (blocks.empty()) return x;
    Tensor y = blocks[0].forward(x, runtime);
    for (std::size_t i = 1; i < blocks.size(); ++i) y = blocks[i].forward(y, runtime);
    return y;
}

} // namespace pantin::network
