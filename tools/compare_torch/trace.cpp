// SPDX-License-Identifier: MIT
// A tensor of PyTorch's trace against ours: largest absolute and relative difference.
#include "compare_torch/trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pantin::compare {

using network::Tensor;

namespace {

std::string shape_of(const Tensor& t) {
    return std::to_string(t.batch()) + "×" + std::to_string(t.channels()) + "×" + std::to_string(t.height()) +
           "×" + std::to_string(t.width());
}

} // namespace

Tensor read_tensor(const network::WeightFile& trace, const std::string& name) {
    const std::vector<std::int64_t> shape = trace.shape(name);
    std::vector<std::int64_t> extents = shape;
    if (extents.size() == 3) extents.insert(extents.begin(), 1);
    extents.resize(4, 1);
    Tensor tensor(static_cast<int>(extents[0]), static_cast<int>(extents[1]), static_cast<int>(extents[2]),
                  static_cast<int>(extents[3]));
    const std::vector<float> values = trace.read(name, shape);
    std::copy(values.begin(), values.end(), tensor.begin());
    return tensor;
}

Difference compare(const network::WeightFile& trace, const std::string& name, const Tensor& ours) {
    const Tensor theirs = read_tensor(trace, name);
    Difference difference{.what = name, .shape = shape_of(ours)};
    if (!ours.same_shape(theirs)) {
        difference.shape += " instead of " + shape_of(theirs);
        difference.absolute = difference.relative = std::numeric_limits<double>::infinity();
        return difference;
    }
    double largest = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double value = theirs.data()[i];
        largest = std::max(largest, std::abs(value));
        difference.absolute = std::max(difference.absolute, std::abs(ours.data()[i] - value));
    }
    difference.relative = difference.absolute > 0 ? difference.absolute / largest : 0;
    return difference;
}

} // namespace pantin::compare
