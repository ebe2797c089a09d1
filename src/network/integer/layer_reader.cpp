// SPDX-License-Identifier: MIT
// From the weight file to layers on bytes.
#include "network/integer/layer_reader.hpp"

#include "network/layer_reader.hpp"
#include "pantin/error.hpp"

namespace pantin::network::integer {

int LayerReader::extent(const std::string& tensor, std::size_t rank, std::size_t dimension) const {
    return network::LayerReader{file}.extent(tensor, rank, dimension);
}

void LayerReader::read_rescaling(const std::string& name, Filters& filters) const {
    Rescaling& rescaling = filters.rescaling;
    rescaling.multiplier = file.read_integers<std::int32_t>(name + ".multiplier", {filters.out});
    rescaling.offset = file.read_integers<std::int64_t>(name + ".offset", {filters.out});
    rescaling.shift = file.read_integers<std::int32_t>(name + ".shift", {1})[0];
    filters.zero = file.read_integers<std::uint8_t>(name + ".zero", {1})[0];
}

template <class Layer, class Option>
Layer LayerReader::make(const std::string& name, Filters filters, const Option& option) const {
    read_rescaling(name, filters);
    try {
        return Layer(std::move(filters), option);
    } catch (const Error& error) {
        file.fail("layer '" + name + "': " + error.what());
    }
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
    return make<Convolution>(conv, filters(conv, in), options);
}

Convolution LayerReader::adding_convolution(const std::string& conv, const std::string&, int in,
                                            const ConvolutionOptions& options) const {
    Filters read = filters(conv, in);
    read.rescaling.residual = file.read_integers<std::int32_t>(conv + ".residual", {1})[0];
    if (read.rescaling.residual == 0) file.fail("tensor '" + conv + ".residual' is 0");
    return make<Convolution>(conv, std::move(read), options);
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
    return make<TransposedConvolution>(layer, std::move(filters), options);
}

Linear LayerReader::linear(const std::string& layer, int in, int places) const {
    Filters filters;
    filters.in = in;
    filters.out = extent(layer + ".weight", 2, 0);
    filters.weights = file.read_integers<std::int8_t>(layer + ".weight", {filters.out, in});
    return make<Linear>(layer, std::move(filters), places);
}

network::Linear LayerReader::real_linear(const std::string& name, int in) const {
    return network::LayerReader{file}.linear(name, in);
}

} // namespace pantin::network::integer
