// SPDX-License-Identifier: MIT
// From the weight file to the network's modules. Tensor names are those of torchvision's state dictionary.
#include <charconv>

#include "detection/mask_rcnn/mask_rcnn.hpp"
#include "network/layer_reader.hpp"

namespace pantin::mask_rcnn {
namespace {

using network::ConvolutionOptions;

constexpr float max_number = 1e6f;

// --- options ---------------------------------------------------------------------------------------------

// Numbers separated by commas; `values` stays as it is when the metadata does not have the key.
void read_numbers(const WeightFile& file, const std::string& key, std::vector<float>& values) {
    if (!file.has_metadata(key)) return;
    const std::string& text = file.metadata(key);
    values.clear();
    for (const char *at = text.data(), *end = at + text.size(); at < end; ++at) {
        float value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || (next != end && *next != ',') || !(value > -max_number) ||
            !(value < max_number))
            file.fail("metadata '" + key + "' is no list of numbers");
        values.push_back(value);
        at = next;
    }
    if (values.empty()) file.fail("metadata '" + key + "' is empty");
}

template <class Number>
void read_number(const WeightFile& file, const std::string& key, Number& value, float least, float most) {
    std::vector<float> values = {static_cast<float>(value)};
    read_numbers(file, key, values);
    if (values.size() != 1 || values[0] < least || values[0] > most)
        file.fail("metadata '" + key + "' has the impossible value '" + file.metadata(key) + "'");
    value = static_cast<Number>(values[0]);
}

Options read_options(const WeightFile& file) {
    Options options;
    read_number(file, "min_size", options.transform.shorter, 16, 4096);
    read_number(file, "max_size", options.transform.longer, 16, 4096);
    read_numbers(file, "image_mean", options.transform.mean);
    read_numbers(file, "image_std", options.transform.deviation);
    if (options.transform.mean.size() != options.transform.deviation.size())
        file.fail("metadata 'image_mean' and 'image_std' have different lengths");
    for (const float deviation : options.transform.deviation)
        if (!(deviation > 0)) file.fail("metadata 'image_std' must be positive");
    read_numbers(file, "anchor_sizes", options.proposals.sizes);
    for (const float size : options.proposals.sizes)
        if (!(size > 0)) file.fail("metadata 'anchor_sizes' must be positive");
    read_numbers(file, "anchor_ratios", options.proposals.ratios);
    for (const float ratio : options.proposals.ratios)
        if (!(ratio > 0)) file.fail("metadata 'anchor_ratios' must be positive");
    read_number(file, "rpn_pre_nms_top_n", options.proposals.per_level, 1, 10000);
    read_number(file, "rpn_post_nms_top_n", options.proposals.total, 1, 10000);
    read_number(file, "rpn_nms_thresh", options.proposals.overlap, 0, 1);
    read_number(file, "box_score_thresh", options.detection.score, 0, 1);
    read_number(file, "box_nms_thresh", options.detection.overlap, 0, 1);
    read_number(file, "box_detections_per_img", options.detection.most, 1, 1000);
    read_number(file, "box_roi_pool", options.detection.box_pool, 1, 64);
    read_number(file, "mask_roi_pool", options.detection.mask_pool, 1, 64);
    read_number(file, "canonical_scale", options.detection.canonical_size, 1, 4096);
    return options;
}

// --- modules ---------------------------------------------------------------------------------------------

ConvolutionOptions same_size(int kernel, bool relu, int stride = 1) {
    ConvolutionOptions options;
    options.padding = kernel / 2;
    options.stride = stride;
    options.relu = relu;
    return options;
}

template <class A>
network::BasicResidualBlock<A> read_block(const typename A::Reader& reader, const std::string& name, int in,
                                          int stride) {
    const bool bottleneck = reader.file.contains(name + ".conv3.weight");
    const int convs = bottleneck ? 3 : 2, strided = bottleneck ? 2 : 1; // the 3×3 takes the stride
    network::BasicResidualBlock<A> block;
    int width = in;
    for (int i = 1; i <= convs; ++i) {
        const std::string number = std::to_string(i), conv = name + ".conv" + number;
        const ConvolutionOptions options =
            same_size(reader.extent(conv + ".weight", 4, 2), i < convs, i == strided ? stride : 1);
        const std::string norm = name + ".bn" + number;
        block.branch.push_back(i == convs ? reader.adding_convolution(conv, norm, width, options)
                                          : reader.convolution(conv, norm, width, options));
        width = block.branch.back().out_channels();
    }
    const std::string downsample = name + ".downsample";
    if (reader.file.contains(downsample + ".0.weight"))
        block.downsample =
            reader.convolution(downsample + ".0", downsample + ".1", in, same_size(1, false, stride));
    if ((block.downsample ? block.downsample->out_channels() : in) != width ||
        (!block.downsample && stride > 1))
        reader.file.fail("the shortcut of '" + name + "' does not fit its branch");
    return block;
}

template <class A> ResNet<A> read_backbone(const typename A::Reader& reader, int channels) {
    const std::string body = "backbone.body.";
    const int kernel = reader.extent(body + "conv1.weight", 4, 2);
    ResNet<A> net{reader.convolution(body + "conv1", body + "bn1", channels, same_size(kernel, true, 2)), {}};
    int width = net.stem.out_channels();
    for (int l = 1; reader.file.contains(body + "layer" + std::to_string(l) + ".0.conv1.weight"); ++l) {
        std::vector<network::BasicResidualBlock<A>> blocks;
        for (int b = 0;; ++b) {
            const std::string name = body + "layer" + std::to_string(l) + "." + std::to_string(b);
            if (!reader.file.contains(name + ".conv1.weight")) break;
            blocks.push_back(read_block<A>(reader, name, width, b == 0 && l > 1 ? 2 : 1));
            width = blocks.back().out_channels();
        }
        net.layers.push_back(std::move(blocks));
    }
    return net;
}

template <class A>
FeaturePyramid<A> read_pyramid(const typename A::Reader& reader, const ResNet<A>& backbone) {
    FeaturePyramid<A> pyramid;
    for (std::size_t i = 0; i < backbone.layers.size(); ++i) {
        const std::string number = std::to_string(i) + ".0", fpn = "backbone.fpn.";
        const int in = backbone.layers[i].back().out_channels();
        const std::string inner = fpn + "inner_blocks." + number;
        pyramid.inner.push_back(i + 1 < backbone.layers.size()
                                    ? reader.adding_convolution(inner, "", in, same_size(1, false))
                                    : reader.convolution(inner, "", in, same_size(1, false)));
        const int width = pyramid.inner.back().out_channels();
        pyramid.layer.push_back(
            reader.convolution(fpn + "layer_blocks." + number, "", width, same_size(3, false)));
        if (width != pyramid.inner[0].out_channels() || width != pyramid.layer.back().out_channels())
            reader.file.fail("the levels of the feature pyramid have different widths");
    }
    return pyramid;
}

template <class A>
ProposalHead<A> read_proposal_head(const typename A::Reader& reader, int width, std::size_t anchors) {
    ProposalHead<A> head{reader.convolution("rpn.head.conv.0.0", "", width, same_size(3, true)),
                         reader.convolution("rpn.head.cls_logits", "", width, same_size(1, false)),
                         reader.convolution("rpn.head.bbox_pred", "", width, same_size(1, false))};
    if (head.logits.out_channels() != static_cast<int>(anchors) ||
        head.displacements.out_channels() != 4 * static_cast<int>(anchors))
        reader.file.fail("the proposal head has another number of anchors than metadata 'anchor_ratios'");
    return head;
}

template <class A> BoxHead<A> read_box_head(const typename A::Reader& reader, int width, int pool) {
    const std::string head = "roi_heads.box_head.", predictor = "roi_heads.box_predictor.";
    const int hidden = reader.extent(head + "fc6.weight", 2, 0),
              last = reader.extent(head + "fc7.weight", 2, 0);
    const int classes = reader.extent(predictor + "cls_score.weight", 2, 0);
    if (classes < 2 || reader.extent(predictor + "bbox_pred.weight", 2, 0) != 4 * classes)
        reader.file.fail("the box predictor needs two classes or more and four displacements for each");
    return {reader.linear(head + "fc6", width * pool * pool, pool * pool),
            reader.linear(head + "fc7", hidden), reader.linear(predictor + "cls_score", last),
            reader.linear(predictor + "bbox_pred", last)};
}

template <class A> MaskHead<A> read_mask_head(const typename A::Reader& reader, int width, int classes) {
    std::vector<typename A::Convolution> convs;
    for (int i = 0;; ++i) {
        const std::string name = "roi_heads.mask_head." + std::to_string(i) + ".0";
        if (!reader.file.contains(name + ".weight")) break;
        convs.push_back(reader.convolution(name, "", width, same_size(3, true)));
        width = convs.back().out_channels();
    }
    if (convs.empty()) reader.file.fail("tensor 'roi_heads.mask_head.0.0.weight' is missing");
    const std::string predictor = "roi_heads.mask_predictor.";
    const int middle = reader.extent(predictor + "conv5_mask.weight", 4, 1);
    ConvolutionOptions doubling;
    doubling.stride = 2;
    doubling.relu = true;
    MaskHead<A> head{std::move(convs),
                     reader.transposed_convolution(predictor + "conv5_mask", width, doubling),
                     reader.convolution(predictor + "mask_fcn_logits", "", middle, same_size(1, false))};
    if (head.logits.out_channels() != classes)
        reader.file.fail("the mask predictor has another number of classes than the box predictor");
    return head;
}

} // namespace

