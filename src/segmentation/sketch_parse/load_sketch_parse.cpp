// SPDX-License-Identifier: MIT
// From the authors' state dictionary to the modules: Scale<n>.conv1, bn1, layer1 … layer4,
// layer4_5_r<expert>, layer5_r<expert>.conv2d_list.<i>, pose_r<expert>.PoseC1.<0|2|4>,
// pose_r<expert>.PoseC2.0; our addition: router.
#include "network/layer_reader.hpp"
#include "segmentation/sketch_parse/sketch_parse.hpp"

namespace pantin::sketch_parse {
namespace {

using network::ConvolutionOptions;
using network::LayerReader;
using network::ResidualBlock;

constexpr int max_scales = 3;
constexpr int layer_strides[] = {1, 2, 1, 1}, layer_dilations[] = {1, 1, 2, 4};
constexpr int classifier_dilations[] = {6, 12, 18, 24};

ConvolutionOptions options_of(int padding, int dilation, int stride, bool relu) {
    ConvolutionOptions options;
    options.padding = padding;
    options.dilation = dilation;
    options.stride = stride;
    options.relu = relu;
    return options;
}

// The first 1×1 convolution takes the stride, as in the first ResNets.
ResidualBlock read_bottleneck(const LayerReader& reader, const std::string& name, int in, int stride,
                              int dilation) {
    ResidualBlock block;
    block.branch.push_back(
        reader.convolution(name + ".conv1", name + ".bn1", in, options_of(0, 1, stride, true)));
    const int width = block.branch[0].out_channels();
    block.branch.push_back(
        reader.convolution(name + ".conv2", name + ".bn2", width, options_of(dilation, dilation, 1, true)));
    block.branch.push_back(reader.convolution(name + ".conv3", name + ".bn3", block.branch[1].out_channels(),
                                              options_of(0, 1, 1, false)));
    const std::string downsample = name + ".downsample";
    if (reader.file.contains(downsample + ".0.weight"))
        block.downsample =
            reader.convolution(downsample + ".0", downsample + ".1", in, options_of(0, 1, stride, false));
    const int shortcut = block.downsample ? block.downsample->out_channels() : in;
    if (shortcut != block.out_channels() || (!block.downsample && stride > 1))
        reader.file.fail("the shortcut of '" + name + "' does not fit its branch");
    return block;
}

Scale read_scale(const LayerReader& reader, const std::string& name) {
    Scale scale{{reader.convolution(name + "conv1", name + "bn1", 3, options_of(3, 1, 2, true)), {}}, {}};
    int width = scale.trunk.stem.out_channels();
    for (int l = 0; l < 4; ++l) {
        std::vector<ResidualBlock> blocks;
        for (int b = 0;; ++b) {
            const std::string block = name + "layer" + std::to_string(l + 1) + "." + std::to_string(b);
            if (!reader.file.contains(block + ".conv1.weight")) break;
            blocks.push_back(
                read_bottleneck(reader, block, width, b == 0 ? layer_strides[l] : 1, layer_dilations[l]));
            width = blocks.back().out_channels();
        }
        scale.trunk.layers.push_back(std::move(blocks));
    }
    for (int e = 0;; ++e) {
        const std::string number = "_r" + std::to_string(e);
        if (!reader.file.contains(name + "layer4_5" + number + ".0.conv1.weight")) break;
        Expert expert{read_bottleneck(reader, name + "layer4_5" + number + ".0", width, 1, 4), {}};
        for (int i = 0; i < 4; ++i) {
            const int d = classifier_dilations[i];
            expert.classifiers.push_back(
                reader.convolution(name + "layer5" + number + ".conv2d_list." + std::to_string(i), "",
                                   expert.bottleneck.out_channels(), options_of(d, d, 1, false)));
            if (expert.classifiers[i].out_channels() != expert.classifiers[0].out_channels())
                reader.file.fail("the classifiers of '" + name + "layer5" + number +
                                 "' have different widths");
        }
        scale.experts.push_back(std::move(expert));
    }
    if (scale.experts.empty()) reader.file.fail("tensor '" + name + "layer4_5_r0.0.conv1.weight' is missing");
    return scale;
}

PoseHead read_pose(const LayerReader& reader, const std::string& name, int parts) {
    std::vector<Convolution> convs;
    int width = parts;
    for (int i = 0; i < 3; ++i) {
        const ConvolutionOptions options = i < 2 ? options_of(1, 2, 2, true) : options_of(0, 1, 1, true);
        convs.push_back(reader.convolution(name + ".PoseC1." + std::to_string(2 * i), "", width, options));
        width = convs.back().out_channels();
    }
    const int values = reader.extent(name + ".PoseC2.0.weight", 2, 1);
    return {std::move(convs), reader.linear(name + ".PoseC2.0", values)};
}

void require_alike(const WeightFile& file, const Scale& a, const Scale& b) {
    bool alike = a.experts.size() == b.experts.size();
    for (std::size_t e = 0; alike && e < a.experts.size(); ++e)
        alike = a.experts[e].classifiers[0].out_channels() == b.experts[e].classifiers[0].out_channels();
    if (!alike) file.fail("the scales have different experts");
}

} // namespace

Network load_network(const WeightFile& file) {
    const LayerReader reader{file};
    Network network;
    for (int s = 1; s <= max_scales; ++s) {
        const std::string name = "Scale" + std::to_string(s) + ".";
        if (s > 1 && !file.contains(name + "conv1.weight")) break;
        network.scales.push_back(read_scale(reader, name));
        require_alike(file, network.scales[0], network.scales.back());
    }
    const std::vector<Expert>& experts = network.scales[0].experts;
    if (file.contains("router.weight")) {
        const std::vector<network::ResidualBlock>& last = network.scales[0].trunk.layers.back();
        const int width = last.empty() ? reader.extent("router.weight", 2, 1) : last.back().out_channels();
        network.router.emplace(reader.linear("router", width));
        if (reader.extent("router.weight", 2, 0) != static_cast<int>(experts.size()))
            file.fail("tensor 'router.weight' has another number of experts than the scales");
    }
    for (std::size_t e = 0; e < experts.size() && file.contains("pose_r0.PoseC1.0.weight"); ++e)
        network.pose.push_back(
            read_pose(reader, "pose_r" + std::to_string(e), experts[e].classifiers[0].out_channels()));
    return network;
}

} // namespace pantin::sketch_parse
