// SPDX-License-Identifier: MIT
// Our networks against PyTorch's, module by module. A trace is a safetensors file with the input and output
// of every module in one pass of PyTorch (tools/compare_torch.py writes it); each of our modules is fed with
// PyTorch's own input.
#pragma once

#include <string>
#include <vector>

#include "pantin/network.hpp"

namespace pantin::compare {

struct Difference {
    std::string what;      // the tensor's name in the trace
    std::string shape;     // ours
    double absolute = 0;   // largest |ours − theirs|; infinity when the shapes differ
    double relative = 0;   // the same as a share of the tensor's largest |theirs|
    double allowed = 1e-4; // of the relative difference, or of the absolute one
    bool by_absolute = false;
    bool agrees() const { return (by_absolute ? absolute : relative) <= allowed; }
};

// A tensor of the trace with up to 4 dimensions: [channels, height, width] gets a batch of 1, [rows, columns]
// becomes [rows, columns, 1, 1].
network::Tensor read_tensor(const network::WeightFile& trace, const std::string& name);

Difference compare(const network::WeightFile& trace, const std::string& name, const network::Tensor& ours);

std::vector<Difference> compare_mask_rcnn(const network::WeightFile& weights,
                                          const network::WeightFile& trace, int threads);
std::vector<Difference> compare_sketch_parse(const network::WeightFile& weights,
                                             const network::WeightFile& trace, int threads);

} // namespace pantin::compare
