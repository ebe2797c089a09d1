// SPDX-License-Identifier: MIT
// Tensors of a weight file by PyTorch's names to layers, normalisations folded in (Ioffe & Szegedy 2015).
#include "network/layer_reader.hpp"

namespace pantin::network {
namespace {

constexpr std::int64_t max_extent = 1 << 20; // of one dimension

} // namespace

int LayerReader::extent(const std::string& tensor, std::size_t rank, std::size_t dimension) const {
    const std::vector<std::int64_t> shape = file.shape(tensor);
    if (shape.size() != rank)
        file.fail("tensor '" + tensor + "' has " + std::to_string(shape.size()) + " dimensions, not " +
                  std::to_string(rank));
    const std::int64_t value = shape[dimension];
    if (value < 1 || value > max_extent)
        file.fail("tensor '" + tensor + "' has a dimension of " + std::to_string(value));
    return static_cast<int>(value);
}

Filters LayerReader::filters(const std::string& conv, int in, int groups) const {
    const std::string name = conv + ".weight";
    Filters filters;
    filters.in = in;
    filters.out = extent(name, 4, 0);
    filters.height = extent(name, 4, 2);
    filters.width = extent(name, 4, 3);
    filters.weights = file.read(name, {filters.out, in / groups, filters.height, filters.width});
    if (file.contains(conv + ".bias"))
        filters.bias = file.read(conv + ".bias", {filters.out});
    else
        filters.bias.assign(static_cast<std::size_t>(filters.out), 0.0f);
    return filters;
}

BatchNorm LayerReader::batch_norm(const std::string& norm, int channels) const {
    BatchNorm result;
    result.epsilon = epsilon;
    result.gamma = file.read(norm + ".weight", {channels});
    result.beta = file.read(norm + ".bias", {channels});
    result.mean = file.read(norm + ".running_mean", {channels});
    result.variance = file.read(norm + ".running_var", {channels});
    for (const float variance : result.variance)
        if (variance < 0) file.fail("tensor '" + norm + ".running_var' holds a negative variance");
    return result;
}

Convolution LayerReader::convolution(const std::string& conv, const std::string& norm, int in,
                                     const ConvolutionOptions& options) const {
    Filters read = filters(conv, in, options.groups);
    if (norm.empty()) return {std::move(read), options};
    const BatchNorm normalisation = batch_norm(norm, read.out);
    return {fold(std::move(read), normalisation), options};
}

TransposedConvolution LayerReader::transposed_convolution(const std::string& name, int in,
                                                          const ConvolutionOptions& options) const {
    const std::string tensor = name + ".weight";
    Filters filters;
    filters.in = in;
    filters.out = extent(tensor, 4, 1) * options.groups;
    filters.height = extent(tensor, 4, 2);
    filters.width = extent(tensor, 4, 3);
    filters.weights = file.read(tensor, {in, filters.out / options.groups, filters.height, filters.width});
    filters.bias = file.read(name + ".bias", {filters.out});
    return {std::move(filters), options};
}

Linear LayerReader::linear(const std::string& name, int in, int) const {
    const int out = extent(name + ".weight", 2, 0);
    return {out, in, file.read(name + ".weight", {out, in}), file.read(name + ".bias", {out})};
}

} // namespace pantin::network
