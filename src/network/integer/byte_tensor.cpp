// SPDX-License-Identifier: MIT
// Layers without weights, on bytes.
#include "network/integer/byte_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pantin/error.hpp"

namespace pantin::network::integer {
namespace {

using Word = std::uint32_t;

[[noreturn]] void fail(const std::string& fact) { throw Error(ErrorKind::weights, "network: " + fact); }

// The larger of each pair of bytes.
Word larger_bytes(Word a, Word b) {
    Word larger = 0;
    for (int shift = 0; shift < 32; shift += 8)
        larger |= std::max(a >> shift & 255, b >> shift & 255) << shift;
    return larger;
}

} // namespace

ByteTensor to_bytes(const Tensor& input) {
    ByteTensor bytes =
        ByteTensor::uninitialised(input.batch(), input.channels(), input.height(), input.width());
    std::fill(bytes.words.begin(), bytes.words.end(), Word{0});
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c) {
            const float* in = input.plane(n, c);
            Word* out = bytes.words.plane(n, c / 4);
            for (std::size_t i = 0; i < input.plane_size(); ++i)
                out[i] |= static_cast<Word>(std::clamp(255 * in[i] + 0.5f, 0.0f, 255.0f)) << (8 * (c % 4));
        }
    return bytes;
}

ByteTensor max_pool(const ByteTensor& input, int kernel, int stride, int padding) {
    const auto extent = [&](int size) { return (size + 2 * padding - kernel) / stride + 1; };
    if (input.height() + 2 * padding < kernel || input.width() + 2 * padding < kernel)
        fail("a pooling window larger than its image");
    ByteTensor output = ByteTensor::uninitialised(input.batch(), input.channels, extent(input.height()),
                                                  extent(input.width()));
    for (int n = 0; n < input.batch(); ++n)
        for (int w = 0; w < input.words.channels(); ++w)
            for (int y = 0; y < output.height(); ++y)
                for (int x = 0; x < output.width(); ++x) {
                    const int top = y * stride - padding, left = x * stride - padding;
                    Word largest = 0;
                    for (int row = std::max(0, top); row < std::min(input.height(), top + kernel); ++row)
                        for (int column = std::max(0, left); column < std::min(input.width(), left + kernel);
                             ++column)
                            largest = larger_bytes(largest, input.words(n, w, row, column));
                    output.words(n, w, y, x) = largest;
                }
    return output;
}

ByteTensor resize_nearest(const ByteTensor& input, int height, int width) {
    if (input.plane_size() == 0 || height < 1 || width < 1) fail("an empty image is resized");
    ByteTensor output = ByteTensor::uninitialised(input.batch(), input.channels, height, width);
    std::vector<int> columns;
    for (int x = 0; x < width; ++x)
        columns.push_back(static_cast<int>(static_cast<std::int64_t>(x) * input.width() / width));
    for (int n = 0; n < input.batch(); ++n)
        for (int w = 0; w < input.words.channels(); ++w)
            for (int y = 0; y < height; ++y) {
                const auto row =
                    static_cast<std::size_t>(static_cast<std::int64_t>(y) * input.height() / height);
                const Word* in = input.words.plane(n, w) + row * input.width();
                Word* out = output.words.plane(n, w) + static_cast<std::size_t>(y) * width;
                for (int x = 0; x < width; ++x) out[x] = in[columns[x]];
            }
    return output;
}

namespace {

// Two bytes of a word with room for sums of 16 bits; `odd`: bytes 1 and 3.
Word pair(Word word, bool odd) { return (odd ? word >> 8 : word) & 0x00ff00ff; }

// 3·near + far of both pairs of bytes of two rows, one row after the other.
void mix_rows(const Word* near, const Word* far, int width, bool odd, Word* out) {
    for (int x = 0; x < width; ++x) out[x] = 3 * pair(near[x], odd) + pair(far[x], odd);
}

// Neighbours of a row of sums, mixed as the rows were, rounded, as bytes at their places.
void mix_columns(const Word* sums, int width, bool odd, Word* out) {
    const auto put = [&](Word& word, Word near, Word far) {
        const Word bytes = (3 * near + far + 0x00080008) >> 4 & 0x00ff00ff;
        word = odd ? word | bytes << 8 : bytes;
    };
    for (int x = 0; x < width; ++x) {
        put(out[2 * x], sums[x], sums[std::max(0, x - 1)]);
        put(out[2 * x + 1], sums[x], sums[std::min(width - 1, x + 1)]);
    }
}

} // namespace

