// SPDX-License-Identifier: MIT
// From the weight file to layers on bytes.
#include "network/integer/layer_reader.hpp"

#include "network/layer_reader.hpp"

namespace pantin::network::integer {

int LayerReader::extent(const std::string& tensor, std::size_t rank, std::size_t dimension) const {
    return network::LayerReader{file}.extent(tensor, rank, dimension);
}

// With the layer's rescaling; what fault_of finds is an error of the file.
Filters LayerReader::checked(const std::string& name, Filters filters, bool transposed) const {
    Rescaling& rescaling = filters.rescaling;
    rescaling.multiplier = file.read_integers<std::int32_t>(name + ".multiplier", {filters.out});
    rescaling.offset = file.read_integers<std::int64_t>(name + ".offset", {filters.out});
    rescaling.shift = file.read_integers<std::int32_t>(name + ".shift", {1})[0];
    filters.zero = file.read_integers<std::uint8_t>(name + ".zero", {1})[0];
    if (const std::string fault = fault_of(filters, transposed); !fault.empty())
        file.fail("layer '" + name + "' has " + fault);
    return filters;
}

Filters LayerReader::filters(const std::string& conv, int in) const {
    const std::string name = conv + ".weight";
    Filters filters;
    filters.in = in;
    filters.out = extent(name, 4, 0);
    filters.height = extent(name, 4, 2);
    filters.width = extent(name, 4, 3);
    filters.weights = file.read_integers<std::int8_t>(name, {filters.out, in, filters.height, filters.width});
    return filters;
}

Convolution LayerReader::convolution(const std::string& conv, const std::string&, int in,
                                     const ConvolutionOptions& options) const {
    if (file.contains(conv + ".residual"))
        file.fail("tensor '" + conv + ".residual' belongs to a layer to which nothing is added");
    return {checked(conv, filters(conv, in), false), options};
}

Convolution LayerReader::adding_convolution(const std::string& conv, const std::string&, int in,
                                            const ConvolutionOptions& options) const {
    Filters read = filters(conv, in);
    read.rescaling.residual = file.read_integers<std::int32_t>(conv + ".residual", {1})[0];
    if (read.rescaling.residual == 0) file.fail("tensor '" + conv + ".residual' is 0");
    return {checked(conv, std::move(read), false), options};
}

TransposedConvolution LayerReader::transposed_convolution(const std::string& layer, int in,
                                                          const ConvolutionOptions& options) const {
    const std::string name = layer + ".weight";
    Filters filters;
    filters.in = in;
    filters.out = extent(name, 4, 1);
    filters.height = extent(name, 4, 2);
    filters.width = extent(name, 4, 3);
    filters.weights = file.read_integers<std::int8_t>(name, {in, filters.out, filters.height, filters.width});
    return {checked(layer, std::move(filters), true), options};
}

Linear LayerReader::linear(const std::string& layer, int in, int places) const {
    Filters filters;
    filters.in = in;
    filters.out = extent(layer + ".weight", 2, 0);
    filters.weights = file.read_integers<std::int8_t>(layer + ".weight", {filters.out, in});
    return {checked(layer, std::move(filters), false), places};
}

network::Linear LayerReader::real_linear(const std::string& name, int in) const {
    return network::LayerReader{file}.linear(name, in);
}

} // namespace pantin::network::integer
