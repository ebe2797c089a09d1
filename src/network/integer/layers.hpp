// SPDX-License-Identifier: MIT
// Convolutions and linear layers on bytes (Jacob et al. 2018, "Quantization and training of neural networks
// for efficient integer-arithmetic-only inference", 2.2): weights of −63 … 63, sums of 32 bits, and one
// rescaling that makes bytes of the sums, or real numbers where a network ends. tools/train/quantize.py makes
// the integers. Everything here is exact, so threads, instruction sets and orders of summation do not show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "network/integer/byte_tensor.hpp"

namespace pantin::network::integer {

// With sum = Σ weight·byte, a byte result is clamp((sum·multiplier + residual·q + offset) >> shift, 0, 255),
// q the byte that is added to a residual block's branch; a real one is ((sum·multiplier + offset) >>
// shift)·2⁻¹⁶.
struct Rescaling {
    std::vector<std::int32_t> multiplier; // [out], ≥ 0
    std::vector<std::int64_t> offset;     // [out]
    int shift = 0;
    std::int32_t residual = 0; // ≥ 0; 0 where nothing is added
};

// As in the weight file: of a convolution [out][in][row][column], of a transposed one [in][out][row][column],
// of a linear layer [out][in] (height = width = 1).
struct Filters {
    int out = 0, in = 0, height = 1, width = 1;
    std::vector<std::int8_t> weights;
    Rescaling rescaling;
    std::uint8_t zero = 0; // the byte of the input that stands for 0: padding
};

// What is wrong with the filters, or "": sizes, a weight beyond ±63, numbers that could overflow. With A =
// 255·Σ|weight| of an output channel: A < 2³¹, and A·multiplier + 255·residual + |offset| < 2⁶² and < 2^(31 +
// shift). transposed: `out` is the second dimension of the weights.
std::string fault_of(const Filters& filters, bool transposed = false);

// Filters as the kernel reads them: [block of four output channels][word][tap][output channel], four bytes
// each.
struct PackedFilters {
    int out = 0, words = 0, taps = 0;
    std::vector<std::uint32_t> weights;
};

// network::Convolution on bytes, one group. Constructors throw Error(weights) when fault_of says something.
class Convolution {
public:
    Convolution(Filters filters, const ConvolutionOptions& options);

    // Error(weights) when the channels differ, or the shape of what is added.
    ByteTensor forward(const ByteTensor& input, const Runtime& runtime) const;
    ByteTensor forward_and_add(const ByteTensor& input, const ByteTensor& added,
                               const Runtime& runtime) const;
    Tensor forward_real(const ByteTensor& input, const Runtime& runtime) const;

    int out_channels() const { return out_; }
    std::uint8_t zero() const { return zero_; }

private:
    struct Prepared; // the input and the pass over it
    Prepared prepare(const ByteTensor& input) const;

    int out_, in_, height_, width_;
    std::uint8_t zero_;
    ConvolutionOptions options_;
    Rescaling rescaling_;
    PackedFilters packed_;
    bool columns_in_words_; // one channel: a word of the input holds four neighbouring columns
};

// network::TransposedConvolution on bytes whose kernel is as large as its stride, without padding: each pixel
// becomes a square.
class TransposedConvolution {
public:
    TransposedConvolution(const Filters& filters, const ConvolutionOptions& options);
    ByteTensor forward(const ByteTensor& input, const Runtime& runtime) const;
    Tensor forward_real(const ByteTensor& input, const Runtime& runtime) const;

private:
    template <class Result> void run(const ByteTensor& input, const Runtime& runtime, Result& result) const;

    int out_, in_, stride_;
    std::uint8_t zero_;
    Rescaling rescaling_;
    std::vector<PackedFilters> phases_; // [row·stride + column]
};

// network::Linear on bytes.
class Linear {
public:
    // places: pixels of each channel of the input.
    Linear(Filters filters, int places);
    ByteTensor forward(const ByteTensor& input, const Runtime& runtime) const; // [batch][out][1][1]
    Tensor forward_real(const ByteTensor& input, const Runtime& runtime) const;
    std::uint8_t zero() const { return zero_; }

private:
    int out_, in_, places_;
    std::uint8_t zero_;
    Rescaling rescaling_;
    PackedFilters packed_;
};

} // namespace pantin::network::integer