ByteTensor doubled(const ByteTensor& input) {
    if (input.plane_size() == 0) fail("an empty image is resized");
    const int width = input.width(), height = input.height();
    ByteTensor output = ByteTensor::uninitialised(input.batch(), input.channels, 2 * height, 2 * width);
    std::vector<Word> sums(static_cast<std::size_t>(width)); // of two rows, at most 4·255 each
    for (int n = 0; n < input.batch(); ++n)
        for (int w = 0; w < input.words.channels(); ++w)
            for (int y = 0; y < 2 * height; ++y) {
                const int other = std::clamp(y / 2 + (y % 2 ? 1 : -1), 0, height - 1);
                const Word* plane = input.words.plane(n, w);
                const Word* near = plane + static_cast<std::size_t>(y / 2) * width;
                const Word* far = plane + static_cast<std::size_t>(other) * width;
                Word* out = output.words.plane(n, w) + static_cast<std::size_t>(y) * output.width();
                for (const bool odd : {false, true}) {
                    mix_rows(near, far, width, odd, sums.data());
                    mix_columns(sums.data(), width, odd, out);
                }
            }
    return output;
}

ByteTensor concatenate(const ByteTensor& a, const ByteTensor& b) {
    if (a.batch() != b.batch() || a.height() != b.height() || a.width() != b.width())
        fail("tensors of different sizes are joined");
    ByteTensor output = ByteTensor::uninitialised(a.batch(), a.channels + b.channels, a.height(), a.width());
    const std::size_t size = a.plane_size();
    const int whole = a.channels / 4, shift = a.channels % 4 * 8; // bits of a's last word
    for (int n = 0; n < a.batch(); ++n) {
        std::copy_n(a.words.plane(n, 0), size * static_cast<std::size_t>(a.words.channels()),
                    output.words.plane(n, 0));
        if (shift == 0) {
            std::copy_n(b.words.plane(n, 0), size * static_cast<std::size_t>(b.words.channels()),
                        output.words.plane(n, whole));
            continue;
        }
        for (std::size_t i = 0; i < size; ++i) output.words.plane(n, whole)[i] &= (Word{1} << shift) - 1;
        for (int w = 0; w < b.words.channels(); ++w) {
            const Word* in = b.words.plane(n, w);
            Word* out = output.words.plane(n, whole + w);
            for (std::size_t i = 0; i < size; ++i) out[i] |= in[i] << shift;
            if (whole + w + 1 == output.words.channels()) continue; // no byte of it is left
            out = output.words.plane(n, whole + w + 1);
            for (std::size_t i = 0; i < size; ++i) out[i] = in[i] >> (32 - shift);
        }
    }
    return output;
}

Tensor global_average_pool(const ByteTensor& input) {
    if (input.plane_size() == 0) fail("pooling over an empty image");
    Tensor output = Tensor::uninitialised(input.batch(), input.channels, 1, 1);
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels; ++c) {
            std::int64_t sum = 0;
            for (std::size_t i = 0; i < input.plane_size(); ++i) sum += input.byte(n, c, i);
            output(n, c, 0, 0) =
                static_cast<float>(static_cast<double>(sum) / static_cast<double>(input.plane_size()));
        }
    return output;
}

Tensor global_max_pool(const ByteTensor& input) {
    if (input.plane_size() == 0) fail("pooling over an empty image");
    Tensor output = Tensor::uninitialised(input.batch(), input.channels, 1, 1);
    for (int n = 0; n < input.batch(); ++n)
        for (int w = 0; w < input.words.channels(); ++w) {
            const Word* plane = input.words.plane(n, w);
            Word largest = 0;
            for (std::size_t i = 0; i < input.plane_size(); ++i) largest = larger_bytes(largest, plane[i]);
            for (int c = 4 * w; c < std::min(input.channels, 4 * w + 4); ++c)
                output(n, c, 0, 0) = static_cast<float>(largest >> (8 * (c % 4)) & 255);
        }
    return output;
}

} // namespace pantin::network::integer
