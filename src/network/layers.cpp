// SPDX-License-Identifier: MIT
// Layers without weights: pooling, activations, joining, resizing, sigmoid, softmax.
#include <algorithm>
#include <limits>

#include "core/math.hpp"
#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {
namespace {

[[noreturn]] void fail(const std::string& fact) { throw Error(ErrorKind::weights, "network: " + fact); }

// Calls visit(plane, output place, first row, row after the last, first column, column after the last) for
// every window, cut at the image.
template <class Visit>
Tensor pool(const Tensor& input, int kernel, int stride, int padding, bool ceil_mode, const Visit& visit) {
    if (kernel < 1 || stride < 1 || padding < 0 || 2 * padding > kernel)
        fail("a pooling layer with an impossible window");
    const auto extent = [&](int size) {
        const int windows = (size + 2 * padding - kernel + (ceil_mode ? stride - 1 : 0)) / stride + 1;
        return (windows - 1) * stride >= size + padding ? windows - 1 : windows;
    };
    if (input.height() + 2 * padding < kernel || input.width() + 2 * padding < kernel)
        fail("a pooling window larger than its image");
    Tensor output =
        Tensor::uninitialised(input.batch(), input.channels(), extent(input.height()), extent(input.width()));
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c)
            for (int y = 0; y < output.height(); ++y)
                for (int x = 0; x < output.width(); ++x) {
                    const int top = y * stride - padding, left = x * stride - padding;
                    output(n, c, y, x) =
                        visit(input.plane(n, c), std::max(0, top), std::min(input.height(), top + kernel),
                              std::max(0, left), std::min(input.width(), left + kernel));
                }
    return output;
}

} // namespace

Tensor max_pool(const Tensor& input, int kernel, int stride, int padding, bool ceil_mode) {
    return pool(input, kernel, stride, padding, ceil_mode,
                [&](const float* plane, int top, int bottom, int left, int right) {
                    float best = -std::numeric_limits<float>::infinity();
                    for (int y = top; y < bottom; ++y)
                        for (int x = left; x < right; ++x)
                            best = std::max(best, plane[static_cast<std::size_t>(y) * input.width() + x]);
                    return best;
                });
}

Tensor average_pool(const Tensor& input, int kernel, int stride, int padding) {
    return pool(input, kernel, stride, padding, false,
                [&](const float* plane, int top, int bottom, int left, int right) {
                    double sum = 0;
                    for (int y = top; y < bottom; ++y)
                        for (int x = left; x < right; ++x)
                            sum += plane[static_cast<std::size_t>(y) * input.width() + x];
                    return static_cast<float>(sum / (static_cast<double>(bottom - top) * (right - left)));
                });
}

Tensor global_average_pool(const Tensor& input) {
    if (input.plane_size() == 0) fail("pooling over an empty image");
    Tensor output = Tensor::uninitialised(input.batch(), input.channels(), 1, 1);
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c) {
            double sum = 0;
            for (std::size_t i = 0; i < input.plane_size(); ++i) sum += input.plane(n, c)[i];
            output(n, c, 0, 0) = static_cast<float>(sum / static_cast<double>(input.plane_size()));
        }
    return output;
}

Tensor global_max_pool(const Tensor& input) {
    if (input.plane_size() == 0) fail("pooling over an empty image");
    Tensor output = Tensor::uninitialised(input.batch(), input.channels(), 1, 1);
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c)
            output(n, c, 0, 0) = *std::max_element(input.plane(n, c), input.plane(n, c) + input.plane_size());
    return output;
}

void relu(Tensor& x) {
    for (float& value : x) value = value > 0 ? value : 0.0f;
}

void add_relu(Tensor& x, const Tensor& y) {
    if (!x.same_shape(y)) fail("a sum of tensors of different shapes");
    const float* other = y.data();
    float* own = x.data();
    for (std::size_t i = 0; i < x.size(); ++i) {
        const float sum = own[i] + other[i];
        own[i] = sum > 0 ? sum : 0.0f;
    }
}

