// SPDX-License-Identifier: MIT
// Activations of the integer networks: bytes, four neighbouring channels in one word.
#pragma once

#include <cstdint>

#include "pantin/network.hpp"

namespace pantin::network::integer {

// [batch][word][row][column]; byte c % 4 (from the lowest) of word c / 4 is channel c. Bytes of the last word
// that are no channel have weights of 0. A byte q stands for the real number s·(q − z); s and z of the tensor
// are in the integers of the layers before and after it alone.
struct ByteTensor {
    int channels = 0;
    BasicTensor<std::uint32_t> words;

    static ByteTensor uninitialised(int batch, int channels, int height, int width) {
        return {channels,
                BasicTensor<std::uint32_t>::uninitialised(batch, (channels + 3) / 4, height, width)};
    }
    int batch() const { return words.batch(); }
    int height() const { return words.height(); }
    int width() const { return words.width(); }
    std::size_t plane_size() const { return words.plane_size(); }
    // A channel's byte. Indices are not checked.
    std::uint8_t byte(int n, int c, std::size_t place) const {
        return static_cast<std::uint8_t>(words.plane(n, c / 4)[place] >> (8 * (c % 4)));
    }
};

// ⌊255·x + ½⌋ of each value, cut to 0 … 255: the input of a network, real numbers from 0 to 1.
ByteTensor to_bytes(const Tensor& input);

// --- layers without weights: the bytes of the result are exact ------------------------------------------

// As network::max_pool, with the maximum of the bytes.
ByteTensor max_pool(const ByteTensor& input, int kernel, int stride, int padding);
// As network::resize_nearest.
ByteTensor resize_nearest(const ByteTensor& input, int height, int width);
// To twice the size: (9a + 3b + 3c + d + 8) >> 4 of the four nearest pixels, a the nearest; at the border the
// pixels outside are those on it. What network::resize_bilinear does, rounded.
ByteTensor doubled(const ByteTensor& input);
// The channels of a, then those of b. Error(weights) when the sizes differ.
ByteTensor concatenate(const ByteTensor& a, const ByteTensor& b);
// Means and maxima of the bytes, [n][c][1][1]. Error(weights) when the image is empty.
Tensor global_average_pool(const ByteTensor& input);
Tensor global_max_pool(const ByteTensor& input);

} // namespace pantin::network::integer
