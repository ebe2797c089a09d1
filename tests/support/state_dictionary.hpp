// SPDX-License-Identifier: MIT
// State dictionaries of PyTorch with random values, as weight files: the layers of the published networks at
// any width and depth, by their tensor names.
#pragma once

#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace pantin::test {

class StateDictionary {
public:
    explicit StateDictionary(std::uint64_t seed) : random_(seed) {}

    void convolution(const std::string& name, int out, int in, int kernel, bool bias = false,
                     double scale = 1) {
        weights(name + ".weight", {out, in, kernel, kernel}, in * kernel * kernel, scale);
        if (bias) uniform(name + ".bias", {out}, -0.1, 0.1);
    }
    void linear(const std::string& name, int out, int in, double scale = 1) {
        weights(name + ".weight", {out, in}, in, scale);
        uniform(name + ".bias", {out}, -0.1, 0.1);
    }
    void normalisation(const std::string& name, int width, double gain = 1) {
        uniform(name + ".weight", {width}, 0.5 * gain, gain);
        uniform(name + ".bias", {width}, -0.1, 0.1);
        uniform(name + ".running_mean", {width}, -0.1, 0.1);
        uniform(name + ".running_var", {width}, 0.5, 1.5);
    }
    // Of a ResNet of depth 50 and more; the third normalisation is small so that sums do not grow.
    void bottleneck(const std::string& name, int in, int width, bool downsample) {
        convolution(name + ".conv1", width, in, 1);
        convolution(name + ".conv2", width, width, 3);
        convolution(name + ".conv3", 4 * width, width, 1);
        for (const int i : {1, 2}) normalisation(name + ".bn" + std::to_string(i), width);
        normalisation(name + ".bn3", 4 * width, 0.3);
        if (!downsample) return;
        convolution(name + ".downsample.0", 4 * width, in, 1);
        normalisation(name + ".downsample.1", 4 * width);
    }
    // `layer1` … `layer4` behind the stem; widths double from layer to layer. Returns the channels at the
    // end.
    int layers(const std::string& prefix, int width, const std::vector<int>& blocks) {
        int in = width;
        for (std::size_t l = 0; l < blocks.size(); ++l, width *= 2)
            for (int b = 0; b < blocks[l]; ++b) {
                bottleneck(prefix + "layer" + std::to_string(l + 1) + "." + std::to_string(b), in, width,
                           b == 0);
                in = 4 * width;
            }
        return in;
    }

    // safetensors: 8 bytes length, the header, the values (docs/formats.md, "Weights").
    std::vector<unsigned char> file(const std::map<std::string, std::string>& metadata) const {
        std::string header = "{\"__metadata__\":{", values;
        for (const auto& [key, value] : metadata)
            header += (header.back() == '{' ? "\"" : ",\"") + key + "\":\"" + value + "\"";
        header += '}';
        for (const auto& [name, tensor] : tensors_) {
            std::string shape;
            for (const int extent : tensor.shape)
                shape += (shape.empty() ? "" : ",") + std::to_string(extent);
            const std::size_t begin = values.size(), bytes = tensor.values.size() * sizeof(float);
            values.resize(begin + bytes);
            std::memcpy(values.data() + begin, tensor.values.data(), bytes);
            header += ",\"" + name + "\":{\"dtype\":\"F32\",\"shape\":[" + shape + "],\"data_offsets\":[" +
                      std::to_string(begin) + "," + std::to_string(begin + bytes) + "]}";
        }
        header += '}';
        header.resize((header.size() + 7) / 8 * 8, ' ');
        std::vector<unsigned char> file;
        for (int i = 0; i < 8; ++i) file.push_back(static_cast<unsigned char>(header.size() >> (8 * i)));
        file.insert(file.end(), header.begin(), header.end());
        file.insert(file.end(), values.begin(), values.end());
        return file;
    }

private:
    struct Stored {
        std::vector<int> shape;
        std::vector<float> values;
    };
    Random random_;
    std::map<std::string, Stored> tensors_;