void add(Tensor& x, const Tensor& y) {
    if (!x.same_shape(y)) fail("a sum of tensors of different shapes");
    for (std::size_t i = 0; i < x.size(); ++i) x.data()[i] += y.data()[i];
}

Tensor concatenate(const Tensor& a, const Tensor& b) {
    if (a.batch() != b.batch() || a.height() != b.height() || a.width() != b.width())
        fail("tensors of different sizes are joined");
    Tensor output = Tensor::uninitialised(a.batch(), a.channels() + b.channels(), a.height(), a.width());
    for (int n = 0; n < a.batch(); ++n) {
        std::copy_n(a.plane(n, 0), a.plane_size() * a.channels(), output.plane(n, 0));
        std::copy_n(b.plane(n, 0), b.plane_size() * b.channels(), output.plane(n, a.channels()));
    }
    return output;
}

// --- resizing --------------------------------------------------------------------------------------------

Tensor mirrored(const Tensor& input) {
    Tensor output = Tensor::uninitialised(input.batch(), input.channels(), input.height(), input.width());
    const auto width = static_cast<std::size_t>(input.width());
    for (std::size_t begin = 0; begin < input.size(); begin += width)
        std::reverse_copy(input.begin() + begin, input.begin() + begin + width, output.begin() + begin);
    return output;
}

namespace {

// Calls use(out, value) for the places of an image of `out`'s size, value = the nearest one of `input`.
template <class Use> void enlarge_nearest(const Tensor& input, Tensor& out, Use use) {
    if (input.plane_size() == 0 || out.plane_size() == 0) fail("an empty image is resized");
    const auto source = [](int place, int in, int size) {
        return static_cast<int>(static_cast<std::int64_t>(place) * in / size);
    };
    std::vector<int> columns;
    for (int x = 0; x < out.width(); ++x) columns.push_back(source(x, input.width(), out.width()));
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c)
            for (int y = 0; y < out.height(); ++y) {
                const float* in =
                    input.plane(n, c) +
                    static_cast<std::size_t>(source(y, input.height(), out.height())) * input.width();
                float* row = out.plane(n, c) + static_cast<std::size_t>(y) * out.width();
                for (int x = 0; x < out.width(); ++x) use(row[x], in[columns[x]]);
            }
}

} // namespace

Tensor resize_nearest(const Tensor& input, int height, int width) {
    if (height < 1 || width < 1) fail("an empty image is resized");
    Tensor output = Tensor::uninitialised(input.batch(), input.channels(), height, width);
    enlarge_nearest(input, output, [](float& out, float value) { out = value; });
    return output;
}

void add_nearest(Tensor& x, const Tensor& y) {
    if (x.batch() != y.batch() || x.channels() != y.channels()) fail("a sum of tensors of different shapes");
    enlarge_nearest(y, x, [](float& out, float value) { out += value; });
}

namespace {

// Where an output coordinate lies between two input coordinates. Pixel centres are at + ½.
struct Between {
    int first = 0, second = 0;
    float weight = 0; // of the second
};
std::vector<Between> places(int in, int out) {
    std::vector<Between> all(out);
    const float scale = static_cast<float>(in) / static_cast<float>(out);
    for (int i = 0; i < out; ++i) {
        const float place = std::max(0.0f, (static_cast<float>(i) + 0.5f) * scale - 0.5f);
        all[i].first = std::min(static_cast<int>(place), in - 1);
        all[i].second = std::min(all[i].first + 1, in - 1);
        all[i].weight = place - static_cast<float>(all[i].first);
    }
    return all;
}

void stretch_row(const float* in, const std::vector<Between>& columns, float* out) {
    for (std::size_t x = 0; x < columns.size(); ++x) {
        const Between& at = columns[x];
        out[x] = in[at.first] * (1 - at.weight) + in[at.second] * at.weight;
    }
}

} // namespace

