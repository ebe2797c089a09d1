// SPDX-License-Identifier: MIT
// Activations of the integer networks against those that tools/train/quantize.py computed with exact
// arithmetic.
#pragma once

#include <string>

#include "network/integer/byte_tensor.hpp"

namespace pantin::network::integer {

// How many bytes differ from the tensor `name` of the file, of type U8 and shape [batch, channels, height,
// width].
inline int wrong_bytes(const WeightFile& expected, const std::string& name, const ByteTensor& ours) {
    const std::vector<std::uint8_t> theirs = expected.read_integers<std::uint8_t>(
        name, {ours.batch(), ours.channels, ours.height(), ours.width()});
    int wrong = 0;
    std::size_t at = 0;
    for (int n = 0; n < ours.batch(); ++n)
        for (int c = 0; c < ours.channels; ++c)
            for (std::size_t i = 0; i < ours.plane_size(); ++i) wrong += ours.byte(n, c, i) != theirs[at++];
    return wrong;
}

} // namespace pantin::network::integer