    void uniform(const std::string& name, const std::vector<int>& shape, double low, double high) {
        std::size_t count = 1;
        for (const int extent : shape) count *= static_cast<std::size_t>(extent);
        Stored tensor{shape, std::vector<float>(count)};
        for (float& value : tensor.values) value = static_cast<float>(random_.uniform(low, high));
        tensors_[name] = std::move(tensor);
    }
    // Variance 2 / fan, so that activations neither vanish nor explode (He et al. 2015).
    void weights(const std::string& name, const std::vector<int>& shape, int fan, double scale) {
        const double reach = scale * std::sqrt(6.0 / fan);
        uniform(name, shape, -reach, reach);
    }
};

// torchvision's maskrcnn_resnet50_fpn with two classes: its depth and tensor names, a sixteenth of its width.
inline StateDictionary narrow_mask_rcnn() {
    StateDictionary state(5);
    constexpr int width = 4, pyramid = 16, hidden = 32;
    const std::string body = "backbone.body.", fpn = "backbone.fpn.", heads = "roi_heads.";
    state.convolution(body + "conv1", width, 3, 7);
    state.normalisation(body + "bn1", width);
    state.layers(body, width, {3, 4, 6, 3});
    for (int i = 0; i < 4; ++i) {
        state.convolution(fpn + "inner_blocks." + std::to_string(i) + ".0", pyramid, 4 * width << i, 1, true);
        state.convolution(fpn + "layer_blocks." + std::to_string(i) + ".0", pyramid, pyramid, 3, true);
        state.convolution(heads + "mask_head." + std::to_string(i) + ".0", pyramid, pyramid, 3, true);
    }
    state.convolution("rpn.head.conv.0.0", pyramid, pyramid, 3, true);
    state.convolution("rpn.head.cls_logits", 3, pyramid, 1, true, 0.2);
    state.convolution("rpn.head.bbox_pred", 12, pyramid, 1, true, 0.02);
    state.linear(heads + "box_head.fc6", hidden, 49 * pyramid);
    state.linear(heads + "box_head.fc7", hidden, hidden);
    state.linear(heads + "box_predictor.cls_score", 2, hidden, 0.2);
    state.linear(heads + "box_predictor.bbox_pred", 8, hidden, 0.02);
    state.convolution(heads + "mask_predictor.conv5_mask", pyramid, pyramid, 2, true);
    state.convolution(heads + "mask_predictor.mask_fcn_logits", 2, pyramid, 1, true);
    return state;
}

// SketchParse with the thesis's two experts and ResNet-50's depth (ERRATA 32 to 34), a thirty-second of its
// width.
inline StateDictionary narrow_sketch_parse() {
    StateDictionary state(6);
    constexpr int width = 2;
    const std::vector<int> parts = {5, 6};
    for (int s = 1; s <= 3; ++s) {
        const std::string scale = "Scale" + std::to_string(s) + ".";
        state.convolution(scale + "conv1", width, 3, 7, false, 0.02); // grey values up to 255
        state.normalisation(scale + "bn1", width);
        const int channels = state.layers(scale, width, {3, 4, 6, 2}); // the last block is the expert's
        for (std::size_t e = 0; e < parts.size(); ++e) {
            const std::string number = "_r" + std::to_string(e);
            state.bottleneck(scale + "layer4_5" + number + ".0", channels, channels / 4, false);
            for (int i = 0; i < 4; ++i)
                state.convolution(scale + "layer5" + number + ".conv2d_list." + std::to_string(i), parts[e],
                                  channels, 3, true);
        }
        if (s == 1) state.linear("router", static_cast<int>(parts.size()), channels);
    }
    for (std::size_t e = 0; e < parts.size(); ++e) {
        const std::string pose = "pose_r" + std::to_string(e) + ".";
        state.convolution(pose + "PoseC1.0", 6, parts[e], 3, true);
        state.convolution(pose + "PoseC1.2", 4, 6, 3, true);
        state.convolution(pose + "PoseC1.4", 4, 4, 9, true); // 9 × 9 of the 41 × 41 scores are left
        state.linear(pose + "PoseC2.0", 8, 4);
    }
    return state;
}

} // namespace pantin::test