Tensor resize_bilinear(const Tensor& input, int height, int width, const Runtime& runtime) {
    if (input.plane_size() == 0 || height < 1 || width < 1) fail("an empty image is resized");
    const std::vector<Between> rows = places(input.height(), height), columns = places(input.width(), width);
    Tensor output = Tensor::uninitialised(input.batch(), input.channels(), height, width);
    runtime.parallel_for(input.batch() * input.channels(), [&](int plane) {
        const float* in = input.data() + input.plane_size() * plane;
        float* out = output.data() + output.plane_size() * plane;
        // Two input rows, stretched to the new width, are kept: those around the current output row.
        std::vector<float> stretched[2] = {std::vector<float>(width), std::vector<float>(width)};
        int held[2] = {-1, -1};
        const auto row = [&](int y) {
            if (held[y % 2] != y)
                stretch_row(in + static_cast<std::size_t>(y) * input.width(), columns,
                            stretched[y % 2].data());
            held[y % 2] = y;
            return stretched[y % 2].data();
        };
        for (int y = 0; y < height; ++y, out += width) {
            const float *top = row(rows[y].first), *bottom = row(rows[y].second), weight = rows[y].weight;
            for (int x = 0; x < width; ++x) out[x] = top[x] * (1 - weight) + bottom[x] * weight;
        }
    });
    return output;
}

Tensor resize_corners(const Tensor& input, int height, int width) {
    if (input.plane_size() == 0 || height < 1 || width < 1) fail("an empty image is resized");
    Tensor output = Tensor::uninitialised(input.batch(), input.channels(), height, width);
    // The place x·(from − 1)/(to − 1) as its whole part and its fraction, the latter rounded once.
    struct Place {
        int low, high;
        float fraction;
    };
    const auto place = [](int at, int from, int to) {
        const std::int64_t steps = std::max(1, to - 1), along = static_cast<std::int64_t>(at) * (from - 1);
        const int low = static_cast<int>(along / steps);
        return Place{low, std::min(low + 1, from - 1),
                     static_cast<float>(along % steps) / static_cast<float>(steps)};
    };
    for (int n = 0; n < input.batch(); ++n)
        for (int c = 0; c < input.channels(); ++c)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const Place v = place(y, input.height(), height), h = place(x, input.width(), width);
                    const float above = input(n, c, v.low, h.low) * (1 - h.fraction) +
                                        input(n, c, v.low, h.high) * h.fraction;
                    const float below = input(n, c, v.high, h.low) * (1 - h.fraction) +
                                        input(n, c, v.high, h.high) * h.fraction;
                    output(n, c, y, x) = above * (1 - v.fraction) + below * v.fraction;
                }
    return output;
}

// --- probabilities ---------------------------------------------------------------------------------------

Tensor sigmoid(const Tensor& logits) {
    Tensor output = logits;
    for (float& x : output) x = static_cast<float>(1 / (1 + math::exp(-static_cast<double>(x))));
    return output;
}

Tensor softmax(const Tensor& logits, const Runtime& runtime) {
    Tensor output = Tensor::uninitialised(logits.batch(), logits.channels(), logits.height(), logits.width());
    const std::size_t size = logits.plane_size();
    const int channels = logits.channels();
    runtime.parallel_for(logits.batch() * logits.height(), [&](int task) {
        const int n = task / logits.height();
        const std::size_t begin = static_cast<std::size_t>(task % logits.height()) * logits.width();
        std::vector<double> powers(channels);
        for (int x = 0; x < logits.width(); ++x) {
            const float* in = logits.plane(n, 0) + begin + x;
            float largest = in[0];
            for (int c = 1; c < channels; ++c) largest = std::max(largest, in[size * c]);
            double sum = 0;
            for (int c = 0; c < channels; ++c) {
                powers[c] = math::exp(static_cast<double>(in[size * c]) - largest);
                sum += powers[c];
            }
            for (int c = 0; c < channels; ++c)
                output.plane(n, c)[begin + x] = static_cast<float>(powers[c] / sum);
        }
    });
    return output;
}

} // namespace pantin::network
