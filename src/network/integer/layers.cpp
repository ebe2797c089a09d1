// SPDX-License-Identifier: MIT
// Convolution, transposed convolution and linear layer on bytes, and the proof that their numbers cannot
// overflow.
#include "network/integer/layers.hpp"

#include <algorithm>
#include <cstdlib>
#include <type_traits>

#include "network/integer/chains.hpp"
#include "pantin/error.hpp"

namespace pantin::network::integer {
namespace {

using Word = std::uint32_t;

[[noreturn]] void fail(const std::string& fact) { throw Error(ErrorKind::weights, "network: " + fact); }

constexpr int largest_weight = 63; // sums of two products with a byte fit 16 bits
constexpr int largest_shift = 62;

// 255·Σ|weight| of each output channel.
std::vector<std::uint64_t> largest_sums(const Filters& filters, bool transposed) {
    const auto out = static_cast<std::size_t>(filters.out);
    std::vector<std::uint64_t> sums(out);
    const std::size_t taps = static_cast<std::size_t>(filters.height) * filters.width;
    const std::size_t run = transposed ? taps : taps * filters.in; // weights of one channel that lie together
    const std::int8_t* weight = filters.weights.data();
    for (std::size_t i = 0; i < filters.weights.size() / run; ++i) {
        unsigned sum = 0;
        for (std::size_t k = 0; k < run; ++k) sum += static_cast<unsigned>(std::abs(*weight++));
        sums[i % out] += std::uint64_t{255} * sum;
    }
    return sums;
}

void check(const Filters& filters, bool transposed) {
    if (const std::string fault = fault_of(filters, transposed); !fault.empty())
        throw Error(ErrorKind::weights, fault);
}

} // namespace

std::string fault_of(const Filters& filters, bool transposed) {
    const Rescaling& rescaling = filters.rescaling;
    if (filters.out < 1 || filters.in < 1 || filters.height < 1 || filters.width < 1) return "no filters";
    const auto out = static_cast<std::size_t>(filters.out);
    if (filters.weights.size() != out * filters.in * filters.height * filters.width ||
        rescaling.multiplier.size() != out || rescaling.offset.size() != out)
        return "weights that do not fit its shape";
    int farthest = 0; // from 0
    for (const std::int8_t weight : filters.weights) farthest = std::max(farthest, std::abs(weight));
    if (farthest > largest_weight) return "a weight beyond 63";
    if (rescaling.shift < 1 || rescaling.shift > largest_shift) return "a shift outside 1 to 62";
    if (rescaling.residual < 0) return "a negative factor";
    const std::uint64_t bound = std::uint64_t{1} << std::min(largest_shift, 31 + rescaling.shift);
    const std::vector<std::uint64_t> sums = largest_sums(filters, transposed);
    for (std::size_t o = 0; o < out; ++o) {
        if (sums[o] >> 31 != 0) return "sums that could overflow";
        if (rescaling.multiplier[o] < 0) return "a negative factor";
        const std::int64_t offset = rescaling.offset[o];
        const std::uint64_t size =
            offset < 0 ? -static_cast<std::uint64_t>(offset) : static_cast<std::uint64_t>(offset);
        const std::uint64_t scaled = sums[o] * static_cast<std::uint64_t>(rescaling.multiplier[o]) +
                                     255 * static_cast<std::uint64_t>(rescaling.residual);
        if (size >= bound || scaled >= bound || scaled + size >= bound)
            return "a rescaling that could overflow";
    }
    return "";
}

// --- convolution -----------------------------------------------------------------------------------------

Convolution::Convolution(Filters filters, const ConvolutionOptions& options)
    : out_(filters.out), in_(filters.in), height_(filters.height), width_(filters.width), zero_(filters.zero),
      options_(options), columns_in_words_(filters.in == 1 && filters.width > 1 && options.dilation == 1) {
    check(filters, false);
    if (options.stride < 1 || options.dilation < 1 || options.groups != 1 || options.padding < 0)
        fail("a convolution on bytes with an impossible stride, dilation, padding or number of groups");
    const int taps = height_ * width_;
    const auto weight = [&](int o, int i, int t) {
        return filters.weights[(static_cast<std::size_t>(o) * in_ + i) * taps + t];
    };
    if (columns_in_words_) {
        const int groups = (width_ + 3) / 4;
        packed_ = pack(out_, 4, height_ * groups, [&](int o, int k, int t) {
            const int column = t % groups * 4 + k;
            return column < width_ ? weight(o, 0, t / groups * width_ + column) : std::int8_t{0};
        });
    } else {
        packed_ = pack(out_, in_, taps, weight);
    }
    rescaling_ = padded(std::move(filters.rescaling));
}

// Words of four neighbouring columns of the padded image: byte k of column x is the pixel at x + k.
static BasicTensor<Word> columns_in_words(const ByteTensor& input, int padding, std::uint8_t zero) {
    const int height = input.height() + 2 * padding, width = input.width() + 2 * padding;
    auto words = BasicTensor<Word>::uninitialised(input.batch(), 1, height, width);
    std::vector<Word> row(static_cast<std::size_t>(width) + 3, zero);
    for (int n = 0; n < input.batch(); ++n)
        for (int y = 0; y < height; ++y) {
            std::fill(row.begin(), row.end(), Word{zero});
            if (y >= padding && y < padding + input.height()) {
                const Word* in =
                    input.words.plane(n, 0) + static_cast<std::size_t>(y - padding) * input.width();
                std::transform(in, in + input.width(), row.begin() + padding,
                               [](Word word) { return word & 255; });
            }
            Word* out = words.plane(n, 0) + static_cast<std::size_t>(y) * width;
            for (int x = 0; x < width; ++x)
                out[x] = row[x] | row[x + 1] << 8 | row[x + 2] << 16 | row[x + 3] << 24;
        }
    return words;
}

struct Convolution::Prepared {
    BasicTensor<Word> rearranged; // or of no element
    const BasicTensor<Word>& words;
    Pass pass;
};

Convolution::Prepared Convolution::prepare(const ByteTensor& input) const {
    if (input.channels != in_) fail("a convolution gets another number of channels than it has filters for");
    const auto extent = [&](int size, int kernel) {
        const int left = size + 2 * options_.padding - options_.dilation * (kernel - 1) - 1;
        return left < 0 ? 0 : left / options_.stride + 1;
    };
    Pass pass;
    pass.out_height = extent(input.height(), height_);
    pass.out_width = extent(input.width(), width_);
    pass.stride = options_.stride;
    const int step = columns_in_words_ ? 4 : 1;
    for (int ky = 0; ky < height_; ++ky)
        for (int kx = 0; kx < width_; kx += step)
            pass.taps.push_back({ky * options_.dilation, kx * options_.dilation});
    if (columns_in_words_) return {columns_in_words(input, options_.padding, zero_), input.words, pass};
    pass.top = pass.left = options_.padding;
    return {{}, input.words, pass};
}

namespace {

template <class Prepared, class Targets>
void run_all(const Prepared& prepared, const PackedFilters& packed, const Rescaling& rescaling,
             std::uint8_t zero, const Runtime& runtime, const Targets& target) {
    const BasicTensor<Word>& words = prepared.rearranged.size() > 0 ? prepared.rearranged : prepared.words;
    for (int n = 0; n < words.batch(); ++n)
        run_pass(words, n, packed, rescaling, zero, prepared.pass, runtime, target);
}

} // namespace

ByteTensor Convolution::forward(const ByteTensor& input, const Runtime& runtime) const {
    if (rescaling_.residual != 0) fail("a convolution with a residual gets none");
    const Prepared prepared = prepare(input);
    ByteTensor output =
        ByteTensor::uninitialised(input.batch(), out_, prepared.pass.out_height, prepared.pass.out_width);
    run_all(prepared, packed_, rescaling_, zero_, runtime, Target{&output, nullptr, nullptr});
    return output;
}

ByteTensor Convolution::forward_and_add(const ByteTensor& input, const ByteTensor& added,
                                        const Runtime& runtime) const {
    if (rescaling_.residual == 0) fail("a convolution without a residual gets one");
    const Prepared prepared = prepare(input);
    ByteTensor output =
        ByteTensor::uninitialised(input.batch(), out_, prepared.pass.out_height, prepared.pass.out_width);
    if (added.channels != out_ || !added.words.same_shape(output.words))
        fail("a sum of tensors of different shapes");
    run_all(prepared, packed_, rescaling_, zero_, runtime, Target{&output, &added, nullptr});
    return output;
}

Tensor Convolution::forward_real(const ByteTensor& input, const Runtime& runtime) const {
    const Prepared prepared = prepare(input);
    Tensor output =
        Tensor::uninitialised(input.batch(), out_, prepared.pass.out_height, prepared.pass.out_width);
    run_all(prepared, packed_, rescaling_, zero_, runtime, Target{nullptr, nullptr, &output});
    return output;
}

// --- transposed convolution ------------------------------------------------------------------------------

TransposedConvolution::TransposedConvolution(const Filters& filters, const ConvolutionOptions& options)
    : out_(filters.out), in_(filters.in), stride_(options.stride), zero_(filters.zero),
      rescaling_(padded(filters.rescaling)) {
    check(filters, true);
    if (filters.height != options.stride || filters.width != options.stride || options.padding != 0 ||
        options.output_padding != 0 || options.dilation != 1 || options.groups != 1)
        fail("a transposed convolution on bytes whose kernel is not its stride");
    const int taps = stride_ * stride_;
    for (int phase = 0; phase < taps; ++phase)
        phases_.push_back(pack(out_, in_, 1, [&](int o, int i, int) {
            return filters.weights[(static_cast<std::size_t>(i) * out_ + o) * taps + phase];
        }));
}

template <class Result>
void TransposedConvolution::run(const ByteTensor& input, const Runtime& runtime, Result& result) const {
    if (input.channels != in_)
        fail("a transposed convolution gets another number of channels than it has filters for");
    result = Result::uninitialised(input.batch(), out_, stride_ * input.height(), stride_ * input.width());
    Target target;
    if constexpr (std::is_same_v<Result, Tensor>)
        target.real = &result;
    else
        target.bytes = &result;
    for (int phase = 0; phase < stride_ * stride_; ++phase) {
        Pass pass;
        pass.out_height = input.height();
        pass.out_width = input.width();
        pass.taps = {{0, 0}};
        pass.step = stride_;
        pass.row = phase / stride_;
        pass.column = phase % stride_;
        for (int n = 0; n < input.batch(); ++n)
            run_pass(input.words, n, phases_[static_cast<std::size_t>(phase)], rescaling_, zero_, pass,
                     runtime, target);
    }
}

ByteTensor TransposedConvolution::forward(const ByteTensor& input, const Runtime& runtime) const {
    ByteTensor output;
    run(input, runtime, output);
    return output;
}

Tensor TransposedConvolution::forward_real(const ByteTensor& input, const Runtime& runtime) const {
    Tensor output;
    run(input, runtime, output);
    return output;
}

// --- linear layer ----------------------------------------------------------------------------------------

// The entries of a batch take the place of the pixels, a word of four channels at a pixel that of a word: one
// convolution with a kernel of 1×1.
Linear::Linear(Filters filters, int places)
    : out_(filters.out), in_(filters.in), places_(places), zero_(filters.zero) {
    check(filters, false);
    if (places < 1 || in_ % places != 0) fail("a linear layer on bytes whose inputs are no whole channels");
    const int channels = in_ / places, words = (channels + 3) / 4;
    packed_ = pack(out_, 4 * words * places, 1, [&](int o, int k, int) {
        const int channel = k / (4 * places) * 4 + k % 4, place = k / 4 % places;
        return channel < channels ? filters.weights[static_cast<std::size_t>(o) * in_ +
                                                    static_cast<std::size_t>(channel) * places + place]
                                  : std::int8_t{0};
    });
    rescaling_ = padded(std::move(filters.rescaling));
}

namespace {

// [a][b] to [b][a]
template <class Element> void transpose(const Element* in, int a, int b, Element* out) {
    for (int i = 0; i < a; ++i)
        for (int j = 0; j < b; ++j)
            out[static_cast<std::size_t>(j) * a + i] = in[static_cast<std::size_t>(i) * b + j];
}

// The batch along a row: [1][words of all pixels][1][batch].
BasicTensor<Word> batch_along_row(const ByteTensor& input) {
    const int words = input.words.channels() * static_cast<int>(input.plane_size());
    auto row = BasicTensor<Word>::uninitialised(1, words, 1, input.batch());
    transpose(input.words.data(), input.batch(), words, row.data());
    return row;
}

Pass along_row(int batch) {
    Pass pass;
    pass.out_height = 1;
    pass.out_width = batch;
    pass.taps = {{0, 0}};
    return pass;
}

void check_input(const ByteTensor& input, int in, int places) {
    if (static_cast<int>(input.plane_size()) != places || input.channels * places != in)
        fail("a linear layer gets another number of values than it has weights for");
}

} // namespace

ByteTensor Linear::forward(const ByteTensor& input, const Runtime& runtime) const {
    check_input(input, in_, places_);
    ByteTensor along = ByteTensor::uninitialised(1, out_, 1, input.batch());
    run_pass(batch_along_row(input), 0, packed_, rescaling_, zero_, along_row(input.batch()), runtime,
             Target{&along, nullptr, nullptr});
    ByteTensor output = ByteTensor::uninitialised(input.batch(), out_, 1, 1);
    transpose(along.words.data(), along.words.channels(), input.batch(), output.words.data());
    return output;
}

Tensor Linear::forward_real(const ByteTensor& input, const Runtime& runtime) const {
    check_input(input, in_, places_);
    Tensor along = Tensor::uninitialised(1, out_, 1, input.batch());
    run_pass(batch_along_row(input), 0, packed_, rescaling_, zero_, along_row(input.batch()), runtime,
             Target{nullptr, nullptr, &along});
    Tensor output = Tensor::uninitialised(input.batch(), out_, 1, 1);
    transpose(along.data(), out_, input.batch(), output.data());
    return output;
}

} // namespace pantin::network::integer
