// SPDX-License-Identifier: MIT
// Fully connected layers: the kernel with the roles turned round. The outputs take the place of the pixels,
// the samples of the batch that of the filters; the chain runs over the inputs as everywhere.
#include <algorithm>

#include "network/variant.hpp"
#include "pantin/error.hpp"

namespace pantin::network {
namespace {

// The weights lie in tiles of so many outputs, [tile][in][output of the tile], and are read in stretches of
// so many inputs: a stretch of a tile stays in the second-level cache while all samples pass by.
constexpr int tile_outputs = 256;
constexpr int stretch_inputs = 512;

// The samples as the kernel wants its filters: [block of max_rows samples][in][sample of the block].
std::vector<float> interleave(const Tensor& input, int in) {
    std::vector<float> samples(static_cast<std::size_t>(input.batch()) * in);
    for (int first = 0; first < input.batch(); first += max_rows) {
        const int rows = std::min(max_rows, input.batch() - first);
        float* block = samples.data() + static_cast<std::size_t>(first) * in;
        for (int r = 0; r < rows; ++r) {
            const float* sample = input.plane(first + r, 0);
            for (int i = 0; i < in; ++i) block[static_cast<std::size_t>(i) * rows + r] = sample[i];
        }
    }
    return samples;
}

} // namespace

Linear::Linear(int out, int in, const std::vector<float>& weights, std::vector<float> bias)
    : out_(out), in_(in), bias_(std::move(bias)) {
    if (out < 1 || in < 1 || weights.size() != static_cast<std::size_t>(out) * in ||
        bias_.size() != static_cast<std::size_t>(out))
        throw Error(ErrorKind::weights, "network: a linear layer whose weights do not fit its shape");
    const int rounded = (out + max_vector_width - 1) / max_vector_width * max_vector_width;
    tiles_.assign(static_cast<std::size_t>(rounded) * in, 0.0f);
    for (int first = 0; first < out; first += tile_outputs) {
        const int width = std::min(tile_outputs, rounded - first);
        float* tile = tiles_.data() + static_cast<std::size_t>(first) * in;
        for (int o = first; o < std::min(out, first + width); ++o)
            for (int i = 0; i < in; ++i)
                tile[static_cast<std::size_t>(i) * width + (o - first)] =
                    weights[static_cast<std::size_t>(o) * in + i];
    }
    bias_.resize(static_cast<std::size_t>(rounded), 0.0f);
}

Tensor Linear::forward(const Tensor& input, const Runtime& runtime) const {
    const std::size_t features = static_cast<std::size_t>(input.channels()) * input.plane_size();
    if (features != static_cast<std::size_t>(in_))
        throw Error(ErrorKind::weights,
                    "network: a linear layer gets another number of values than it has weights for");
    const Kernel& kernel = kernel_of(runtime.simd());
    Tensor output = Tensor::uninitialised(input.batch(), out_, 1, 1);
    const std::vector<float> samples = interleave(input, in_);

    runtime.parallel_for((out_ + tile_outputs - 1) / tile_outputs, [&](int task) {
        const int first = task * tile_outputs;
        const int width = std::min<int>(tile_outputs, static_cast<int>(bias_.size()) - first);
        const float* tile = tiles_.data() + static_cast<std::size_t>(first) * in_;
        std::vector<std::ptrdiff_t> bases;
        for (int o = 0; o < width; o += kernel.width) bases.push_back(o);
        std::vector<float> results(static_cast<std::size_t>(input.batch()) * width); // the chains, so far
        for (int n = 0; n < input.batch(); ++n)
            std::copy_n(bias_.begin() + first, width,
                        results.begin() + static_cast<std::ptrdiff_t>(n) * width);
        const std::ptrdiff_t tap = 0;
        for (int i = 0; i < in_; i += stretch_inputs)
            for (int n = 0; n < input.batch(); n += max_rows) {
                const int rows = std::min(max_rows, input.batch() - n);
                kernel.run(
                    {tile + static_cast<std::size_t>(i) * width, static_cast<std::size_t>(width),
                     std::min(stretch_inputs, in_ - i), &tap, 1,
                     samples.data() + static_cast<std::size_t>(n) * in_ + static_cast<std::size_t>(i) * rows,
                     nullptr, rows, bases.data(), static_cast<int>(bases.size()),
                     results.data() + static_cast<std::size_t>(n) * width, static_cast<std::size_t>(width),
                     false});
            }
        for (int n = 0; n < input.batch(); ++n)
            std::copy_n(results.begin() + static_cast<std::ptrdiff_t>(n) * width,
                        std::min(width, out_ - first), output.plane(n, first));
    });
    return output;
}

} // namespace pantin::network
