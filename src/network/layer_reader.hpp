// SPDX-License-Identifier: MIT
// Layers from a weight file by the tensor names of PyTorch's state dictionaries. Widths and kernel sizes are
// those of the tensors, so one reader serves every width of a network. Anything that does not fit is
// Error(weights) naming the file and the tensor.
#pragma once

#include <string>

#include "pantin/network.hpp"

namespace pantin::network {

// A state dictionary: the file, and how its batch normalisations were made.
struct LayerReader {
    const WeightFile& file;
    double epsilon = 1e-5; // of batch normalisation

    // `<conv>.weight` of shape [out, in, height, width]; the bias is `<conv>.bias` where there is one; `norm`
    // is the batch normalisation behind it ("": none), folded in. `in` is the number of channels that arrive.
    Convolution convolution(const std::string& conv, const std::string& norm, int in,
                            const ConvolutionOptions& options) const;
    // The same: what is added comes after it (integer::LayerReader needs to know).
    Convolution adding_convolution(const std::string& conv, const std::string& norm, int in,
                                   const ConvolutionOptions& options) const {
        return convolution(conv, norm, in, options);
    }
    // `<name>.weight` of shape [in, out, height, width], `<name>.bias`.
    TransposedConvolution transposed_convolution(const std::string& name, int in,
                                                 const ConvolutionOptions& options) const;
    // `<name>.weight` of shape [out, in], `<name>.bias`. (places: what integer::LayerReader needs.)
    Linear linear(const std::string& name, int in, int places = 1) const;
    Linear real_linear(const std::string& name, int in) const { return linear(name, in); }

    // Extent of one dimension of a tensor that must have `rank` of them.
    int extent(const std::string& tensor, std::size_t rank, std::size_t dimension) const;

private:
    Filters filters(const std::string& conv, int in, int groups) const;
    BatchNorm batch_norm(const std::string& norm, int channels) const;
};

} // namespace pantin::network
