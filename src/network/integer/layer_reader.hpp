// SPDX-License-Identifier: MIT
// Layers on bytes from a weight file that tools/train/quantize.py wrote (docs/formats.md): `<name>.weight` as
// in PyTorch's state dictionary, I8, and beside it the integers of the rescaling. The methods are those of
// network::LayerReader; batch normalisations are folded in already, so their names are not looked for.
#pragma once

#include <string>

#include "network/integer/layers.hpp"

namespace pantin::network::integer {

struct LayerReader {
    const WeightFile& file;
    double epsilon = 0; // of batch normalisation: there is none

    Convolution convolution(const std::string& conv, const std::string& norm, int in,
                            const ConvolutionOptions& options) const;
    // The same of the last one of a residual block's branch, or of one that a coarser level is added to.
    Convolution adding_convolution(const std::string& conv, const std::string& norm, int in,
                                   const ConvolutionOptions& options) const;
    TransposedConvolution transposed_convolution(const std::string& name, int in,
                                                 const ConvolutionOptions& options) const;
    // places: pixels of a channel of its input.
    Linear linear(const std::string& name, int in, int places = 1) const;
    // A small layer on real numbers, as network::LayerReader reads it.
    network::Linear real_linear(const std::string& name, int in) const;
    int extent(const std::string& tensor, std::size_t rank, std::size_t dimension) const;

private:
    Filters filters(const std::string& conv, int in) const;
    void read_rescaling(const std::string& name, Filters& filters) const;
    // The layer, whose constructor proves that nothing can overflow; its error names the layer.
    template <class Layer, class Option>
    Layer make(const std::string& name, Filters filters, const Option& option) const;
};

} // namespace pantin::network::integer
