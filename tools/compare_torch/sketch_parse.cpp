// SPDX-License-Identifier: MIT
// SketchParse, each module fed with what PyTorch's module got.
#include "segmentation/sketch_parse/sketch_parse.hpp"

#include "compare_torch/trace.hpp"

namespace pantin::compare {

using network::Tensor;

std::vector<Difference> compare_sketch_parse(const network::WeightFile& weights,
                                             const network::WeightFile& trace, int threads) {
    const sketch_parse::Network network = sketch_parse::load_network(weights);
    const network::Runtime runtime(threads);
    const Tensor image = read_tensor(trace, "image");
    const int expert = static_cast<int>(trace.read("expert", {1})[0]);
    std::vector<Difference> differences;
    const auto add = [&](const std::string& name, const Tensor& ours) {
        differences.push_back(compare(trace, name, ours));
    };

    for (std::size_t s = 0; s < network.scales.size(); ++s) {
        const std::string number = std::to_string(s);
        Tensor input = image;
        if (s > 0) {
            input = read_tensor(trace, "input" + number);
            add("input" + number, network::resize_corners(image, input.height(), input.width()));
        }
        add("shared" + number, network.scales[s].trunk.forward(input, runtime));
        const Tensor theirs = read_tensor(trace, "scale" + number);
        const Tensor scores = network.scales[s].experts[static_cast<std::size_t>(expert)].forward(
            read_tensor(trace, "shared" + number), runtime);
        add("scale" + number,
            s == 0 ? scores : network::resize_corners(scores, theirs.height(), theirs.width()));
    }
    add("pose",
        network.pose[static_cast<std::size_t>(expert)].forward(read_tensor(trace, "scores"), runtime));

    const sketch_parse::Result whole = network.forward(image, runtime);
    add("router", whole.router);
    add("scores", whole.scores);
    differences.back().what += ", end to end";
    add("pose", whole.pose);
    differences.back().what += ", end to end";
    return differences;
}

} // namespace pantin::compare