template <class A> BasicNetwork<A> load_network(const WeightFile& file) {
    if (network::holds_integers(file) != std::is_same_v<A, network::IntegerArithmetic>)
        file.fail("the layers are of another arithmetic");
    typename A::Reader reader{file};
    if (file.has_metadata("norm_epsilon")) {
        std::vector<float> epsilon;
        read_numbers(file, "norm_epsilon", epsilon);
        if (epsilon.size() != 1 || epsilon[0] < 0) file.fail("metadata 'norm_epsilon' is no epsilon");
        reader.epsilon = epsilon[0];
    }
    Options options = read_options(file);
    const int channels = static_cast<int>(options.transform.mean.size());
    ResNet<A> backbone = read_backbone<A>(reader, channels);
    if (backbone.layers.empty()) file.fail("tensor 'backbone.body.layer1.0.conv1.weight' is missing");
    if (options.proposals.sizes.size() != backbone.layers.size() + 1)
        file.fail("metadata 'anchor_sizes' needs one size for each of the " +
                  std::to_string(backbone.layers.size() + 1) + " levels");
    FeaturePyramid<A> pyramid = read_pyramid<A>(reader, backbone);
    const int width = pyramid.layer[0].out_channels();
    ProposalHead<A> proposal_head = read_proposal_head<A>(reader, width, options.proposals.ratios.size());
    BoxHead<A> box_head = read_box_head<A>(reader, width, options.detection.box_pool);
    const int classes = reader.extent("roi_heads.box_predictor.cls_score.weight", 2, 0);
    MaskHead<A> mask_head = read_mask_head<A>(reader, width, classes);
    return {std::move(options),       std::move(backbone), std::move(pyramid),
            std::move(proposal_head), std::move(box_head), std::move(mask_head)};
}

template BasicNetwork<network::RealArithmetic> load_network(const WeightFile&);
template BasicNetwork<network::IntegerArithmetic> load_network(const WeightFile&);

} // namespace pantin::mask_rcnn
