// SPDX-License-Identifier: MIT
// Convolution, transposed convolution and batch normalisation folded into their filters.
#include <algorithm>
#include <cmath>

#include "network/chains.hpp"
#include "pantin/error.hpp"

namespace pantin::network {
namespace {

[[noreturn]] void fail(const std::string& fact) { throw Error(ErrorKind::weights, "network: " + fact); }

void check(const Filters& filters, const ConvolutionOptions& options, int per_filter) {
    if (filters.out < 1 || filters.in < 1 || filters.height < 1 || filters.width < 1)
        fail("a convolution without filters");
    if (options.stride < 1 || options.dilation < 1 || options.groups < 1 || options.padding < 0 ||
        options.output_padding < 0)
        fail("a convolution with an impossible stride, dilation, padding or number of groups");
    if (filters.in % options.groups || filters.out % options.groups)
        fail("the channels of a convolution cannot be divided into its groups");
    const std::size_t taps = static_cast<std::size_t>(filters.height) * filters.width;
    if (filters.weights.size() !=
            static_cast<std::size_t>(filters.in) * filters.out / options.groups * taps ||
        filters.bias.size() != static_cast<std::size_t>(filters.out) || per_filter < 1)
        fail("a convolution whose weights do not fit its shape");
}

} // namespace

Filters fold(Filters filters, const BatchNorm& norm) {
    const auto out = static_cast<std::size_t>(filters.out);
    if (norm.gamma.size() != out || norm.beta.size() != out || norm.mean.size() != out ||
        norm.variance.size() != out || filters.bias.size() != out || out == 0)
        fail("a normalisation whose size is not the convolution's");
    const std::size_t per_filter = filters.weights.size() / out;
    for (std::size_t o = 0; o < out; ++o) {
        const double spread = static_cast<double>(norm.variance[o]) + norm.epsilon;
        if (!(spread > 0)) fail("a normalisation with a negative variance");
        const double scale = norm.gamma[o] / std::sqrt(spread);
        for (std::size_t i = 0; i < per_filter; ++i) {
            float& weight = filters.weights[o * per_filter + i];
            weight = static_cast<float>(weight * scale);
        }
        const double shifted = static_cast<double>(filters.bias[o]) - norm.mean[o];
        filters.bias[o] = static_cast<float>(norm.beta[o] + shifted * scale);
    }
    return filters;
}

// --- convolution -----------------------------------------------------------------------------------------

Convolution::Convolution(Filters filters, const ConvolutionOptions& options)
    : filters_(std::move(filters)), options_(options) {
    check(filters_, options_, 1);
    const int per_group = filters_.in / options_.groups, taps = filters_.height * filters_.width;
    packed_ = std::make_unique<PackedFilters>(
        pack(filters_.out, per_group, options_.groups, taps, [&](int o, int i, int t) {
            return filters_.weights[(static_cast<std::size_t>(o) * per_group + i) * taps + t];
        }));
    std::vector<float>().swap(filters_.weights);
}
Convolution::Convolution(Convolution&&) noexcept = default;
Convolution& Convolution::operator=(Convolution&&) noexcept = default;
Convolution::~Convolution() = default;

int Convolution::out_height(int height) const {
    const int extent = height + 2 * options_.padding - options_.dilation * (filters_.height - 1) - 1;
    return extent < 0 ? 0 : extent / options_.stride + 1;
}
int Convolution::out_width(int width) const {
    const int extent = width + 2 * options_.padding - options_.dilation * (filters_.width - 1) - 1;
    return extent < 0 ? 0 : extent / options_.stride + 1;
}

std::int64_t Convolution::operations(int height, int width) const {
    return static_cast<std::int64_t>(out_height(height)) * out_width(width) * filters_.out *
           (filters_.in / options_.groups) * filters_.height * filters_.width;
}

Tensor Convolution::forward(const Tensor& input, const Runtime& runtime) const {
    if (input.channels() != filters_.in)
        fail("a convolution gets another number of channels than it has filters for");
    Pass pass;
    pass.out_height = out_height(input.height());
    pass.out_width = out_width(input.width());
    pass.stride = options_.stride;
    pass.top = pass.left = options_.padding;
    pass.relu = options_.relu;
    for (int ky = 0; ky < filters_.height; ++ky)
        for (int kx = 0; kx < filters_.width; ++kx)
            pass.taps.push_back({ky * options_.dilation, kx * options_.dilation});
    Tensor output = Tensor::uninitialised(input.batch(), filters_.out, pass.out_height, pass.out_width);
    for (int n = 0; n < input.batch(); ++n)
        run_pass(input, n, *packed_, filters_.bias, pass, runtime, output);
    return output;
}

// --- transposed convolution ------------------------------------------------------------------------------

// Output rows and columns of one residue modulo the stride form a convolution of stride 1 with the taps that
// reach them: row s·r + residue reads input row r + (residue + padding − dilation·ky) / s where that is
// whole.
struct TransposedConvolution::Phase {
    int row = 0, column = 0; // residues
    int top = 0, left = 0;   // zero rows and columns in front of the image, so that no tap is negative
    std::vector<Tap> taps;
    PackedFilters packed;
};

TransposedConvolution::TransposedConvolution(Filters filters, const ConvolutionOptions& options)
    : filters_(std::move(filters)), options_(options) {
    check(filters_, options_, 1);
    const int s = options_.stride, per_group_in = filters_.in / options_.groups;
    const int per_group_out = filters_.out / options_.groups;
    for (int residue = 0; residue < s * s; ++residue) {
        Phase phase;
        phase.row = residue / s;
        phase.column = residue % s;
        std::vector<int> chosen; // taps of the filter that reach this phase, in raster order
        for (int ky = 0; ky < filters_.height; ++ky) {
            for (int kx = 0; kx < filters_.width; ++kx) {
                const int y = phase.row + options_.padding - options_.dilation * ky;
                const int x = phase.column + options_.padding - options_.dilation * kx;
                if (y % s != 0 || x % s != 0) continue;
                phase.taps.push_back({y / s, x / s});
                chosen.push_back(ky * filters_.width + kx);
                phase.top = std::max(phase.top, -y / s);
                phase.left = std::max(phase.left, -x / s);
            }
        }
        for (Tap& tap : phase.taps) tap = {tap.dy + phase.top, tap.dx + phase.left};
        const int taps = filters_.height * filters_.width;
        phase.packed =
            pack(filters_.out, per_group_in, options_.groups, static_cast<int>(chosen.size()),
                 [&](int o, int i, int t) {
                     const std::size_t in = static_cast<std::size_t>(o / per_group_out) * per_group_in + i;
                     return filters_.weights[(in * per_group_out + o % per_group_out) * taps + chosen[t]];
                 });
        phases_.push_back(std::move(phase));
    }
    std::vector<float>().swap(filters_.weights);
}
TransposedConvolution::TransposedConvolution(TransposedConvolution&&) noexcept = default;
TransposedConvolution& TransposedConvolution::operator=(TransposedConvolution&&) noexcept = default;
TransposedConvolution::~TransposedConvolution() = default;

Tensor TransposedConvolution::forward(const Tensor& input, const Runtime& runtime) const {
    if (input.channels() != filters_.in)
        fail("a transposed convolution gets another number of channels than it has filters for");
    const int s = options_.stride;
    const auto extent = [&](int size, int kernel) {
        return (size - 1) * s - 2 * options_.padding + options_.dilation * (kernel - 1) +
               options_.output_padding + 1;
    };
    Tensor output(input.batch(), filters_.out, std::max(0, extent(input.height(), filters_.height)),
                  std::max(0, extent(input.width(), filters_.width)));
    for (const Phase& phase : phases_) {
        Pass pass;
        pass.out_height = (output.height() - phase.row + s - 1) / s;
        pass.out_width = (output.width() - phase.column + s - 1) / s;
        pass.top = phase.top;
        pass.left = phase.left;
        pass.taps = phase.taps;
        pass.relu = options_.relu;
        pass.step = s;
        pass.row = phase.row;
        pass.column = phase.column;
        for (int n = 0; n < input.batch(); ++n)
            run_pass(input, n, phase.packed, filters_.bias, pass, runtime, output);
    }
    return output;
}

} // namespace pantin::network
