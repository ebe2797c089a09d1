// Fully connected layers: the kernel with the roles turned round. The outputs take the place of the pixels,
// the samples of the batch that of the filters; the chain runs over the inputs as everywhere.
#include <algorithm>

#include "network/variant.hpp"
#include "pantin/error.hpp"

namespace pantin::network {

Linear::Linear(int out, int in, const std::vector<float>& weights, std::vector<float> bias)
    : out_(out), in_(in), bias_(std::move(bias)) {
    if (out < 1 || in < 1 || weights.size() != static_cast<std::size_t>(out) * in ||
        bias_.size() != static_cast<std::size_t>(out))
        throw Error(ErrorKind::weights, "network: a linear layer whose weights do not fit its shape");
    row_ = (static_cast<std::size_t>(out) + max_vector_width - 1) / max_vector_width * max_vector_width;
    transposed_.assign(row_ * in, 0.0f);
    for (int o = 0; o < out; ++o)
        for (int i = 0; i < in; ++i)
            transposed_[row_ * i + o] = weights[static_cast<std::size_t>(o) * in + i];
    bias_.resize(row_, 0.0f);
}

Tensor Linear::forward(const Tensor& input, const Runtime& runtime) const {
    const std::size_t features = static_cast<std::size_t>(input.channels()) * input.plane_size();
    if (features != static_cast<std::size_t>(in_))
        throw Error(ErrorKind::weights,
                    "network: a linear layer gets another number of values than it has weights for");
    const Kernel& kernel = kernel_of(runtime.simd());
    Tensor output(input.batch(), out_, 1, 1);
    constexpr int outputs_per_task = 256;
    const int chunks = (out_ + outputs_per_task - 1) / outputs_per_task;
    const int blocks = (input.batch() + max_rows - 1) / max_rows;
    const std::ptrdiff_t tap = 0;

    runtime.parallel_for(chunks * blocks, [&](int task) {
        const int first_sample = task % blocks * max_rows, first_out = task / blocks * outputs_per_task;
        const int rows = std::min(max_rows, input.batch() - first_sample);
        const int outputs = std::min<int>(outputs_per_task, static_cast<int>(row_) - first_out);
        std::vector<float> samples(static_cast<std::size_t>(in_) * rows); // [in][rows]
        for (int r = 0; r < rows; ++r)
            for (int i = 0; i < in_; ++i)
                samples[static_cast<std::size_t>(i) * rows + r] = input.plane(first_sample + r, 0)[i];
        std::vector<float> results(static_cast<std::size_t>(rows) * outputs);
        for (int r = 0; r < rows; ++r)
            std::copy_n(bias_.begin() + first_out, outputs,
                        results.begin() + static_cast<std::ptrdiff_t>(r) * outputs);
        std::vector<std::ptrdiff_t> bases;
        for (int o = 0; o < outputs; o += kernel.width) bases.push_back(first_out + o);
        kernel.run({transposed_.data(), row_, in_, &tap, 1, samples.data(), nullptr, rows, bases.data(),
                    static_cast<int>(bases.size()), results.data(), static_cast<std::size_t>(outputs),
                    false});
        for (int r = 0; r < rows; ++r)
            std::copy_n(results.begin() + static_cast<std::ptrdiff_t>(r) * outputs,
                        std::min(outputs, out_ - first_out), output.plane(first_sample + r, first_out));
    });
    return output;
}

} // namespace pantin::network
